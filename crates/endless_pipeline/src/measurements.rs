//! What there is to record of a video.

use endless_world::SceneSettings;

/// Frames of all cameras of a video, and measurements of the sensors of its rig.
pub(crate) fn measurements(settings: &SceneSettings) -> u64 {
    measurements_from(settings, 0)
}

/// Those from frame `first` on, which is one of the video.
pub(crate) fn measurements_from(settings: &SceneSettings, first: u32) -> u64 {
    let from_first = |every: u32| u64::from(settings.frames.div_ceil(every) - first.div_ceil(every));
    let of_rig = settings.sensors.iter().map(|sensor| from_first(sensor.every));
    settings.cameras.len() as u64 * from_first(1) + of_rig.sum::<u64>()
}
