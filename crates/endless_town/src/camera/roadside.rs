//! Places beside lanes where poles can stand.

use super::height_field::{HeightField, TopSurface};
use crate::geometry::unit;
use endless_road::{Polyline, RoadNetwork};
use glam::{DVec2, DVec3};

/// From the edge of the carriageway to a pole, metres.
pub(super) const POLE_M: f64 = 0.6;
/// Poles stand further than this from the middle of every lane, metres.
const CLEAR_M: f64 = 1.3;
/// Nor this near to the edge of one beside it.
const EDGE_M: f64 = 0.25;
/// Lanes this much higher or lower pass over or under.
const OTHER_LEVEL_M: f64 = 2.5;

/// A place beside a lane, and the direction of the lane there.
pub(super) struct Roadside {
    pub(super) foot: DVec2,
    pub(super) ground: f64,
    pub(super) road_z: f64,
    pub(super) forward: DVec2,
    /// From the foot to the lane's centre line.
    pub(super) across: f64,
}

/// The nearest place beside a lane where a pole could stand: to the right (−1) or in the median to the left (+1).
pub(super) fn beside(relief: &HeightField, line: &Polyline, s: f64, width: f64, side: f64) -> Option<Roadside> {
    let place = line.at(s);
    let forward = unit(place.heading_rad);
    let outwards = forward.perp() * side;
    let here = place.position.truncate();
    let reach = if side < 0.0 { 9.0 } else { 2.2 };
    let free = |t: f64| {
        let (z, top) = relief.at(here + outwards * t);
        matches!(top, TopSurface::Walk | TopSurface::Green | TopSurface::Ground)
            && (f64::from(z) - place.position.z).abs() < 1.5
    };
    let steps = (reach / 0.25) as usize;
    let edge = (0..steps).map(|k| width / 2.0 + 0.1 + 0.25 * k as f64).find(|&t| free(t))?;
    let t = edge + POLE_M - 0.1;
    free(t).then(|| {
        let foot = here + outwards * t;
        Roadside { foot, ground: f64::from(relief.at(foot).0), road_z: place.position.z, forward, across: t }
    })
}

/// Whether something drives by so near that a pole would be hit. Lanes that widen or narrow run where the surface
/// alone does not tell.
pub(crate) fn blocks_lane(network: &RoadNetwork, foot: DVec3) -> bool {
    network.lanes.iter().any(|lane| {
        let (s, t) = lane.centerline.project(foot.truncate());
        let nearest = lane.centerline.position(s);
        let distance = nearest.truncate().distance(foot.truncate());
        let beside = distance < t.abs() + 0.1;
        let clear = if beside { CLEAR_M.max(lane.width_m / 2.0 + EDGE_M) } else { CLEAR_M };
        distance < clear && (nearest.z - foot.z).abs() < OTHER_LEVEL_M
    })
}
