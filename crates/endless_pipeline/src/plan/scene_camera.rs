//! The cameras of a scene as they see: lens, sensor and recorder.

use endless_dataset::Recipe;
use endless_world::{
    CameraLook, CameraSite, RandomisedPart, RecorderClock, SceneCamera, SceneRandomisation, Stream, TimeOfDay,
};

/// The recorder's clock of a video.
pub(super) fn recorder_clock(recipe: &Recipe, video: u32, time_of_day: TimeOfDay) -> RecorderClock {
    RecorderClock::new(time_of_day, &mut Stream::named(recipe.seed, "clock", &[u64::from(video)]))
}

/// The camera of a number in a video, at its site.
pub(super) fn scene_camera(
    recipe: &Recipe,
    (video, time_of_day): (u32, TimeOfDay),
    randomised: Option<&SceneRandomisation>,
    (site, number): (CameraSite, u64),
) -> SceneCamera {
    let mut random = Stream::named(recipe.seed, "camera look", &[u64::from(video), number]);
    let clock = recorder_clock(recipe, video, time_of_day);
    let look = CameraLook::new(recipe.camera_look, time_of_day, clock, &mut random);
    let askew = randomised.filter(|r| r.varies(RandomisedPart::Camera));
    let look = askew.map_or(look, |r| look.randomised(r.strength, &mut random));
    SceneCamera { site, look }
}
