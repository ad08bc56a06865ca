//! Frames of a moving camera, which share nothing but the scene.

use crate::accel::{Ray, RayStream};
use crate::camera_rays::sample_ray;
use crate::film::{ToneCurve, exposure};
use crate::indirect::IndirectRays;
use crate::lighting::{Lighting, ViewedArea};
use crate::material::{Bsdf, evaluate_bsdf};
use crate::pixel_layers::{LayerImages, PixelLayers};
use crate::scene::{FrameDescription, FrameScene, StaticScene, SurfaceInteraction};
use crate::settings::RenderSettings;
use crate::shade::{SceneHit, Tracer, footprint_m, lens_light, shade_interactions8};
use endless_world::{PinholeCamera, SensorFrame, SensorLayers};
use glam::Vec3A;
use rayon::prelude::*;

/// Lines of pixels that are traced together.
const LINES: usize = 4;
/// Pixels of a line that are traced together.
const COLUMNS: usize = 8;

/// The source of indirect light.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IndirectLight {
    /// The open sky, without occlusion.
    OpenSky,
    /// Irradiance probes, baked once for all cameras: two bounces.
    Probes,
}

/// Renders a scene for a camera that moves, one ray a pixel: direct light with hard shadows, indirect light, fog, and the
/// open sky in mirrors. Faster than a [`CameraBake`](crate::CameraBake) for one frame and slower for many; lights of
/// vehicles are seen, but light nothing, and what lens and recorder do is left out. Its frames have neither flow nor the layer
/// of shadows.
pub struct MovingCamera {
    settings: RenderSettings,
    lighting: Lighting,
    tone: ToneCurve,
}

impl MovingCamera {
    /// Exposed for the first of these cameras along the way; probes are baked for what is seen from all of them.
    pub fn new(still: &StaticScene, settings: &RenderSettings, indirect: IndirectLight, way: &[PinholeCamera]) -> Self {
        let areas = way.iter().map(|camera| ViewedArea::of(still, camera));
        let area = areas.reduce(|a, b| a.joined(&b)).unwrap_or(ViewedArea::EMPTY);
        let lighting = Lighting::direct(still, settings, &area);
        let lighting = match indirect {
            IndirectLight::OpenSky => lighting,
            IndirectLight::Probes => lighting.with_probes(still, settings, &area, IndirectRays::Trace).0,
        };
        let nothing = FrameScene::new(FrameDescription::default());
        let tracer = lighting.tracer(still, Some(&nothing));
        let radiance = way
            .first()
            .map_or_else(Vec::new, |camera| TracedImage::trace(&tracer, camera, SensorLayers::default()).radiance);
        let environment = &lighting.environment;
        let exposure = exposure(&radiance, Vec3A::ZERO, environment.exposure_key);
        let tone = ToneCurve::new(exposure, environment.white_balance(), Vec3A::ZERO);
        Self { settings: settings.clone(), lighting, tone }
    }

    /// What a camera sees at an instant; the picture has the camera's own size and lens.
    pub fn render(&self, still: &StaticScene, frame: &FrameScene, camera: &PinholeCamera) -> SensorFrame {
        let size = camera.size;
        let wanted = SensorLayers { shadow: false, ..self.settings.layers };
        let TracedImage { radiance, layers: pixels } =
            TracedImage::trace(&self.lighting.tracer(still, Some(frame)), camera, wanted);
        let rgb = radiance.par_iter().map(|&r| self.tone.apply(r)).collect();
        let mut layers = LayerImages::with_capacity(wanted, size.pixels());
        pixels.iter().for_each(|pixel| layers.push(pixel));
        layers.into_sensor_frame(frame.frame, size, rgb)
    }
}

/// The layers of a camera before the film is applied.
struct TracedImage {
    radiance: Vec<Vec3A>,
    layers: Vec<PixelLayers>,
}

impl TracedImage {
    fn trace(tracer: &Tracer<'_>, camera: &PinholeCamera, wanted: SensorLayers) -> Self {
        let count = camera.size.pixels();
        let mut view = Self { radiance: vec![Vec3A::ZERO; count], layers: vec![PixelLayers::SKY; count] };
        let band = LINES * camera.size.width as usize;
        view.radiance.par_chunks_mut(band).zip(view.layers.par_chunks_mut(band)).enumerate().for_each(
            |(i, (radiance, layers))| {
                ImageBand { tracer, camera, wanted, first_line: i * LINES, radiance, layers }.trace();
            },
        );
        view
    }
}

/// A band of lines of an image.
struct ImageBand<'a> {
    tracer: &'a Tracer<'a>,
    camera: &'a PinholeCamera,
    wanted: SensorLayers,
    first_line: usize,
    radiance: &'a mut [Vec3A],
    layers: &'a mut [PixelLayers],
}

impl ImageBand<'_> {
    fn trace(&mut self) {
        let width = self.camera.size.width as usize;
        let lines = self.radiance.len() / width;
        for first in (0..width).step_by(COLUMNS) {
            let columns = (width - first).min(COLUMNS);
            let rays: [[Ray; COLUMNS]; LINES] = std::array::from_fn(|line| {
                std::array::from_fn(|i| {
                    // Beyond the edge the last ray is repeated, and not traced.
                    let (x, y) = (first + i.min(columns - 1), self.first_line + line.min(lines - 1));
                    sample_ray(self.camera, x as u32, y as u32, 0)
                })
            });
            let active = ((1u16 << columns) - 1) as u8;
            let all = (0..lines).fold(0, |bits, line| bits | u32::from(active) << (COLUMNS * line));
            let hits = self.tracer.closest32(&RayStream::of(&rays), all);
            for (line, (rays, hits)) in rays.iter().zip(&hits).enumerate().take(lines) {
                self.shade(line * width + first, rays, hits, active);
            }
        }
    }

    /// Up to eight pixels of a line.
    fn shade(&mut self, first: usize, rays: &[Ray; COLUMNS], hits: &[Option<SceneHit>; COLUMNS], active: u8) {
        let environment = self.tracer.environment;
        let pixel_angle = 1.0 / self.camera.intrinsics.fx;
        let points: [Option<(SurfaceInteraction<'_>, Bsdf)>; COLUMNS] = std::array::from_fn(|i| {
            let point = self.tracer.point(&rays[i], hits[i].as_ref()?);
            let bsdf = evaluate_bsdf(&point, environment, footprint_m(&point.facet(), pixel_angle), 0.5);
            Some((point, bsdf))
        });
        let shaded = shade_interactions8(self.tracer, rays, &points, active);
        for i in (0..COLUMNS).filter(|i| active >> i & 1 == 1) {
            self.radiance[first + i] = shaded[i];
            let Some((point, bsdf)) = &points[i] else { continue };
            if let Some(frame) = self.tracer.moving {
                let lens = lens_light(frame, point, environment.night);
                self.radiance[first + i] +=
                    lens * environment.fog.transmittance(rays[i].origin, rays[i].direction, point.distance);
            }
            self.layers[first + i] = PixelLayers::new(self.wanted, self.camera, &rays[i], point, || bsdf.clone());
        }
    }
}
