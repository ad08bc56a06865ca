//! Camera sites: good views, of different kinds, unlike one another.
//!
//! Candidates stand beside lanes, at stop lines and crossings, and hang on walls; each is judged by what its picture
//! shows (`judge`) on a field of heights (`relief`); the best are taken one after another, each discounted by its
//! likeness to those taken before.

mod candidate;
mod judge;
mod raster;
mod relief;
mod things;

use candidate::{Candidate, View, between};
use endless_road::RoadNetwork;
use endless_world::CameraSite;
use endless_world::math::f64::{atan2, wrap_angle};
use glam::{DVec2, Vec3};
use judge::{Judge, Seen};
use rayon::prelude::*;

pub(crate) use relief::Relief;
pub(crate) use things::Things;

/// A building as sight sees it: a prism.
#[derive(Debug, Clone)]
pub(crate) struct Solid {
    /// Counter-clockwise.
    pub(crate) outline: Vec<DVec2>,
    pub(crate) base: f64,
    pub(crate) top: f64,
}

/// A square or a park.
#[derive(Debug, Clone)]
pub(crate) struct Open {
    pub(crate) outline: Vec<DVec2>,
    pub(crate) park: bool,
}

/// Something that stands in the street.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Post {
    pub(crate) foot: Vec3,
    /// Its height, metres.
    pub(crate) height: f32,
}

/// What the cameras of a town are chosen for.
pub(crate) struct Scene<'a> {
    pub(crate) network: &'a RoadNetwork,
    pub(crate) relief: &'a Relief,
    pub(crate) solids: &'a [Solid],
    pub(crate) open: &'a [Open],
    /// Lamp posts, masts, signs.
    pub(crate) posts: Vec<Post>,
    /// Parked vehicles.
    pub(crate) parked: Vec<Vec3>,
}

/// Cameras a town gets, where it has that many places.
const WANTED: usize = 10;
/// Cameras it must have, even if the views are modest.
const LEAST: usize = 5;
/// Views that are not good enough, taken where a map has no better: their worth, and what they must show of pavement.
const MODEST: f32 = 0.02;
const MODEST_PAVED: f32 = 0.27;
/// Most cameras of one kind.
const MOST: [(View, usize); 10] = [
    (View::Approach, 2),
    (View::Arm, 2),
    (View::Corner, 1),
    (View::Crossing, 2),
    (View::Street, 2),
    (View::Highway, 2),
    (View::Rural, 2),
    (View::Wall, 2),
    (View::Square, 2),
    (View::Park, 1),
];
/// A town that has places of these kinds has a camera there.
const COVERED: [View; 5] = [View::Approach, View::Highway, View::Rural, View::Square, View::Park];
/// The worth of a view below which it is not taken once a town has enough.
const WORTH: f32 = 1.4;

/// A candidate with what it shows.
struct Judged {
    candidate: Candidate,
    seen: Seen,
    quality: f32,
}

/// Chooses the sites. `set_up` puts up what a candidate needs; it says whether there was room, and nothing before the
/// lens.
pub(crate) fn choose(scene: Scene<'_>, set_up: &mut dyn FnMut(&Candidate) -> bool) -> Vec<CameraSite> {
    let judge = Judge::new(scene.network, scene.relief, scene.posts, &scene.parked);
    let judged = |candidate: Candidate| {
        let seen = judge.look(&candidate.site, candidate.level)?;
        let modest = !candidate.view.is_on_foot() && seen.street() > MODEST_PAVED;
        let quality = seen.quality(candidate.view).or(modest.then_some(MODEST))?;
        Some(Judged { candidate: classed(candidate, &seen), seen, quality })
    };
    // Thousands, each by itself: all threads judge, and the order stays.
    let all = candidate::all(scene.network, scene.relief, scene.solids, scene.open);
    let mut left: Vec<Judged> = all.into_par_iter().filter_map(judged).collect();
    let mut taken: Vec<Judged> = Vec::new();
    let mut due: &[View] = &COVERED;
    while taken.len() < WANTED {
        // A small map may have one street and no more.
        let full = |j: &Judged| !allowed(j.candidate.view, &taken);
        let any = due.is_empty() && taken.len() < LEAST && left.iter().all(full);
        let asked = |j: &Judged| due.first().is_none_or(|view| j.candidate.view == *view);
        let worth = |j: &Judged| taken.iter().fold(j.quality, |worth, other| worth * unlike(j, other));
        let best = left
            .iter()
            .enumerate()
            .map(|(i, j)| (i, worth(j)))
            .filter(|(i, _)| asked(&left[*i]) && (any || !full(&left[*i])))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        let least = if due.is_empty() && taken.len() >= LEAST { WORTH } else { 1e-4 };
        let Some((i, _)) = best.filter(|best| best.1 > least) else {
            let Some(rest) = due.get(1..) else { break };
            due = rest;
            continue;
        };
        let judged = left.swap_remove(i);
        if set_up(&judged.candidate) {
            taken.push(judged);
            due = due.get(1..).unwrap_or_default();
        }
    }
    taken.sort_by_key(|j| j.candidate.view);
    let mut sites: Vec<CameraSite> = Vec::new();
    for judged in &taken {
        let site = named(&judged.candidate, &sites);
        sites.push(site);
    }
    sites
}

/// A street between fields is a rural road.
fn classed(candidate: Candidate, seen: &Seen) -> Candidate {
    let open = seen.green > 0.3 && seen.solid < 0.08;
    let view = if open && candidate.view == View::Street { View::Rural } else { candidate.view };
    Candidate { view, ..candidate }
}

fn allowed(view: View, taken: &[Judged]) -> bool {
    let most = MOST.iter().find(|m| m.0 == view).map_or(1, |m| m.1);
    taken.iter().filter(|j| j.candidate.view == view).count() < most
}

/// From 0 (the same picture) to 1 (nothing in common).
fn unlike(a: &Judged, b: &Judged) -> f32 {
    let (sa, sb) = (&a.candidate.site, &b.candidate.site);
    let apart = Vec3::from_array(sa.position).distance(Vec3::from_array(sb.position));
    let turned = between(sa.yaw_rad, sb.yaw_rad) as f32;
    if apart < 7.0 || (apart < 30.0 && turned < 0.5) {
        return 0.0;
    }
    let near = (apart / 90.0).min(1.0);
    let place = 0.55 + 0.45 * near.max((turned / 2.0).min(1.0) * 0.8);
    let kind = if a.candidate.view == b.candidate.view { 0.62 } else { 1.0 };
    let shares = |s: &Seen| [s.road, s.junction, s.walk, s.ground, s.green, s.solid, s.sky, s.water];
    let differ: f32 = shares(&a.seen).iter().zip(shares(&b.seen)).map(|(x, y)| (x - y).abs()).sum();
    kind * place * (0.75 + 0.25 * (differ / 0.7).min(1.0))
}

/// The site with a name such as `junction_north`, unique among those before it.
fn named(candidate: &Candidate, before: &[CameraSite]) -> CameraSite {
    const COMPASS: [&str; 8] = ["east", "northeast", "north", "northwest", "west", "southwest", "south", "southeast"];
    let [x, y, _] = candidate.site.position.map(f64::from);
    let octant = (atan2(y, x) / std::f64::consts::FRAC_PI_4).round().rem_euclid(8.0) as usize;
    let place = if DVec2::new(x, y).length() < 35.0 { "centre" } else { COMPASS[octant] };
    let base = format!("{}_{place}", candidate.view.name());
    let name = (1..)
        .map(|n| if n == 1 { base.clone() } else { format!("{base}_{n}") })
        .find(|name| before.iter().all(|site| site.name != *name))
        .unwrap_or(base.clone());
    CameraSite { name, ..candidate.site.clone() }
}

/// Whether a pole would stand large in a camera's picture.
pub(crate) fn spoils(sites: &[CameraSite], at: DVec2) -> bool {
    sites.iter().any(|site| {
        let [x, y, _] = site.position.map(f64::from);
        let between = at - DVec2::new(x, y);
        let off_axis = wrap_angle(atan2(between.y, between.x) - f64::from(site.yaw_rad)).abs();
        let distance = between.length();
        distance < 3.0 || (distance < 13.0 && off_axis < f64::from(site.horizontal_fov_rad) / 2.0 + 0.05)
    })
}

/// Whether a tree or other wide thing would stand in a camera's view: near in front of it, or on its axis.
pub(crate) fn in_the_way(sites: &[CameraSite], at: DVec2, radius: f64) -> bool {
    sites.iter().any(|site| {
        let [x, y, _] = site.position.map(f64::from);
        let between = at - DVec2::new(x, y);
        let distance = between.length();
        let off_axis = wrap_angle(atan2(between.y, between.x) - f64::from(site.yaw_rad)).abs();
        let half = f64::from(site.horizontal_fov_rad) / 2.0;
        distance < radius + 1.8
            || (distance < 26.0 && off_axis < half + (radius / distance).min(1.0))
            || (distance < 45.0 && off_axis < 0.28 + radius / distance)
    })
}
