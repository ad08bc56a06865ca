//! Camera sites: the best views of each kind that a town has.

mod candidate;
mod sight;

use crate::building::Lot;
use crate::dressing::{Dresser, Spot};
use candidate::{Candidate, View};
use endless_asset::Prop;
use endless_road::RoadNetwork;
use endless_world::math::f64::{atan2, wrap_angle};
use endless_world::{CameraSite, Mount};
use glam::{DVec2, Vec3};
use sight::Sights;

/// How many views of each kind are wanted, and how many cameras may look at the same thing.
const WANTED: [(View, usize); 6] = [
    (View::Signals, 3),
    (View::Corner, 2),
    (View::Crossing, 1),
    (View::Street, 2),
    (View::Residential, 1),
    (View::Wall, 1),
];

/// Chooses the sites and sets up their poles.
pub(crate) fn choose(dresser: &mut Dresser<'_>, network: &RoadNetwork, lots: &[Lot]) -> Vec<CameraSite> {
    let posts = dresser.placements.iter().map(|p| p.world_from_object.translation.truncate().as_dvec2()).collect();
    let sights = Sights::new(network, lots, posts);
    let mut ranked: Vec<(f32, Candidate)> = candidate::all(dresser.plan, lots)
        .into_iter()
        .filter_map(|c| sights.score(&c.site).map(|score| (score, c)))
        .collect();
    ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut sites: Vec<CameraSite> = Vec::new();
    let mut subjects: Vec<(View, usize)> = Vec::new();
    for (view, wanted) in WANTED {
        let mut found = 0;
        for (_, candidate) in ranked.iter().filter(|(_, c)| c.view == view) {
            // The best junction is seen by two cameras from different corners; all else by one.
            let shared = subjects.iter().filter(|&&s| s == (view, candidate.subject)).count();
            let allowed = if view == View::Signals && found == 1 { 2 } else { 1 };
            if found == wanted || shared >= allowed || sites.iter().any(|s| too_alike(s, &candidate.site)) {
                continue;
            }
            if set_up(dresser, candidate) {
                sites.push(named(candidate, &sites));
                subjects.push((view, candidate.subject));
                found += 1;
            }
        }
    }
    sites
}

/// Two cameras that would stand side by side or show nearly the same.
fn too_alike(a: &CameraSite, b: &CameraSite) -> bool {
    let apart = Vec3::from_array(a.position).distance(Vec3::from_array(b.position));
    let turned = wrap_angle(f64::from(a.yaw_rad - b.yaw_rad)).abs();
    apart < 6.0 || (apart < 25.0 && turned < 0.5)
}

/// Puts up the pole, if there is room for it.
fn set_up(dresser: &mut Dresser<'_>, candidate: &Candidate) -> bool {
    let Some(foot) = candidate.pole else {
        return candidate.site.mount == Mount::Wall;
    };
    let height = candidate.site.position[2] - 0.15;
    let spot =
        Spot { scale: Vec3::new(1.0, 1.0, (height + 0.1) / 6.0), ..Spot::new(foot, f64::from(candidate.site.yaw_rad)) };
    dresser.put(Prop::CameraPole, spot, DVec2::splat(0.2), None)
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
