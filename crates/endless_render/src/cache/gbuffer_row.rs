//! A row of the static picture.

use super::gbuffer_sample::{GBufferSample, LitHit, MirrorSample};
use super::primary_hits::PrimaryPixel;
use super::shaded_pixel::ShadedPixel;
use super::still_pixel::StillPixel;
use crate::material::PackedBsdf;
use crate::sampling::SAMPLES;

/// What is kept of a row's pixels but for distances and the sun: as many samples and mirrors as it takes to tell them.
#[derive(Default)]
pub(super) struct GBufferRow {
    pixels: Vec<KeptPixel>,
    samples: Vec<GBufferSample>,
    /// At night, where lamps and vehicle lights come and go, of all samples; by day of pixels with lenses of traffic lights.
    hits: Vec<LitHit>,
    mirrors: Vec<MirrorSample>,
    /// At night, the BSDF of each pixel's centre if it is uniform: vehicle lights sweep much of the picture.
    pub(super) bsdfs: Vec<PackedBsdf>,
}

/// Where what is kept of a pixel lies in its row.
#[derive(Clone, Copy)]
struct KeptPixel {
    first_sample: u32,
    first_hit: u32,
    first_mirror: u32,
    samples: u8,
    hits: u8,
    mirrored: u8,
    lenses: u8,
}

impl GBufferRow {
    /// Room for what these pixels need.
    pub(super) fn for_pixels<'a>(pixels: impl ExactSizeIterator<Item = PrimaryPixel<'a>>) -> Self {
        let count = pixels.len();
        let samples = pixels.map(|pixel| pixel.kept_samples()).sum();
        Self { pixels: Vec::with_capacity(count), samples: Vec::with_capacity(samples), ..Self::default() }
    }

    /// Adds the next pixel.
    pub(super) fn push(&mut self, pixel: &ShadedPixel, night: bool) {
        let hits = if night || pixel.lenses() != 0 { pixel.hits() } else { &[] };
        self.pixels.push(KeptPixel {
            first_sample: self.samples.len() as u32,
            first_hit: self.hits.len() as u32,
            first_mirror: self.mirrors.len() as u32,
            samples: pixel.samples().len() as u8,
            hits: hits.len() as u8,
            mirrored: pixel.mirrored(),
            lenses: pixel.lenses(),
        });
        self.samples.extend_from_slice(pixel.samples());
        self.hits.extend_from_slice(hits);
        self.mirrors.extend_from_slice(pixel.mirrors());
    }

    /// Gives back the room that was not needed.
    pub(super) fn shrink(&mut self) {
        self.hits.shrink_to_fit();
        self.mirrors.shrink_to_fit();
    }

    /// A pixel, with what is kept elsewhere.
    pub(super) fn pixel<'a>(
        &'a self,
        x: usize,
        distances: &'a [f32; SAMPLES],
        sun_free: &'a [u8; SAMPLES],
        uniform: bool,
    ) -> StillPixel<'a> {
        let KeptPixel { first_sample, first_hit, first_mirror, samples, hits, mirrored, lenses } = self.pixels[x];
        let samples = &self.samples[first_sample as usize..][..usize::from(samples)];
        let hits = &self.hits[first_hit as usize..][..usize::from(hits)];
        let mirrors = &self.mirrors[first_mirror as usize..][..mirrored.count_ones() as usize];
        StillPixel { distances, sun_free, uniform, samples, hits, mirrored, mirrors, lenses }
    }
}
