//! The film of a fixed camera: the static picture's radiance, and its conversion to pixels.

use super::gbuffer::GBuffer;
use super::scratch_pool::ScratchPool;
use crate::camera_rays::{is_nowhere, sample_ray};
use crate::film::{BlurScratch, Exposure, PostProcess, Rain, ToneCurve, black_level, exposure};
use crate::light::Environment;
use crate::material::noise;
use crate::settings::RenderSettings;
use endless_world::{Lens, PinholeCamera, math};
use glam::Vec3A;
use rayon::prelude::*;
use std::borrow::Cow;
use std::sync::Arc;

/// One of so many pixels tells how a picture is exposed.
const EVERY: usize = 7;

/// The still picture on a camera's film.
pub(super) struct CameraFilm {
    /// Its radiance, kcd/m².
    pub(super) radiance: Vec<Vec3A>,
    /// The pixels in whose centres the lens shows nothing: black, whatever light spreads there.
    pub(super) unlit: Vec<u32>,
    /// As it is developed, if frames need not be developed whole.
    pub(super) rgb: Vec<[u8; 3]>,
    pub(super) response: Arc<FilmResponse>,
    /// Copies of the radiance, for frames: of this picture alone, where pictures share a response.
    pub(super) radiance_pool: ScratchPool<Vec<Vec3A>>,
}

/// How radiance becomes a picture: the same in all frames of a video.
pub(crate) struct FilmResponse {
    exposure: Exposure,
    pub(super) tone: ToneCurve,
    pub(super) rain: Option<Rain>,
    /// How long the shutter is open.
    pub(super) shutter_s: f32,
    /// Share of light that spreads around bright objects.
    pub(super) glare: f32,
    /// Effects of lens, sensor and recorder, if any.
    pub(super) post_process: Option<PostProcess>,
    /// Pictures on their way through the lens.
    pub(super) lens_scratch: ScratchPool<Vec<Vec3A>>,
    pub(super) blur_scratch: ScratchPool<BlurScratch>,
}

impl CameraFilm {
    /// Of a still picture's radiance, kcd/m²; exposed for it, or as it is given.
    pub(super) fn new(
        settings: &RenderSettings,
        camera: &PinholeCamera,
        environment: &Environment,
        gbuffer: &GBuffer,
        radiance: Vec<Vec3A>,
        response: Option<&Arc<FilmResponse>>,
    ) -> Self {
        let unlit = unlit(camera);
        let response = response.cloned().unwrap_or_else(|| {
            let exposure = Exposure::for_picture(camera, environment, gbuffer, &radiance, &unlit, EVERY);
            Arc::new(FilmResponse::new(settings, environment, exposure))
        });
        let spreads_light = response.spreads_light();
        let radiance_pool = ScratchPool::for_pixels(radiance.len());
        let film = Self { radiance, unlit, rgb: Vec::new(), response, radiance_pool };
        if spreads_light {
            return film;
        }
        let mut rgb = Vec::new();
        film.response.tone.append(&film.radiance, &mut rgb);
        film.darken(&mut rgb);
        Self { rgb, ..film }
    }

    /// As [`Exposure::for_picture`] finds it from some pixels of this picture.
    pub(super) fn wanted_exposure(
        &self,
        camera: &PinholeCamera,
        environment: &Environment,
        gbuffer: &GBuffer,
    ) -> Exposure {
        Exposure::for_picture(camera, environment, gbuffer, &self.radiance, &self.unlit, 5 * EVERY)
    }

    /// Makes black what the lens does not show.
    pub(super) fn darken(&self, rgb: &mut [[u8; 3]]) {
        for &pixel in &self.unlit {
            rgb[pixel as usize] = [0; 3];
        }
    }
}

/// The pixels in whose centres a camera's lens shows nothing.
fn unlit(camera: &PinholeCamera) -> Vec<u32> {
    if matches!(camera.lens, Lens::Perspective(_)) {
        return Vec::new();
    }
    let width = camera.size.width;
    let is_unlit = |&i: &u32| is_nowhere(&sample_ray(camera, i % width, i / width, 0));
    (0..camera.size.pixels() as u32).into_par_iter().filter(is_unlit).collect()
}

impl Exposure {
    /// As a still picture of this radiance needs it, but for the pixels in which the lens shows nothing; asks one of `every`
    /// so many pixels.
    fn for_picture(
        camera: &PinholeCamera,
        environment: &Environment,
        gbuffer: &GBuffer,
        radiance: &[Vec3A],
        unlit: &[u32],
        every: usize,
    ) -> Self {
        let width = camera.size.width as usize;
        let lit: Vec<u32> = match unlit.is_empty() {
            true => Vec::new(),
            false => (0..radiance.len() as u32).filter(|i| unlit.binary_search(i).is_err()).collect(),
        };
        let shown: Cow<'_, [Vec3A]> = match unlit.is_empty() {
            true => radiance.into(),
            false => lit.iter().map(|&i| radiance[i as usize]).collect::<Vec<_>>().into(),
        };
        let black = black_level(&shown, every, |i| {
            let i = lit.get(i).map_or(i, |&i| i as usize);
            let (ray, still) = (sample_ray(camera, (i % width) as u32, (i / width) as u32, 0), gbuffer.pixel(i));
            let fog = &environment.fog;
            let left = fog.transmittance(ray.origin, ray.direction, still.distances[0]);
            if still.is_sky(0) { Vec3A::ZERO } else { fog.in_scatter(ray.direction, left) }
        });
        Self { factor: exposure(&shown, black, environment.exposure_key, every), black }
    }
}

impl FilmResponse {
    /// At this exposure.
    pub(crate) fn new(settings: &RenderSettings, environment: &Environment, exposure: Exposure) -> Self {
        let pixels = settings.size.pixels();
        let off = Vec3A::from(settings.look.white_balance) * math::exp2(settings.look.exposure_stops);
        let white_balance = environment.white_balance() * off;
        Self {
            exposure,
            tone: ToneCurve::new(exposure.factor, white_balance, exposure.black)
                .set_to(settings.look.contrast, settings.look.saturation),
            rain: rain(environment, exposure.factor, settings.seed),
            shutter_s: settings.look.shutter_s.min(1.0 / settings.fps as f32),
            glare: environment.glare,
            post_process: PostProcess::new(
                &settings.look,
                settings.size,
                settings.fps,
                settings.seed,
                environment.rain,
            ),
            lens_scratch: ScratchPool::for_pixels(pixels),
            blur_scratch: ScratchPool::for_pixels(pixels),
        }
    }

    /// How it is exposed.
    pub(crate) fn exposure(&self) -> Exposure {
        self.exposure
    }

    /// Whether all of a frame must be developed again: glare and lens change every pixel.
    pub(super) fn spreads_light(&self) -> bool {
        self.glare > 0.0 || self.post_process.as_ref().is_some_and(PostProcess::has_lens)
    }
}

/// Rain in front of the lens: as bright as the picture's own surroundings make drops.
fn rain(environment: &Environment, exposure: f32, seed: u64) -> Option<Rain> {
    (environment.rain > 0.0).then(|| {
        let radiance =
            if environment.night { Vec3A::new(1.0, 0.9, 0.78) * (0.16 / exposure) } else { environment.sky.mean * 1.1 };
        let slant = (noise::cell1(seed as u32, 5) - 0.5) * 0.3;
        Rain { drops: (3600.0 * environment.rain) as u32, radiance, slant, seed }
    })
}
