//! Renders a frame without the cache: the reference for frames with it.

use super::bake::CameraBake;
use super::centre_light::{CentreLight, centre_lights};
use super::developed_frame::DevelopedFrame;
use super::flow::NeighbourFrames;
use super::frame_buffer::{FrameBuffer, FramePixel};
use super::gbuffer::GBuffer;
use super::gbuffer_shading::{PrimarySample, gbuffer_bsdf, shade_pixel};
use super::mirror::mirrored;
use super::moving_hits::MovingHits;
use super::packed_hit::PackedHit;
use super::pixel::undisturbed;
use super::pixel_centre::BLOCK;
use super::primary_hits::{PackedNormals, PrimaryPixel};
use super::shaded_pixel::ShadedPixel;
use super::still_pixel::StillPixel;
use super::tile::TILE;
use super::tile_context::{PixelSamples, TileContext};
use super::tile_coverage::{CoveredPixel, coverages};
use super::tile_work::TileWork;
use crate::material::PackedBsdf;
use crate::sampling::SAMPLES;
use crate::scene::{FrameScene, StaticScene, SurfaceInteraction};
use crate::shade::{Tracer, shade_moving};
use endless_world::SensorFrame;

impl CameraBake {
    /// The same as [`Self::render`] without the cache: every sample traced and shaded again, every moving thing asked
    /// everywhere. Slow; its oracle. Needs [`crate::RenderSettings::keep_irradiance`].
    ///
    /// # Panics
    /// If the bake did not keep its irradiance.
    pub fn render_uncached(&self, still: &StaticScene, frame: &FrameScene) -> SensorFrame {
        self.finished(self.retraced(still, frame), still, frame, NeighbourFrames::default())
    }

    /// The same as [`Self::render_changing`] without the cache.
    ///
    /// # Panics
    /// If a bake did not keep its irradiance.
    pub fn render_changing_uncached(
        &self,
        (next, share): (&Self, f32),
        still: &StaticScene,
        frame: &FrameScene,
    ) -> SensorFrame {
        let mixed = self.retraced(still, frame).mixed(&next.retraced(still, frame), share);
        self.finished(mixed, still, frame, NeighbourFrames::default())
    }

    fn retraced(&self, still: &StaticScene, frame: &FrameScene) -> DevelopedFrame {
        assert_eq!(self.gbuffer.irradiance.len(), self.gbuffer.pixels(), "the bake kept no irradiance");
        let tracer = self.lighting.tracer(still, Some(frame));
        let everything = TileWork::everything(self.lighting.environment.night, still, frame);
        let context = TileContext { tracer: &tracer, frame, work: &everything, pixel_angle: self.pixel_angle };
        let mut buffer = FrameBuffer::new(self);
        for y0 in (0..self.camera.size.height).step_by(TILE as usize) {
            for x0 in (0..self.camera.size.width).step_by(TILE as usize) {
                self.retrace_tile(&context, (x0, y0), &mut buffer);
            }
        }
        buffer.develop(self, still, frame)
    }

    /// What the bake found of a pixel's visibility is traced again, but for the sun's disc and what is uniform.
    fn retraced_hits(&self, tracer: &Tracer<'_>, x: u32, y: u32) -> RetracedHits {
        let mut traced = RetracedHits::NONE;
        for sample in 0..SAMPLES {
            let ray = self.ray(x, y, sample);
            let Some(hit) = tracer.still.accel.closest(&ray) else { continue };
            let point = SurfaceInteraction::new(&tracer.still.instances, &ray, &hit);
            traced.distances[sample] = hit.t;
            traced.hits[sample] = PackedHit::new(&hit);
            traced.normals[sample] = PackedNormals::new(&point);
        }
        traced
    }

    /// A still pixel from nothing but the scene, the baked irradiance and what the bake found of the sun's disc.
    fn retrace(&self, tracer: &Tracer<'_>, primary: &PrimaryPixel<'_>, x: u32, y: u32) -> ShadedPixel {
        let pixel = (y * self.camera.size.width + x) as usize;
        let samples = std::array::from_fn(|sample| {
            let irradiance = self.gbuffer.irradiance[pixel][sample].get();
            PrimarySample { ray: self.ray(x, y, sample), hit: primary.hit(sample), irradiance }
        });
        ShadedPixel::new(primary, shade_pixel(tracer, &samples, primary.uniform, self.pixel_angle).each_ref())
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
                let hits = self.retraced_hits(&empty, x, y);
                let primary = hits.primary(&self.gbuffer, (y * self.camera.size.width + x) as usize);
                let shaded = self.retrace(&empty, &primary, x, y);
                let rays = std::array::from_fn(|s| self.ray(x, y, s));
                let found = MovingHits::one_by_one(environment, frame, &rays, &shaded.still(&primary));
                (x, y, hits, shaded, rays, found)
            })
            .collect();
        let covered = pixels.iter().map(|(x, y, .., rays, found)| CoveredPixel {
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
        for (x, y, hits, shaded, rays, found) in &pixels {
            let (x, y) = (*x, *y);
            let still = shaded.still(&hits.primary(&self.gbuffer, (y * self.camera.size.width + x) as usize));
            let light = self.retraced_centre(context, (x, y), &still);
            let pixel = match undisturbed(&still, still.radiance(environment), light.as_ref(), found) {
                Some(radiance) => FramePixel { radiance, covered: None, shadow: None, streak: None },
                None => {
                    let coverage = &coverages[((y - y0) * TILE + x - x0) as usize];
                    let mirrors = mirrored(tracer, &still, rays, found, self.pixel_angle);
                    let samples = PixelSamples { rays, still, found };
                    self.pixel(context, &samples, light.as_ref(), mirrors, coverage)
                }
            };
            buffer.set(self, [x, y], &pixel);
        }
    }

    /// The light that the samples of a pixel share, if it is uniform, from nothing but its retraced centre.
    fn retraced_centre(
        &self,
        context: &TileContext<'_>,
        (x, y): (u32, u32),
        still: &StillPixel<'_>,
    ) -> Option<CentreLight> {
        let hit = still.hit(0).filter(|_| still.uniform)?;
        let environment = context.tracer.environment;
        let ray = self.ray(x, y, 0);
        let point = SurfaceInteraction::new(&context.tracer.still.instances, &ray, &hit);
        let bsdf = PackedBsdf::new(&gbuffer_bsdf(&point, environment, 0, self.pixel_angle));
        let mut block = [None; BLOCK];
        block[0] = Some(still.centre(&ray, Some(&bsdf).filter(|_| environment.night)));
        Some(centre_lights(context, &self.camera, &block)[0])
    }
}

/// What a pixel's rays met, traced again.
struct RetracedHits {
    distances: [f32; SAMPLES],
    hits: [PackedHit; SAMPLES],
    normals: [PackedNormals; SAMPLES],
}

impl RetracedHits {
    /// Nothing but sky.
    const NONE: Self = Self {
        distances: [f32::MAX; SAMPLES],
        hits: [PackedHit::NONE; SAMPLES],
        normals: [PackedNormals::NONE; SAMPLES],
    };

    /// With what the bake found of the sun's disc, and whether the pixel is uniform.
    fn primary<'a>(&'a self, baked: &'a GBuffer, pixel: usize) -> PrimaryPixel<'a> {
        let Self { distances, hits, normals } = self;
        PrimaryPixel { distances, hits, normals, sun_free: &baked.sun_free[pixel], uniform: baked.uniform[pixel] }
    }
}
