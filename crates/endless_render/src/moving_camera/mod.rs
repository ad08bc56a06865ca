//! Cameras that move: the same pictures as of fixed ones, but nothing is kept from frame to frame save the light.
//!
//! A frame is a [`CameraBake`] made for one instant, so that both share their definition, all layers and all code. Only light
//! that bounced differs: it comes from probes along the way, because gathered light has a pattern of its own in each picture,
//! which would crawl over what is seen.

use crate::cache::{CameraBake, FilmResponse, NeighbourFrames};
use crate::film::Exposure;
use crate::indirect::IndirectRays;
use crate::lighting::{Lighting, ViewedArea};
use crate::scene::{FrameScene, StaticScene};
use crate::settings::{Gathering, RenderSettings};
use endless_world::{CameraLook, PinholeCamera, SensorFrame};
use std::sync::Arc;

/// Places along a way for whose pictures a camera is exposed.
const EXPOSED_FOR: usize = 4;

/// The source of indirect light.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IndirectLight {
    /// The open sky, without occlusion.
    OpenSky,
    /// Irradiance probes, baked once for all cameras: two bounces.
    Probes,
}

/// Renders a scene for a camera that moves. For one frame it is faster than a [`CameraBake`], and slower for many. Its shutter
/// is open for an instant: what moves is not blurred.
pub struct MovingCamera {
    settings: RenderSettings,
    lighting: Arc<Lighting>,
    response: Arc<FilmResponse>,
}

impl MovingCamera {
    /// Exposed for what is seen along the way, where there are probes, too.
    pub fn new(still: &StaticScene, settings: &RenderSettings, indirect: IndirectLight, way: &[PinholeCamera]) -> Self {
        let look = CameraLook { shutter_s: 0.0, ..settings.look };
        let settings = RenderSettings { look, gathering: Gathering::Probes, ..settings.clone() };
        let areas = way.iter().map(|camera| ViewedArea::of(still, camera));
        let area = areas.reduce(|a, b| a.joined(&b)).unwrap_or(ViewedArea::EMPTY);
        let lighting = Lighting::direct(still, &settings, &area);
        let lighting = Arc::new(match indirect {
            IndirectLight::OpenSky => lighting,
            IndirectLight::Probes => lighting.with_probes(still, &settings, &area, IndirectRays::Trace).0,
        });
        let exposures: Vec<Exposure> = places(way)
            .map(|camera| CameraBake::from_here(still, &settings, camera, &lighting, None).exposure())
            .collect();
        let exposure = Exposure::mean(&exposures).unwrap_or(Exposure::NONE);
        let response = Arc::new(FilmResponse::new(&settings, &lighting.environment, exposure));
        Self { settings, lighting, response }
    }

    /// What a camera sees at an instant; the picture has the camera's own size and lens.
    pub fn render(&self, still: &StaticScene, frame: &FrameScene, camera: &PinholeCamera) -> SensorFrame {
        self.from(still, camera).render_between(still, frame, NeighbourFrames::default())
    }

    fn from(&self, still: &StaticScene, camera: &PinholeCamera) -> CameraBake {
        CameraBake::from_here(still, &self.settings, camera, &self.lighting, Some(&self.response))
    }
}

/// Some places of a way, evenly spaced, each once.
fn places(way: &[PinholeCamera]) -> impl Iterator<Item = &PinholeCamera> {
    let last = way.len().saturating_sub(1);
    let count = way.len().min(EXPOSED_FOR);
    (0..count).map(move |k| &way[k * last / (count - 1).max(1)])
}
