//! Selects camera sites: good views, of different kinds, that differ from one another.
//!
//! Candidates stand beside lanes, at stop lines and crossings, and hang on walls; each is judged by what its picture
//! shows (`judge`) on a field of heights (`relief`); the best are taken one after another, each discounted by its
//! likeness to those taken before.

use super::candidate::{self, CameraCandidate, ViewKind, between};
use super::surroundings::CameraSurroundings;
use super::view_score::{ViewContents, ViewScorer};
use endless_world::CameraSite;
use endless_world::math::f64::atan2;
use glam::{DVec2, Vec3};
use rayon::prelude::*;

/// Cameras a town gets, where it has that many places.
const WANTED: usize = 10;
/// Cameras it must have, even if the views are modest.
const LEAST: usize = 5;
/// Views that are not good enough, taken where a map has no better: their worth, and what they must show of pavement.
const MODEST: f32 = 0.02;
const MODEST_PAVED: f32 = 0.27;
/// Most cameras of one kind.
const MOST: [(ViewKind, usize); 10] = [
    (ViewKind::Approach, 2),
    (ViewKind::Arm, 2),
    (ViewKind::Corner, 1),
    (ViewKind::Crossing, 2),
    (ViewKind::Street, 2),
    (ViewKind::Highway, 2),
    (ViewKind::Rural, 2),
    (ViewKind::Wall, 2),
    (ViewKind::Square, 2),
    (ViewKind::Park, 1),
];
/// A town that has places of these kinds has a camera there.
const COVERED: [ViewKind; 5] =
    [ViewKind::Approach, ViewKind::Highway, ViewKind::Rural, ViewKind::Square, ViewKind::Park];
/// The worth of a view below which it is not taken once a town has enough.
const WORTH: f32 = 1.4;

/// A candidate with what it shows.
struct ScoredCandidate {
    candidate: CameraCandidate,
    seen: ViewContents,
    quality: f32,
}

/// Chooses the sites. `set_up` puts up what a candidate needs; it says whether there was room, and nothing before the
/// lens.
pub(crate) fn choose(
    scene: CameraSurroundings<'_>,
    set_up: &mut dyn FnMut(&CameraCandidate) -> bool,
) -> Vec<CameraSite> {
    let judge = ViewScorer::new(scene.network, scene.relief, scene.posts, &scene.parked);
    let judged = |candidate: CameraCandidate| {
        let seen = judge.look(&candidate.site, candidate.level)?;
        let modest = !candidate.view.is_on_foot() && seen.street() > MODEST_PAVED;
        let quality = seen.quality(candidate.view).or(modest.then_some(MODEST))?;
        Some(ScoredCandidate { candidate: classed(candidate, &seen), seen, quality })
    };
    // Thousands, each by itself: all threads judge, and the order stays.
    let all = candidate::all(scene.network, scene.relief, scene.solids, scene.open);
    let mut left: Vec<ScoredCandidate> = all.into_par_iter().filter_map(judged).collect();
    let mut taken: Vec<ScoredCandidate> = Vec::new();
    let mut due: &[ViewKind] = &COVERED;
    while taken.len() < WANTED {
        // A small map may have one street and no more.
        let full = |j: &ScoredCandidate| !allowed(j.candidate.view, &taken);
        let any = due.is_empty() && taken.len() < LEAST && left.iter().all(full);
        let asked = |j: &ScoredCandidate| due.first().is_none_or(|view| j.candidate.view == *view);
        let worth = |j: &ScoredCandidate| taken.iter().fold(j.quality, |worth, other| worth * unlike(j, other));
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
fn classed(candidate: CameraCandidate, seen: &ViewContents) -> CameraCandidate {
    let open = seen.green > 0.3 && seen.solid < 0.08;
    let view = if open && candidate.view == ViewKind::Street { ViewKind::Rural } else { candidate.view };
    CameraCandidate { view, ..candidate }
}

fn allowed(view: ViewKind, taken: &[ScoredCandidate]) -> bool {
    let most = MOST.iter().find(|m| m.0 == view).map_or(1, |m| m.1);
    taken.iter().filter(|j| j.candidate.view == view).count() < most
}

/// From 0 (the same picture) to 1 (nothing in common).
fn unlike(a: &ScoredCandidate, b: &ScoredCandidate) -> f32 {
    let (sa, sb) = (&a.candidate.site, &b.candidate.site);
    let apart = Vec3::from_array(sa.position).distance(Vec3::from_array(sb.position));
    let turned = between(sa.yaw_rad, sb.yaw_rad) as f32;
    if apart < 7.0 || (apart < 30.0 && turned < 0.5) {
        return 0.0;
    }
    let near = (apart / 90.0).min(1.0);
    let place = 0.55 + 0.45 * near.max((turned / 2.0).min(1.0) * 0.8);
    let kind = if a.candidate.view == b.candidate.view { 0.62 } else { 1.0 };
    let shares = |s: &ViewContents| [s.road, s.junction, s.walk, s.ground, s.green, s.solid, s.sky, s.water];
    let differ: f32 = shares(&a.seen).iter().zip(shares(&b.seen)).map(|(x, y)| (x - y).abs()).sum();
    kind * place * (0.75 + 0.25 * (differ / 0.7).min(1.0))
}

/// The site with a name such as `junction_north`, unique among those before it.
fn named(candidate: &CameraCandidate, before: &[CameraSite]) -> CameraSite {
    named_by(candidate.view.name(), &candidate.site, before)
}

/// The site with a name that begins so, unique among those before it.
pub(super) fn named_by(what: &str, site: &CameraSite, before: &[CameraSite]) -> CameraSite {
    const COMPASS: [&str; 8] = ["east", "northeast", "north", "northwest", "west", "southwest", "south", "southeast"];
    let [x, y, _] = site.position.map(f64::from);
    let octant = (atan2(y, x) / std::f64::consts::FRAC_PI_4).round().rem_euclid(8.0) as usize;
    let place = if DVec2::new(x, y).length() < 35.0 { "centre" } else { COMPASS[octant] };
    let base = format!("{what}_{place}");
    let name = (1..)
        .map(|n| if n == 1 { base.clone() } else { format!("{base}_{n}") })
        .find(|name| before.iter().all(|site| site.name != *name))
        .unwrap_or(base.clone());
    CameraSite { name, ..site.clone() }
}
