//! Renders a frame without the cache: the reference for frames with it.

use super::bake::CameraBake;
use super::centre_light::{CentreLight, centre_lights};
use super::frame_buffer::{FrameBuffer, FramePixel};
use super::gbuffer_pixel::GBufferPixel;
use super::gbuffer_sample::{GBufferSample, still_light};
use super::gbuffer_shading::{PrimarySample, gbuffer_bsdf, shade_pixel};
use super::mirror::mirrored;
use super::moving_hits::MovingHits;
use super::pixel::undisturbed;
use super::tile::TILE;
use super::tile_context::{PixelSamples, TileContext};
use super::tile_coverage::{CoveredPixel, coverages};
use super::tile_work::TileWork;
use crate::sampling::SAMPLES;
use crate::scene::{FrameScene, StaticScene, SurfaceInteraction};
use crate::shade::{Tracer, shade_moving};
use endless_world::SensorFrame;
use glam::Vec3A;

impl CameraBake {
    /// The same as [`Self::render`] without the cache: every sample traced and shaded again, every moving thing asked
    /// everywhere. Slow; its oracle. Needs [`crate::RenderSettings::keep_irradiance`].
    ///
    /// # Panics
    /// If the bake did not keep its irradiance.
    pub fn render_uncached(&self, still: &StaticScene, frame: &FrameScene) -> SensorFrame {
        assert_eq!(self.gbuffer.irradiance.len(), self.gbuffer.samples.len(), "the bake kept no irradiance");
        let tracer = self.lighting.tracer(still, Some(frame));
        let everything = TileWork::everything(self.lighting.environment.night, still, frame);
        let context = TileContext { tracer: &tracer, frame, work: &everything, pixel_angle: self.pixel_angle };
        let mut buffer = FrameBuffer::new(self);
        for y0 in (0..self.camera.size.height).step_by(TILE as usize) {
            for x0 in (0..self.camera.size.width).step_by(TILE as usize) {
                self.retrace_tile(&context, (x0, y0), &mut buffer);
            }
        }
        buffer.develop(self, frame.frame)
    }

    /// A pixel's still samples from nothing but the scene, the baked irradiance and what the bake found of the sun's disc.
    fn retrace(&self, tracer: &Tracer<'_>, x: u32, y: u32) -> [GBufferSample; SAMPLES] {
        let pixel = (y * self.camera.size.width + x) as usize;
        let samples = std::array::from_fn(|sample| {
            let ray = self.ray(x, y, sample);
            let hit = tracer.still.accel.closest(&ray);
            let index = pixel * SAMPLES + sample;
            let irradiance = Vec3A::from(self.gbuffer.irradiance[index]);
            PrimarySample { ray, hit, sun_free: self.gbuffer.samples[index].sun_free, irradiance }
        });
        shade_pixel(tracer, &samples, self.gbuffer.uniform[pixel], self.pixel_angle)
    }

    /// A tile from nothing but the scene, the baked irradiance and what the bake found of the sun's disc, a ray at a time.
    fn retrace_tile(&self, context: &TileContext<'_>, (x0, y0): (u32, u32), buffer: &mut FrameBuffer) {
        let TileContext { tracer, frame, .. } = *context;
        let environment = tracer.environment;
        let empty = Tracer { moving: None, ..*tracer };
        let (x1, y1) = self.tile_end(x0, y0);
        let places = (y0..y1).flat_map(|y| (x0..x1).map(move |x| (x, y)));
        let pixels: Vec<_> = places
            .map(|(x, y)| {
                let uniform = self.gbuffer.uniform[(y * self.camera.size.width + x) as usize];
                let samples = self.retrace(&empty, x, y);
                let rays = std::array::from_fn(|s| self.ray(x, y, s));
                let found = MovingHits::one_by_one(environment, frame, &rays, &samples, uniform);
                (x, y, samples, rays, found)
            })
            .collect();
        let covered = pixels.iter().map(|(x, y, _, rays, found)| CoveredPixel {
            place: ((y - y0) * TILE + x - x0) as usize,
            rays: *rays,
            found,
        });
        let coverages = coverages(
            self,
            frame,
            covered,
            |seen| seen.iter().map(|seen| shade_moving(tracer, seen, self.pixel_angle)).collect(),
            |place, seen| self.halo((x0, y0), place, seen),
        );
        for (x, y, samples, rays, found) in &pixels {
            let (x, y) = (*x, *y);
            let light = self.retraced_centre(context, (x, y), samples);
            let still = still_light(samples, environment);
            let pixel = match undisturbed(still, light.as_ref(), found) {
                Some(radiance) => FramePixel { radiance, covered: None, streak: None },
                None => {
                    let coverage = &coverages[((y - y0) * TILE + x - x0) as usize];
                    let mirrors = mirrored(tracer, samples, rays, found, self.pixel_angle);
                    let samples = PixelSamples { rays, still: samples, found };
                    self.pixel(context, &samples, light.as_ref(), mirrors, coverage)
                }
            };
            buffer.set(self, x, y, &pixel);
        }
    }

    /// The light that the samples of a pixel share, if it is uniform, from nothing but its retraced centre.
    fn retraced_centre(
        &self,
        context: &TileContext<'_>,
        (x, y): (u32, u32),
        samples: &[GBufferSample; SAMPLES],
    ) -> Option<CentreLight> {
        if !self.gbuffer.uniform[(y * self.camera.size.width + x) as usize] {
            return None;
        }
        let environment = context.tracer.environment;
        let ray = self.ray(x, y, 0);
        let point = SurfaceInteraction::new(&context.tracer.still.instances, &ray, &samples[0].hit);
        let bsdf = gbuffer_bsdf(&point, environment, 0, self.pixel_angle);
        let mut row = [None; 8];
        row[0] = Some(GBufferPixel::new(samples).centre(&ray, Some(&bsdf).filter(|_| environment.night)));
        Some(centre_lights(context, Vec3A::from(self.camera.position), &row)[0])
    }
}
