//! The cameras of a scene as they see: lens, sensor and recorder.

use endless_dataset::Recipe;
use endless_world::{
    CameraLook, CameraSite, DrawnSun, RandomisedPart, RecorderClock, SceneCamera, SceneSettings, Stream,
};

/// The recorder's clock of a video.
pub(super) fn recorder_clock(recipe: &Recipe, scene: &SceneSettings) -> RecorderClock {
    let mut random = Stream::named(recipe.seed, "clock", &[u64::from(scene.video)]);
    RecorderClock::new(scene.time_of_day, DrawnSun::of(scene), &mut random)
}

/// The camera of a number in a video, at its site.
pub(super) fn scene_camera(recipe: &Recipe, scene: &SceneSettings, (site, number): (CameraSite, u64)) -> SceneCamera {
    let mut random = Stream::named(recipe.seed, "camera look", &[u64::from(scene.video), number]);
    let clock = recorder_clock(recipe, scene);
    let look = CameraLook::new(recipe.camera_look, scene.time_of_day, clock, &mut random);
    let askew = scene.randomised.as_ref().filter(|r| r.varies(RandomisedPart::Camera));
    let look = askew.map_or(look, |r| look.randomised(r.strength, &mut random));
    SceneCamera { site, look }
}
