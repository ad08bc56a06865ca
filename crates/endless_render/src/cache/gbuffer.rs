//! The primary hits of a fixed camera, by sample and by pixel.

use super::bake_pass::BakePass;
use super::bake_stats::timed;
use super::gbuffer_row::GBufferRow;
use super::irradiance::{GatheredLight, IrradiancePass};
use super::picture_memory::PictureMemory;
use super::primary_hits::{PrimaryHits, PrimaryRow};
use super::row_block::ShadedRow;
use super::sparse_primary::KeptRow;
use super::still_pixel::StillPixel;
use crate::indirect::TapeStack;
use crate::material::PackedBsdf;
use crate::pixel_layers::LayerImages;
use crate::rgb9e5::Rgb9e5;
use crate::sampling::SAMPLES;
use crate::settings::Gathering;
use crate::work_share;
use glam::Vec3A;
use rayon::prelude::*;

/// The G-buffer of what stands still: all by pixel, row-major.
pub(super) struct GBuffer {
    width: usize,
    /// How far each sample lies from the lens, metres; [`f32::MAX`] for the sky.
    pub(super) distances: Vec<[f32; SAMPLES]>,
    /// Which directions to the sun's disc the static scene leaves each sample, a bit each.
    pub(super) sun_free: Vec<[u8; SAMPLES]>,
    /// All four samples of the pixel lie on one smooth piece that gives no light of its own: what moves does the same to
    /// the light of all four, so that is found once.
    pub(super) uniform: Vec<bool>,
    /// The rest, row by row.
    rows: Vec<GBufferRow>,
    /// What each pixel's centre shows in all layers but RGB.
    pub(super) layers: LayerImages,
    /// Gathered at each sample, klx, if it is kept.
    pub(super) irradiance: Vec<[Rgb9e5; SAMPLES]>,
}

impl GBuffer {
    /// Traces and shades what stands still; gives its radiance, kcd/m², and the ends of the rays that gathered light, if
    /// these are to be kept.
    pub(super) fn bake(pass: &BakePass<'_>, memory: PictureMemory) -> (Self, Vec<Vec3A>, [TapeStack; 2]) {
        if pass.settings.gathering == Gathering::Probes {
            let (gbuffer, radiance) = Self::for_an_instant(pass, memory);
            return (gbuffer, radiance, Default::default());
        }
        let mut primary = timed("primary", || pass.trace());
        let GatheredLight { irradiance, points, edges } =
            timed("gather", || IrradiancePass { bake: pass, primary: &primary }.gather());
        let surfaces = std::mem::take(&mut primary.surfaces);
        let mut radiance = vec![Vec3A::ZERO; pass.camera.size.pixels()];
        let (rows, layers) = timed("shade", || pass.shade(&primary, surfaces, &irradiance, &mut radiance));
        let PrimaryHits { distances, sun_free, uniform, .. } = primary;
        let irradiance = if pass.settings.keep_irradiance { irradiance } else { Vec::new() };
        let gbuffer = Self { width: pass.width(), distances, sun_free, uniform, rows, layers, irradiance };
        (gbuffer, radiance, [points, edges])
    }

    /// The same in the light of probes. Each row is shaded as soon as it is traced: what it lies on never leaves the
    /// processor's caches.
    fn for_an_instant(pass: &BakePass<'_>, memory: PictureMemory) -> (Self, Vec<Vec3A>) {
        let (width, pixels) = (pass.width(), pass.camera.size.pixels());
        let sparse = pass.trace_sparse();
        let memory = memory.resized(pixels, pass.camera.size.height as usize);
        let PictureMemory { mut distances, mut sun_free, mut uniform, mut radiance, mut rows } = memory;
        let kept = distances.par_chunks_mut(width).zip(sun_free.par_chunks_mut(width));
        let kept = kept.zip(uniform.par_chunks_mut(width)).zip(radiance.par_chunks_mut(width));
        let kept = kept.zip(&mut rows).enumerate().with_max_len(work_share::ROWS);
        let layers = kept.map(|(y, ((((distances, sun_free), uniform), radiance), row))| {
            let kept = KeptRow { distances: &mut *distances, sun_free: &mut *sun_free, uniform: &mut *uniform };
            let surfaces = sparse.trace_row(y, kept);
            let primary = PrimaryRow { distances, sun_free, uniform, surfaces: &surfaces };
            pass.shade_row(ShadedRow { y, primary, irradiance: None }, row, radiance)
        });
        let layers: Vec<LayerImages> = timed("shade", || layers.collect());
        pass.stats.add((pixels * SAMPLES) as u64);
        let layers = LayerImages::of_rows(pass.settings.layers, layers);
        (Self { width, distances, sun_free, uniform, rows, layers, irradiance: Vec::new() }, radiance)
    }

    /// Its memory, with that of the picture's radiance.
    pub(super) fn into_memory(self, radiance: Vec<Vec3A>) -> PictureMemory {
        let Self { distances, sun_free, uniform, rows, .. } = self;
        PictureMemory { distances, sun_free, uniform, radiance, rows }
    }

    /// A pixel, by its place in the picture.
    pub(super) fn pixel(&self, pixel: usize) -> StillPixel<'_> {
        let row = &self.rows[pixel / self.width];
        row.pixel(pixel % self.width, &self.distances[pixel], &self.sun_free[pixel], self.uniform[pixel])
    }

    /// Which of up to 32 pixels of a row, the first of which is given, mirror at all, and which lie on lenses of traffic lights,
    /// a bit each.
    pub(super) fn mirroring_and_lenses(&self, first: usize, count: usize) -> [u32; 2] {
        self.rows[first / self.width].mirroring_and_lenses(first % self.width, count)
    }

    /// All pixels.
    pub(super) fn pixels(&self) -> usize {
        self.uniform.len()
    }

    /// At night, the BSDF of a pixel's centre if the pixel is uniform.
    pub(super) fn centre_bsdf(&self, pixel: usize) -> Option<&PackedBsdf> {
        let (y, x) = (pixel / self.width, pixel % self.width);
        self.rows[y].bsdf(x, &self.uniform[y * self.width..(y + 1) * self.width])
    }
}
