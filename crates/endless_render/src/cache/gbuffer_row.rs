//! A row of the static picture.

use super::gbuffer_sample::{GBufferSample, LitHit, MirrorSample};
use super::primary_hits::PrimaryPixel;
use super::still_pixel::StillPixel;
use crate::material::PackedBsdf;
use crate::sampling::SAMPLES;

/// What is kept of a row's pixels but for distances and the sun: as many samples and mirrors as it takes to tell them.
#[derive(Default)]
pub(super) struct GBufferRow {
    pixels: Vec<KeptPixel>,
    samples: Vec<GBufferSample>,
    /// As many as samples, where they can be asked for: at night, as lamps and vehicle lights come and go, and in rows with
    /// lenses of traffic lights. Else none.
    hits: Vec<LitHit>,
    mirrors: Vec<MirrorSample>,
    /// At night, the BSDF of the centre of each uniform pixel: vehicle lights sweep much of the picture.
    bsdfs: Vec<PackedBsdf>,
    /// How many of them lie before each stretch of pixels.
    bsdfs_before: Vec<u32>,
}

/// Pixels of a stretch.
const STRETCH: usize = 32;

/// Where what is kept of a pixel lies in its row.
#[derive(Clone, Copy)]
struct KeptPixel {
    first_sample: u32,
    first_mirror: u32,
    samples: u8,
    mirrored: u8,
    lenses: u8,
}

impl GBufferRow {
    /// Forgets what it held, and makes room for what these pixels need.
    pub(super) fn clear_for<'a>(&mut self, pixels: impl ExactSizeIterator<Item = PrimaryPixel<'a>>) {
        self.pixels.clear();
        self.samples.clear();
        self.hits.clear();
        self.mirrors.clear();
        self.bsdfs.clear();
        self.bsdfs_before.clear();
        self.pixels.reserve_exact(pixels.len());
        self.samples.reserve_exact(pixels.map(|pixel| pixel.kept_samples()).sum());
    }

    /// Adds the next pixel, of which one or four samples tell the light.
    #[inline]
    pub(super) fn push<const N: usize>(&mut self, samples: [GBufferSample; N]) {
        let (first_sample, first_mirror) = (self.samples.len() as u32, self.mirrors.len() as u32);
        self.pixels.push(KeptPixel { first_sample, first_mirror, samples: N as u8, mirrored: 0, lenses: 0 });
        self.samples.extend(samples);
    }

    /// Adds what a sample of the last pixel mirrors, after those of earlier samples.
    pub(super) fn push_mirror(&mut self, sample: usize, mirror: MirrorSample) {
        if let Some(pixel) = self.pixels.last_mut() {
            pixel.mirrored |= 1 << sample;
            self.mirrors.push(mirror);
        }
    }

    /// Notes that a sample of the last pixel lies on the lens of a traffic light.
    pub(super) fn mark_lens(&mut self, sample: usize) {
        if let Some(pixel) = self.pixels.last_mut() {
            pixel.lenses |= 1 << sample;
        }
    }

    /// Whether anything lies on the lens of a traffic light.
    pub(super) fn has_lenses(&self) -> bool {
        self.pixels.iter().any(|pixel| pixel.lenses != 0)
    }

    /// Tells of all samples what they saw.
    pub(super) fn set_hits(&mut self, hits: Vec<LitHit>) {
        self.hits = hits;
    }

    /// At night, adds the BSDF of the next pixel's centre, if the pixel is uniform.
    pub(super) fn push_bsdf(&mut self, x: usize, bsdf: Option<PackedBsdf>) {
        if x.is_multiple_of(STRETCH) {
            self.bsdfs_before.push(self.bsdfs.len() as u32);
        }
        self.bsdfs.extend(bsdf);
    }

    /// At night, the BSDF of a pixel's centre if the pixel is uniform, as this tells of the row's pixels.
    pub(super) fn bsdf(&self, x: usize, uniform: &[bool]) -> Option<&PackedBsdf> {
        let before = *self.bsdfs_before.get(x / STRETCH)? as usize;
        let first = x / STRETCH * STRETCH;
        let nearer = uniform[first..x].iter().filter(|uniform| **uniform).count();
        self.bsdfs.get(before + nearer).filter(|_| uniform[x])
    }

    /// Gives back the room that is not needed.
    pub(super) fn shrink(&mut self) {
        self.bsdfs.shrink_to_fit();
        self.mirrors.shrink_to_fit();
    }

    /// Which of up to 32 pixels from `x` on mirror at all, and which lie on lenses of traffic lights, a bit each.
    pub(super) fn mirroring_and_lenses(&self, x: usize, count: usize) -> [u32; 2] {
        let bits = |is_so: fn(&KeptPixel) -> bool| {
            let pixels = self.pixels[x..x + count].iter().enumerate();
            pixels.fold(0, |bits, (lane, pixel)| bits | u32::from(is_so(pixel)) << lane)
        };
        [bits(|pixel| pixel.mirrored != 0), bits(|pixel| pixel.lenses != 0)]
    }

    /// What is kept of eight pixels of which one sample each tells all.
    pub(super) fn plain_eight(&self, x: usize) -> Option<&[GBufferSample; 8]> {
        let pixels = self.pixels.get(x..x + 8)?;
        let first = pixels[0].first_sample as usize;
        let plain = pixels.iter().all(|pixel| pixel.samples == 1 && pixel.mirrored == 0);
        self.samples[first..].first_chunk().filter(|_| plain)
    }

    /// A pixel, with what is kept elsewhere.
    pub(super) fn pixel<'a>(
        &'a self,
        x: usize,
        distances: &'a [f32; SAMPLES],
        sun_free: &'a [u8; SAMPLES],
        uniform: bool,
    ) -> StillPixel<'a> {
        let KeptPixel { first_sample, first_mirror, samples, mirrored, lenses } = self.pixels[x];
        let own = first_sample as usize..first_sample as usize + usize::from(samples);
        let (samples, hits) = (&self.samples[own.clone()], self.hits.get(own).unwrap_or(&[]));
        let mirrors = &self.mirrors[first_mirror as usize..][..mirrored.count_ones() as usize];
        StillPixel { distances, sun_free, uniform, samples, hits, mirrored, mirrors, lenses }
    }
}
