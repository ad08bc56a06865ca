//! One camera: while it stands still, what stands still is traced but once.

use crate::server::actor::CameraSettings;
use endless_render::{CameraBake, FrameScene, IndirectLight, MovingCamera, RenderSettings, StaticScene};
use endless_world::{
    CameraSite, LensModel, Mount, PinholeCamera, SceneWeather, SensorFrame, SensorLayers, SensorPose, TimeOfDay,
    Weather, rotation_from_angles,
};
use glam::DVec3;
use std::f64::consts::FRAC_PI_2;

/// What does not depend on the camera.
pub(super) struct Light<'a> {
    pub(super) still: &'a StaticScene,
    pub(super) weather: SceneWeather,
    pub(super) seed: u64,
    /// Since the frame before, seconds.
    pub(super) step_s: f64,
}

/// A camera, and what is kept of it from frame to frame.
#[derive(Default)]
pub(super) struct CameraView {
    last: Option<SensorPose>,
    /// Frames for which it has not moved.
    stood: u32,
    kept: Option<Kept>,
}

/// What is kept.
struct Kept {
    weather: SceneWeather,
    normals: bool,
    way: Way,
}

enum Way {
    /// It stands still.
    Still(Box<CameraBake>),
    /// It moves: light is known around a place.
    Moving(Box<MovingCamera>, DVec3),
}

/// A camera that has stood for so many frames is taken for one that stands still.
const STANDS: u32 = 3;
/// Light is found anew when the camera is farther from where it was found, metres.
const FAR_M: f64 = 25.0;

impl CameraView {
    /// What it sees, and the camera.
    pub(super) fn render(
        &mut self,
        light: &Light<'_>,
        frame: &FrameScene,
        settings: CameraSettings,
        pose: &SensorPose,
        normals: bool,
    ) -> (SensorFrame, PinholeCamera) {
        let is_new = self.last.is_none();
        let stands = self.last.as_ref().is_some_and(|last| last == pose);
        self.stood = if stands { self.stood + 1 } else { 0 };
        self.last = Some(*pose);
        let camera = PinholeCamera::at(pose, settings.size, settings.fov_deg.to_radians());
        let is_good = |kept: &Kept| is_like(&kept.weather, &light.weather) && (kept.normals || !normals);
        let kept = self.kept.take().filter(is_good);
        // Who carries a camera will go on after a red light: two ways of finding light must not alternate.
        let stays = !settings.is_carried && (is_new || self.stood >= STANDS);
        let way = match (kept.map(|kept| kept.way), stays) {
            (Some(Way::Still(bake)), _) if stands => Way::Still(bake),
            (_, true) => Way::Still(Box::new(CameraBake::bake(
                light.still,
                &render_settings(light, settings, normals),
                &site(pose, settings),
            ))),
            (Some(Way::Moving(moving, centre)), false) if centre.distance(pose.position) < FAR_M => {
                Way::Moving(moving, centre)
            }
            (_, false) => {
                let settings = render_settings(light, settings, normals);
                let around = around(&camera, pose);
                let moving = MovingCamera::new(light.still, &settings, IndirectLight::Probes, &around);
                Way::Moving(Box::new(moving), pose.position)
            }
        };
        let seen = match &way {
            Way::Still(bake) => bake.render(light.still, frame),
            Way::Moving(moving, _) => moving.render(light.still, frame, &camera),
        };
        self.kept = Some(Kept { weather: light.weather, normals, way });
        (seen, camera)
    }
}

fn render_settings(light: &Light<'_>, settings: CameraSettings, normals: bool) -> RenderSettings {
    RenderSettings {
        weather: light.weather,
        layers: SensorLayers { normals, ..SensorLayers::default() },
        fps: if light.step_s > 0.0 { 1.0 / light.step_s } else { 30.0 },
        ..RenderSettings::new(Weather::ClearSky, TimeOfDay::Afternoon, light.seed, settings.size)
    }
}

/// The same camera, as those know it that hang on poles.
fn site(pose: &SensorPose, settings: CameraSettings) -> CameraSite {
    use endless_world::math::f64::{asin, atan2};
    let turn = pose.world_from_sensor;
    let (forward, left, up) = (turn * DVec3::X, turn * DVec3::Y, turn * DVec3::Z);
    CameraSite {
        name: String::new(),
        position: pose.position.as_vec3().to_array(),
        yaw_rad: atan2(forward.y, forward.x) as f32,
        down_tilt_rad: -asin(forward.z.clamp(-1.0, 1.0)) as f32,
        horizontal_fov_rad: settings.fov_deg.to_radians(),
        lens: LensModel::Pinhole,
        mount: Mount::Pole,
        roll_rad: atan2(left.z, up.z) as f32,
    }
}

/// Cameras that look all around from where this one is: wherever it turns, light is known.
fn around(camera: &PinholeCamera, pose: &SensorPose) -> Vec<PinholeCamera> {
    let turned = |quarter: i32| {
        let turn = rotation_from_angles(f64::from(quarter) * FRAC_PI_2, 0.0, 0.0) * pose.world_from_sensor;
        let there = SensorPose { world_from_sensor: turn, ..*pose };
        let fov_rad = 2.0
            * endless_world::math::f64::atan2(0.5 * f64::from(camera.size.width), f64::from(camera.intrinsics.fx))
                as f32;
        PinholeCamera::at(&there, camera.size, fov_rad)
    };
    (0..4).map(turned).collect()
}

/// Whether what was found in one weather does for the other.
fn is_like(a: &SceneWeather, b: &SceneWeather) -> bool {
    /// The cosine of the sun's way in some four minutes.
    const SUN: f32 = 0.99985;
    a.weather == b.weather && a.time_of_day == b.time_of_day && a.sun_direction.dot(b.sun_direction) > SUN
}
