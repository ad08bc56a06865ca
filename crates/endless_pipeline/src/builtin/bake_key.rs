//! What a bake's indirect rays depend on, as one digest.

use endless_render::{RenderSettings, StaticScene};
use endless_world::{CameraSite, RandomisedPart, SceneRandomisation, SceneSettings};

/// BLAKE3 of the scene, the camera and the pattern of rays.
pub(super) type BakeKey = [u8; 32];

/// The key of a camera in the scene of this digest.
pub(super) fn bake_key(scene: &BakeKey, site: &CameraSite, settings: &RenderSettings) -> BakeKey {
    let RenderSettings { size, gathering, pattern, look, .. } = settings;
    let mut hasher = blake3::Hasher::new_keyed(scene);
    add_site(&mut hasher, site);
    for number in [look.distortion.k1, look.distortion.k2] {
        hasher.update(&number.to_le_bytes());
    }
    for number in [size.width, size.height, *pattern] {
        hasher.update(&number.to_le_bytes());
    }
    hasher.update(format!("{gathering:?}").as_bytes());
    *hasher.finalize().as_bytes()
}

/// Of a scene with what a video puts into it.
pub(super) fn variant_key(scene: &BakeKey, video: &SceneSettings) -> BakeKey {
    let cluttered = video.randomised.as_ref().filter(|randomised| randomised.varies(RandomisedPart::Clutter));
    let Some(SceneRandomisation { strength, seed, .. }) = cluttered else { return *scene };
    let mut hasher = blake3::Hasher::new_keyed(scene);
    hasher.update(&seed.to_le_bytes());
    hasher.update(&strength.to_le_bytes());
    // It stands where the cameras look.
    for camera in &video.cameras {
        add_site(&mut hasher, &camera.site);
    }
    *hasher.finalize().as_bytes()
}

/// Where a camera hangs and looks.
fn add_site(hasher: &mut blake3::Hasher, site: &CameraSite) {
    let CameraSite { name: _, position, yaw_rad, down_tilt_rad, horizontal_fov_rad, lens, mount: _, roll_rad } = site;
    for number in position.iter().chain([yaw_rad, down_tilt_rad, horizontal_fov_rad, roll_rad]) {
        hasher.update(&number.to_le_bytes());
    }
    hasher.update(format!("{lens:?}").as_bytes());
}

/// Of a scene as a build of this program traces it.
pub(super) fn scene_key(build: &str, still: &StaticScene) -> BakeKey {
    let mut hasher = blake3::Hasher::new_derive_key("endless indirect hits 1");
    hasher.update(build.as_bytes());
    still.write_geometry(&mut hasher).expect("a hasher takes all");
    *hasher.finalize().as_bytes()
}
