//! One camera: while it stands still, what stands still is traced but once.

use super::events::Events;
use super::town_light::Light;
use crate::server::actor::CameraSettings;
use endless_render::{
    CameraBake, FrameScene, LocalLight, NeighbourFrame, NeighbourFrames, RenderSettings, RoamingCamera, render_labels,
};
use endless_world::{CameraSite, LensModel, Mount, PinholeCamera, SceneWeather, SensorFrame, SensorLayers, SensorPose};
use glam::DVec3;
use std::collections::BTreeMap;
use std::sync::Arc;

/// A camera, and what is kept of it from frame to frame.
#[derive(Default)]
pub(super) struct CameraView {
    last: Option<(SensorPose, SceneWeather)>,
    /// Frames for which neither it nor the weather has moved.
    stood: u32,
    way: Option<Way>,
    /// What moved when it was last looked through, and from where, if flow is wanted.
    before: Option<(Arc<FrameScene>, PinholeCamera)>,
    /// Of event cameras that look through it, by their streams.
    pub(super) events: BTreeMap<u32, Events>,
}

/// How a picture is made.
pub(super) enum Making {
    /// The camera stands still. All threads make its picture if there are more of them than pictures.
    Still { at_once: bool },
    /// It moves, in this light.
    Moving(LocalLight),
    /// It moves, and nobody asks for colours.
    Labels,
}

enum Way {
    /// It stands still; what is known besides colours.
    Still(Box<CameraBake>, SensorLayers),
    /// It moves.
    Moving(Box<RoamingCamera>),
}

/// A camera that has stood for so many frames is taken for one that stands still.
const STANDS: u32 = 3;

impl CameraView {
    /// Takes note of where it is now; whether it is taken for one that moves.
    pub(super) fn goes(&mut self, light: &Light<'_>, settings: CameraSettings, pose: &SensorPose) -> bool {
        let is_new = self.last.is_none();
        let stands = self.last.as_ref().is_some_and(|(last, then)| last == pose && light.is_as_in(then));
        self.stood = if stands { self.stood + 1 } else { 0 };
        if !stands {
            self.last = Some((*pose, light.weather));
        }
        // Who carries a camera will go on after a red light: two ways of finding light must not alternate.
        let stays = !settings.is_carried && (is_new || self.stood >= STANDS);
        !(stays || stands && matches!(self.way, Some(Way::Still(..))))
    }

    /// Other things stand in the town, or its lamps shine otherwise: what it kept of that is no longer so.
    pub(super) fn forget_town(&mut self) {
        if matches!(self.way, Some(Way::Still(..))) {
            self.way = None;
        }
    }

    /// What it sees.
    pub(super) fn render(
        &mut self,
        light: &Light<'_>,
        making: &Making,
        frame: &Arc<FrameScene>,
        settings: CameraSettings,
        pose: &SensorPose,
        layers: SensorLayers,
    ) -> (SensorFrame, PinholeCamera) {
        let camera = PinholeCamera::at(pose, settings.size, settings.fov_deg.to_radians());
        let render_settings = || RenderSettings { layers, ..light.settings(settings.size) };
        let now = layers.flow_backward.then(|| (Arc::clone(frame), camera.clone()));
        let before = std::mem::replace(&mut self.before, now);
        let neighbours =
            NeighbourFrames { before: before.as_ref().map(|before| neighbour(before, &camera)), after: None };
        let around = match making {
            Making::Labels => return (render_labels(light.still, frame, &camera, layers), camera),
            Making::Moving(around) => around,
            Making::Still { at_once } => {
                let (bake, known) = match self.way.take() {
                    Some(Way::Still(bake, known)) if self.stood > 0 && is_known(layers, known) => (bake, known),
                    _ => {
                        let bake = CameraBake::bake(light.still, &render_settings(), &site(pose, settings));
                        (Box::new(bake), layers)
                    }
                };
                let seen = if *at_once {
                    bake.render_at_once(light.still, frame, neighbours)
                } else {
                    bake.render_between(light.still, frame, neighbours)
                };
                self.way = Some(Way::Still(bake, known));
                return (seen, camera);
            }
        };
        let mut moving = match self.way.take() {
            Some(Way::Moving(moving)) => moving,
            _ => {
                Box::new(RoamingCamera::new(&RenderSettings { samples: light.quality.samples(), ..render_settings() }))
            }
        };
        *moving.layers_mut() = layers;
        let seen = moving.render(light.still, frame, around, &camera, neighbours, light.step_s as f32);
        self.way = Some(Way::Moving(moving));
        (seen, camera)
    }
}

/// Whether what is wanted of a camera is known of it already.
fn is_known(wanted: SensorLayers, known: SensorLayers) -> bool {
    (known.normals || !wanted.normals) && (known.flow_backward || !wanted.flow_backward)
}

/// The picture before, as flow leads to it from this camera.
fn neighbour<'a>((scene, then): &'a (Arc<FrameScene>, PinholeCamera), now: &PinholeCamera) -> NeighbourFrame<'a> {
    NeighbourFrame { scene, covered: None, camera: (then != now).then_some(then) }
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
