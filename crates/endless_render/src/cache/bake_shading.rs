//! The pass of a bake that shades what the samples see, row by row.

use super::bake_pass::BakePass;
use super::block_light::{BlockLight, KeptLight};
use super::block_shading::THIRD;
use super::gbuffer_row::GBufferRow;
use super::gbuffer_sample::{GBufferSample, LitHit};
use super::primary_hits::{PrimaryHits, PrimaryPixel, PrimaryRow, RowSurfaces};
use super::row_block::{BLOCK, RowBlock, ShadedRow};
use crate::pixel_layers::LayerImages;
use crate::rgb9e5::Rgb9e5;
use crate::sampling::SAMPLES;
use crate::work_share;
use glam::Vec3A;
use rayon::prelude::*;

impl BakePass<'_> {
    /// Shades all pixels, which needs what `surfaces` tell of each row, and tells what their centres show in all layers but
    /// RGB, and their radiance while nothing moves.
    pub(super) fn shade(
        &self,
        primary: &PrimaryHits,
        surfaces: Vec<RowSurfaces>,
        irradiance: &[[Rgb9e5; SAMPLES]],
        radiance: &mut [Vec3A],
    ) -> (Vec<GBufferRow>, LayerImages) {
        self.stats.add((primary.uniform.len() * SAMPLES) as u64);
        let width = self.width();
        let PrimaryHits { distances, sun_free, uniform, .. } = primary;
        let rows =
            surfaces.into_par_iter().zip(radiance.par_chunks_mut(width)).enumerate().with_max_len(work_share::ROWS);
        let rows = rows.map(|(y, (surfaces, radiance))| {
            let pixels = y * width..(y + 1) * width;
            let (distances, sun_free) = (&distances[pixels.clone()], &sun_free[pixels.clone()]);
            let row = PrimaryRow { distances, sun_free, uniform: &uniform[pixels.clone()], surfaces: &surfaces };
            let mut kept = GBufferRow::default();
            let row = ShadedRow { y, primary: row, irradiance: irradiance.get(pixels) };
            let layers = self.shade_row(row, &mut kept, radiance);
            (kept, layers)
        });
        let (rows, layers): (Vec<GBufferRow>, Vec<LayerImages>) = rows.unzip();
        (rows, LayerImages::of_rows(self.settings.layers, layers))
    }

    /// Shades a row, writes what is kept of it and its radiance while nothing moves, and tells its other layers.
    pub(super) fn shade_row(&self, shaded: ShadedRow<'_>, row: &mut GBufferRow, radiance: &mut [Vec3A]) -> LayerImages {
        let primary = shaded.primary;
        let width = self.width();
        let night = self.tracer.environment.night;
        row.clear_for((0..width).map(|x| primary.pixel(x)));
        let mut layers = LayerImages::with_capacity(self.settings.layers, width);
        let mut hits = Vec::new();
        // Large, so they are never moved.
        let (block, light) = (&mut RowBlock::new(self, shaded), &mut BlockLight::new());
        for first in (0..width).step_by(BLOCK) {
            let count = (width - first).min(BLOCK);
            block.look_at(first, count);
            block.shade(light);
            for pixel in 0..count {
                let seen = primary.pixel(first + pixel);
                block.push_pixel(pixel, &seen, light, row);
                layers.push(&light.layers[pixel].with_shadow(self.still_shadow(&seen)));
                if night {
                    row.push_bsdf(first + pixel, light.bsdfs[pixel].take());
                    hits.extend((0..seen.kept_samples()).map(|sample| LitHit {
                        hit: seen.hits[sample],
                        lamps_free: light.get(block.told_by[BLOCK * sample + pixel]).lamps_free,
                    }));
                }
            }
        }
        // By day only what traffic lights show is asked again.
        if !night && row.has_lenses() {
            let seen = (0..width).map(|x| primary.pixel(x));
            hits.extend(seen.flat_map(|seen| {
                (0..seen.kept_samples()).map(move |sample| LitHit { hit: seen.hits[sample], lamps_free: 0 })
            }));
        }
        row.set_hits(hits);
        row.radiance(self.tracer.environment, primary, radiance);
        row.shrink();
        layers
    }
}

impl RowBlock<'_> {
    /// Adds a pixel of the block to its row. Of a uniform pixel the centre tells all, together with the third sample where that
    /// is shaded.
    fn push_pixel(&self, pixel: usize, seen: &PrimaryPixel<'_>, light: &BlockLight, row: &mut GBufferRow) {
        let told: [u16; SAMPLES] = std::array::from_fn(|sample| self.told_by[BLOCK * sample + pixel]);
        let kept = |sample: usize| {
            let KeptLight { rest, ambient, direct, .. } = *light.get(told[sample]);
            GBufferSample { rest, ambient, direct, normal: seen.normals[sample].geometric }
        };
        if seen.uniform {
            row.push([self.with_third(pixel, kept(0), light)]);
            if let Some(mirror) = light.mirror(told[0]) {
                row.push_mirror(0, mirror.sample);
                light.mirror(told[2]).into_iter().for_each(|mirror| row.push_mirror(2, mirror.sample));
            }
        } else if seen.kept_samples() == 1 {
            let mut sky = kept(0);
            if told[1] != told[0] {
                let all = told.map(|lane| light.sky[usize::from(lane)]);
                sky.rest = Rgb9e5::new(all.into_iter().sum::<Vec3A>() / SAMPLES as f32);
            }
            row.push([sky]);
        } else {
            row.push([kept(0), kept(1), kept(2), kept(3)]);
            for (sample, lane) in told.into_iter().enumerate() {
                let is_lens = light.get(lane).is_lens;
                light.mirror(lane).into_iter().for_each(|mirror| row.push_mirror(sample, mirror.sample));
                if is_lens {
                    row.mark_lens(sample);
                }
            }
        }
    }

    /// The centre of a uniform pixel; the mean of both where the third sample is shaded, too.
    fn with_third(&self, pixel: usize, centre: GBufferSample, light: &BlockLight) -> GBufferSample {
        let third = self.told_by[BLOCK * THIRD + pixel];
        let (Some(mirror), true) = (light.mirror(pixel as u16), usize::from(third) == BLOCK * THIRD + pixel) else {
            return centre;
        };
        let mean = |k: usize| Rgb9e5::new((mirror.light[k] + light.thirds[pixel][k]) * 0.5);
        GBufferSample { rest: mean(0), ambient: mean(1), direct: mean(2), ..centre }
    }
}
