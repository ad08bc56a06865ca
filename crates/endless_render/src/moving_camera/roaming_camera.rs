//! A camera that goes anywhere: it opens and closes its aperture as the street gets darker and brighter.

use super::roaming_light::LocalLight;
use crate::cache::{CameraBake, FilmResponse, NeighbourFrames, PictureMemory};
use crate::film::Exposure;
use crate::scene::{FrameScene, StaticScene};
use crate::settings::{Gathering, RenderSettings};
use endless_world::{CameraLook, PinholeCamera, SensorFrame, SensorLayers};
use std::sync::Arc;

/// How fast exposure follows a street that gets darker, 1/s: in a second the difference falls to a third.
const DARKER_PER_S: f32 = 1.0;
/// The same of one that gets brighter.
const BRIGHTER_PER_S: f32 = 3.0;

/// Renders a scene for a camera whose way nobody knows beforehand. The first picture is exposed as it needs; from there on
/// exposure follows what is seen, without jumps. Its shutter is open for an instant.
pub struct RoamingCamera {
    settings: RenderSettings,
    exposure: Option<Exposure>,
    /// Of the picture before.
    memory: PictureMemory,
}

impl RoamingCamera {
    /// That has seen nothing yet. Its pictures are of the weather of the light that they are rendered in.
    pub fn new(settings: &RenderSettings) -> Self {
        let look = CameraLook { shutter_s: 0.0, ..settings.look };
        let settings = RenderSettings { look, gathering: Gathering::Probes, ..settings.clone() };
        Self { settings, exposure: None, memory: PictureMemory::default() }
    }

    /// What is wanted besides RGB, depth and instances: may change from picture to picture.
    pub fn layers_mut(&mut self) -> &mut SensorLayers {
        &mut self.settings.layers
    }

    /// What it sees, `step_s` seconds after its last picture, between two other instants, to which flow leads where it is
    /// wanted: they must tell where the camera is then.
    pub fn render(
        &mut self,
        still: &StaticScene,
        frame: &FrameScene,
        LocalLight(light): &LocalLight,
        camera: &PinholeCamera,
        neighbours: NeighbourFrames<'_>,
        step_s: f32,
    ) -> SensorFrame {
        let response =
            self.exposure.map(|exposure| Arc::new(FilmResponse::new(&self.settings, &light.environment, exposure)));
        let memory = std::mem::take(&mut self.memory);
        let here = CameraBake::from_here(still, &self.settings, camera, light, response.as_ref(), memory);
        let seen = here.render_at_once(still, frame, neighbours);
        self.exposure = Some(match self.exposure {
            Some(exposure) => exposure.followed(&here.wanted_exposure(), step_s, [DARKER_PER_S, BRIGHTER_PER_S]),
            None => here.exposure(),
        });
        self.memory = here.into_memory();
        seen
    }
}
