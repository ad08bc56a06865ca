//! Vehicles parked in the strips along streets.

use endless_world::{CameraSite, ParkedVehicle};
use glam::Vec3;

/// Most vehicles parked along the streets of a town.
const MOST: usize = 160;

/// Keeps the vehicles parked nearest to cameras: no others are ever seen large.
pub(crate) fn keep_the_seen(parked: &mut Vec<ParkedVehicle>, sites: &[CameraSite]) {
    let far = |p: &ParkedVehicle| {
        let of = |s: &CameraSite| Vec3::from_array(s.position).distance(p.pose.position);
        sites.iter().map(of).fold(f32::INFINITY, f32::min)
    };
    parked.sort_by(|a, b| far(a).total_cmp(&far(b)));
    parked.truncate(MOST);
}
