//! What there is to record of a video.

use endless_world::SceneSettings;

/// Frames of all cameras of a video, and measurements of the sensors of its rig.
pub(crate) fn measurements(settings: &SceneSettings) -> u64 {
    let of_rig = settings.sensors.iter().map(|sensor| u64::from(settings.frames.div_ceil(sensor.every)));
    settings.cameras.len() as u64 * u64::from(settings.frames) + of_rig.sum::<u64>()
}
