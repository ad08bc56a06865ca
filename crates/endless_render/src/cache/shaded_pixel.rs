//! One pixel of the static picture, just shaded.

use super::gbuffer_sample::{GBufferSample, LitHit, MirrorSample};
use super::primary_hits::PrimaryPixel;
use super::still_pixel::StillPixel;
use crate::rgb9e5::Rgb9e5;
use crate::sampling::SAMPLES;
use glam::Vec3A;

/// What shading tells of a sample: fog applied, kcd/m².
#[derive(Clone, Copy)]
pub(super) struct ShadedSample {
    /// Emitted by the surface and scattered in by the air.
    pub(super) rest: Vec3A,
    /// Reflected sky and bounced light.
    pub(super) ambient: Vec3A,
    /// By day the sun's light if nothing were in its way; at night that of all lamps, shadowed by the static scene.
    pub(super) direct: Vec3A,
    pub(super) mirror: Option<MirrorSample>,
    /// Which lamps near it light it past the static scene, a bit each.
    pub(super) lamps_free: u32,
    /// On a lens of a traffic light.
    pub(super) is_lens: bool,
}

impl ShadedSample {
    /// The open sky.
    pub(super) fn sky(radiance: Vec3A) -> Self {
        let [ambient, direct] = [Vec3A::ZERO; 2];
        Self { rest: radiance, ambient, direct, mirror: None, lamps_free: 0, is_lens: false }
    }

    /// As it is kept, of a sample of the pixel.
    fn kept(&self, primary: &PrimaryPixel<'_>, sample: usize) -> GBufferSample {
        let [rest, ambient, direct] = [self.rest, self.ambient, self.direct].map(Rgb9e5::new);
        GBufferSample { rest, ambient, direct, normal: primary.normals[sample].geometric }
    }

    /// The light of two in the mean.
    fn mean(&self, other: &Self) -> Self {
        let mean = |of: fn(&Self) -> Vec3A| (of(self) + of(other)) * 0.5;
        Self { rest: mean(|s| s.rest), ambient: mean(|s| s.ambient), direct: mean(|s| s.direct), ..*self }
    }
}

/// What is kept of a pixel that was shaded.
pub(super) struct ShadedPixel {
    samples: [GBufferSample; SAMPLES],
    hits: [LitHit; SAMPLES],
    /// How many of them are kept.
    count: usize,
    mirrors: [MirrorSample; SAMPLES],
    mirrored: u8,
    lenses: u8,
}

impl ShadedPixel {
    /// Of a pixel's samples. Of a uniform one, the centre tells all, together with the third sample where it mirrors.
    pub(super) fn new(primary: &PrimaryPixel<'_>, shaded: [&ShadedSample; SAMPLES]) -> Self {
        let count = primary.kept_samples();
        let mut samples = [GBufferSample::NONE; SAMPLES];
        if primary.uniform {
            let all = if shaded[0].mirror.is_some() { shaded[0].mean(shaded[2]) } else { *shaded[0] };
            samples[0] = all.kept(primary, 0);
        } else if count == 1 {
            let mean = shaded.iter().map(|s| s.rest).sum::<Vec3A>() / SAMPLES as f32;
            samples[0] = ShadedSample::sky(mean).kept(primary, 0);
        } else {
            samples = std::array::from_fn(|s| shaded[s].kept(primary, s));
        }
        let hits = std::array::from_fn(|s| LitHit { hit: primary.hits[s], lamps_free: shaded[s].lamps_free });
        let mut pixel = Self { samples, hits, count, mirrors: [MirrorSample::NONE; SAMPLES], mirrored: 0, lenses: 0 };
        for (s, sample) in shaded.into_iter().enumerate() {
            pixel.lenses |= u8::from(sample.is_lens) << s;
            if let Some(mirror) = sample.mirror.filter(|_| !(primary.uniform && s % 2 == 1)) {
                pixel.mirrors[pixel.mirrored.count_ones() as usize] = mirror;
                pixel.mirrored |= 1 << s;
            }
        }
        pixel
    }

    /// As it is kept.
    pub(super) fn still<'a>(&'a self, primary: &PrimaryPixel<'a>) -> StillPixel<'a> {
        let Self { mirrored, lenses, .. } = *self;
        let PrimaryPixel { distances, sun_free, uniform, .. } = *primary;
        let (samples, hits, mirrors) = (self.samples(), self.hits(), self.mirrors());
        StillPixel { distances, sun_free, uniform, samples, hits, mirrored, mirrors, lenses }
    }

    pub(super) fn samples(&self) -> &[GBufferSample] {
        &self.samples[..self.count]
    }

    pub(super) fn hits(&self) -> &[LitHit] {
        &self.hits[..self.count]
    }

    pub(super) fn mirrors(&self) -> &[MirrorSample] {
        &self.mirrors[..self.mirrored.count_ones() as usize]
    }
}
