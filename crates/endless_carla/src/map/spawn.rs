//! Places where vehicles appear.

use crate::frames;
use crate::wire::Transform;
use endless_town::Town;
use endless_world::math::f64::sin_cos;
use glam::{DVec2, DVec3};

/// So much above the road, metres: what spawns drops onto its wheels.
const ABOVE_M: f64 = 0.4;
/// Room before and behind, metres: a bus has it.
const ALONG_M: f64 = 12.0;
/// Room to the side, metres: the next lane has it.
const BESIDE_M: f64 = 2.7;
/// Before and behind to parked vehicles, and to their side, metres, between the middles.
const PARKED_M: [f64; 2] = [9.0, 2.4];
/// Farther apart in height, metres, is another level.
const LEVEL_M: f64 = 3.0;

/// Places on lanes, away from junctions, crossings and parked vehicles, and from one another; in the order of the lanes.
pub(super) fn points(town: &Town) -> Vec<Transform> {
    let parked: Vec<DVec3> = town.parked.iter().map(|vehicle| vehicle.pose.position.as_dvec3()).collect();
    let mut taken: Vec<DVec3> = Vec::new();
    let mut points = Vec::new();
    for spawn in &town.network.spawn_points {
        let there = town.network.lane(spawn.lane).centerline.at(spawn.s);
        let clear = |other: &DVec3, room: [f64; 2]| {
            let away = *other - there.position;
            let (sin, cos) = sin_cos(there.heading_rad);
            let along = DVec2::new(cos, sin);
            let local = DVec2::new(away.truncate().dot(along), along.perp_dot(away.truncate()));
            local.x.abs() > room[0] || local.y.abs() > room[1] || away.z.abs() > LEVEL_M
        };
        if taken.iter().all(|p| clear(p, [ALONG_M, BESIDE_M])) && parked.iter().all(|p| clear(p, PARKED_M)) {
            taken.push(there.position);
            points.push(frames::heading(there.position + DVec3::Z * ABOVE_M, there.heading_rad, there.grade));
        }
    }
    points
}
