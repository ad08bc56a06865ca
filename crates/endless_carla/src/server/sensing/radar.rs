//! Radars: velocity, azimuth, altitude and depth of each detection.

use crate::stream::SensorHeader;
use endless_render::RayCaster;
use endless_sensor::{Radar, SweepInterval};
use endless_world::RadarSettings;

/// A scan: m/s (negative when coming nearer), radians to the right and upwards, metres.
pub(super) fn message(
    header: &SensorHeader,
    settings: &RadarSettings,
    caster: &RayCaster<'_>,
    interval: &SweepInterval,
    seed: u64,
) -> Vec<u8> {
    let scan = Radar::new(settings, seed).scan(caster, interval);
    let mut message = header.begin(16 * scan.detections.len());
    for detection in &scan.detections {
        let numbers = [detection.velocity_mps, -detection.azimuth_rad, detection.altitude_rad, detection.depth_m];
        message.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    }
    message
}
