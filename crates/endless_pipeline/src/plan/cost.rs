//! What videos cost in proportion to one another, as the plan alone tells it.
//!
//! Shares are the same on every machine, so they are not measured there: a unit is one pixel of one frame of a camera. What
//! else there is was measured at 1280x720 (docs/speed.md).

use endless_world::SceneSettings;

/// Frames of the same size that take as long as the bake of a camera.
const BAKE_FRAMES: u64 = 60;
/// Pixels of frames that take as long as the load of a map.
pub(super) const MAP_PIXELS: u64 = 35 * 1280 * 720;
/// The same for a scene that is populated.
const SCENE_PIXELS: u64 = 2 * 1280 * 720;
/// Pixels of a frame that take as long as a measurement of a sensor that is no camera.
const MEASUREMENT_PIXELS: u64 = 200_000;

/// Of one video, the load of its map left out.
pub(super) fn cost(settings: &SceneSettings) -> u64 {
    let cameras = settings.cameras.len() as u64;
    let frames = cameras * (u64::from(settings.frames) + BAKE_FRAMES) * settings.size.pixels() as u64;
    let of_rig = settings.sensors.iter().map(|sensor| {
        let pixels = sensor.model.camera().map_or(MEASUREMENT_PIXELS, |camera| camera.size.pixels() as u64);
        u64::from(settings.frames.div_ceil(sensor.every)) * pixels
    });
    SCENE_PIXELS + frames + of_rig.sum::<u64>()
}
