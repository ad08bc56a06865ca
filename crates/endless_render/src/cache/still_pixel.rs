//! One pixel of the static picture, as it is kept.

use super::gbuffer_sample::{GBufferSample, LitHit, MirrorSample};
use super::pixel_centre::PixelCentre;
use crate::accel::{Hit, Ray};
use crate::light::{Environment, SUN_SAMPLES};
use crate::material::PackedBsdf;
use crate::octahedron;
use crate::sampling::SAMPLES;
use crate::scene::ShadingPoint;
use glam::Vec3A;

/// A pixel of the static picture. Its four samples have a distance and a part of the sun each. Their light is kept for
/// each, or once: for all of a uniform pixel, and of one that shows nothing but sky.
#[derive(Clone, Copy)]
pub(super) struct StillPixel<'a> {
    /// How far each sample lies from the lens, metres; [`f32::MAX`] for the sky.
    pub(super) distances: &'a [f32; SAMPLES],
    /// Which directions to the sun's disc the static scene leaves each sample, a bit each.
    pub(super) sun_free: &'a [u8; SAMPLES],
    /// All samples lie on one smooth piece that gives no light of its own.
    pub(super) uniform: bool,
    /// One or four.
    pub(super) samples: &'a [GBufferSample],
    /// As many, or none where nobody asks.
    pub(super) hits: &'a [LitHit],
    /// Which samples have a mirror, a bit each. Those of a uniform pixel share one in pairs: the first has it.
    pub(super) mirrored: u8,
    pub(super) mirrors: &'a [MirrorSample],
    /// Which samples lie on lenses of traffic lights, a bit each.
    pub(super) lenses: u8,
}

impl<'a> StillPixel<'a> {
    /// What is kept of a sample's light.
    pub(super) fn sample(&self, sample: usize) -> &'a GBufferSample {
        &self.samples[sample * self.samples.len() / SAMPLES]
    }

    /// What is kept of a sample's mirror.
    pub(super) fn mirror(&self, sample: usize) -> Option<&'a MirrorSample> {
        let sample = if self.uniform { sample & !1 } else { sample };
        let before = (self.mirrored & ((1 << sample) - 1)).count_ones();
        (self.mirrored >> sample & 1 == 1).then(|| &self.mirrors[before as usize])
    }

    /// Whether a sample saw the sky.
    pub(super) fn is_sky(&self, sample: usize) -> bool {
        self.distances[sample] == f32::MAX
    }

    /// Whether a sample lies on a lens of a traffic light.
    pub(super) fn is_lens(&self, sample: usize) -> bool {
        self.lenses >> sample & 1 == 1
    }

    fn lit_hit(&self, sample: usize) -> Option<&'a LitHit> {
        self.hits.get(sample * self.hits.len() / SAMPLES)
    }

    /// What a sample's ray met, if it is kept; of a uniform pixel, known of its centre alone.
    pub(super) fn hit(&self, sample: usize) -> Option<Hit> {
        self.lit_hit(sample)?.hit.at(self.distances[sample])
    }

    /// Which lamps near a sample light it past the static scene, a bit each.
    pub(super) fn lamps_free(&self, sample: usize) -> u32 {
        self.lit_hit(sample).map_or(0, |hit| hit.lamps_free)
    }

    /// The surface of a sample, seen along its ray.
    pub(super) fn facet(&self, ray: &Ray, sample: usize) -> ShadingPoint {
        ShadingPoint::along(ray, self.distances[sample], octahedron::unpack(self.sample(sample).normal))
    }

    /// The centre, seen along its ray.
    pub(super) fn centre<'b>(&self, ray: &Ray, bsdf: Option<&'b PackedBsdf>) -> PixelCentre<'b> {
        PixelCentre { facet: self.facet(ray, 0), bsdf, lamps_free: self.lamps_free(0) }
    }

    /// Whether the centre lies on something level, where rain splashes.
    pub(super) fn is_level(&self) -> bool {
        !self.is_sky(0) && octahedron::unpack(self.sample(0).normal).z > 0.9
    }

    /// Mean radiance when nothing moves, kcd/m².
    pub(super) fn radiance(&self, environment: &Environment) -> Vec3A {
        let radiance = (0..SAMPLES).map(|s| {
            let GBufferSample { rest, ambient, direct, .. } = self.sample(s);
            let mirror = self.mirror(s).map_or(Vec3A::ZERO, |mirror| mirror.light.get());
            rest.get() + ambient.get() + direct.get() * sun_share(environment, self.sun_free[s]) + mirror
        });
        radiance.sum::<Vec3A>() / SAMPLES as f32
    }
}

/// Share of the direct light that arrives through these free directions.
pub(super) fn sun_share(environment: &Environment, free: u8) -> f32 {
    if environment.night { 1.0 } else { free.count_ones() as f32 / SUN_SAMPLES as f32 }
}
