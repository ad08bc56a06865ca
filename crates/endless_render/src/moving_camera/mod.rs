//! Cameras that move: the same pictures as of fixed ones, but nothing is kept from frame to frame save the light.
//!
//! A frame is a [`CameraBake`] made for one instant, so that both share their definition, all layers and all code. Only light
//! that bounced differs: it comes from probes along the way, because gathered light has a pattern of its own in each picture,
//! which would crawl over what is seen.
//!
//! A [`MovingCamera`] knows its whole way beforehand; a [`RoamingCamera`] does not, and takes its light from a [`RoamingLight`].
//! Where no colours are wanted, [`render_labels`] tells the rest.

mod labels;
mod roaming_camera;
mod roaming_light;

pub use labels::render_labels;
pub use roaming_camera::RoamingCamera;
pub use roaming_light::{LocalLight, RoamingLight};

use crate::cache::{CameraBake, FilmResponse, NeighbourFrames, PictureMemory, ScratchPool};
use crate::film::Exposure;
use crate::indirect::IndirectRays;
use crate::lighting::{Lighting, ViewedArea};
use crate::scene::{FrameScene, StaticScene};
use crate::settings::{Gathering, RenderSettings};
use endless_world::{CameraLook, ImageSize, Intrinsics, PinholeCamera, SensorFrame};
use std::sync::Arc;

/// Places along a way for whose pictures a camera is exposed.
const EXPOSED_FOR: usize = 4;
/// Width of these pictures, at most.
const EXPOSED_WIDTH: u32 = 320;

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
    /// Of pictures that are made.
    memory: ScratchPool<PictureMemory>,
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
        // As fixed cameras there would be.
        let gathered = RenderSettings { gathering: Gathering::default(), ..settings.clone() };
        let exposed = |camera: &PinholeCamera| {
            let small = reduced(camera);
            let settings = RenderSettings { size: small.size, ..gathered.clone() };
            CameraBake::from_here(still, &settings, &small, &lighting, None, PictureMemory::default()).exposure()
        };
        let exposures: Vec<Exposure> = places(way).map(exposed).collect();
        let exposure = Exposure::mean(&exposures).unwrap_or(Exposure::NONE);
        let response = Arc::new(FilmResponse::new(&settings, &lighting.environment, exposure));
        let memory = ScratchPool::for_pixels(settings.size.pixels());
        Self { settings, lighting, response, memory }
    }

    /// What a camera sees at an instant; the picture has the camera's own size and lens. Flow is unknown.
    pub fn render(&self, still: &StaticScene, frame: &FrameScene, camera: &PinholeCamera) -> SensorFrame {
        self.render_between(still, frame, camera, NeighbourFrames::default())
    }

    /// The same between two other instants, to which flow leads where it is wanted: they must tell where the camera is then.
    pub fn render_between(
        &self,
        still: &StaticScene,
        frame: &FrameScene,
        camera: &PinholeCamera,
        neighbours: NeighbourFrames<'_>,
    ) -> SensorFrame {
        let here = self.from(still, camera);
        let seen = here.render_between(still, frame, neighbours);
        self.memory.give(here.into_memory());
        seen
    }

    /// The same at an instant at which the light is a share of the way, 0 to 1, from that of this camera to that of the next:
    /// a mixture of both pictures.
    pub fn render_changing(
        &self,
        (next, share): (&Self, f32),
        still: &StaticScene,
        frame: &FrameScene,
        camera: &PinholeCamera,
        neighbours: NeighbourFrames<'_>,
    ) -> SensorFrame {
        let (here, then) = (self.from(still, camera), next.from(still, camera));
        let seen = here.render_changing((&then, share), still, frame, neighbours);
        self.memory.give(here.into_memory());
        next.memory.give(then.into_memory());
        seen
    }

    fn from(&self, still: &StaticScene, camera: &PinholeCamera) -> CameraBake {
        let memory = self.memory.take(PictureMemory::default);
        CameraBake::from_here(still, &self.settings, camera, &self.lighting, Some(&self.response), memory)
    }
}

/// The same view in a small picture.
fn reduced(camera: &PinholeCamera) -> PinholeCamera {
    let ImageSize { width, height } = camera.size;
    let share = EXPOSED_WIDTH.min(width) as f32 / width as f32;
    let less = |pixels: u32| ((pixels as f32 * share).round() as u32).max(1);
    let Intrinsics { fx, fy, cx, cy } = camera.intrinsics;
    let intrinsics = Intrinsics { fx: fx * share, fy: fy * share, cx: cx * share, cy: cy * share };
    PinholeCamera { size: ImageSize { width: less(width), height: less(height) }, intrinsics, ..camera.clone() }
}

/// Some places of a way, evenly spaced, each once.
fn places(way: &[PinholeCamera]) -> impl Iterator<Item = &PinholeCamera> {
    let last = way.len().saturating_sub(1);
    let count = way.len().min(EXPOSED_FOR);
    (0..count).map(move |k| &way[k * last / (count - 1).max(1)])
}
