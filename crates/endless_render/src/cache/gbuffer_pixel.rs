//! One pixel of the static picture, in the form that rows of pixels need most.

use super::gbuffer_sample::GBufferSample;
use super::pixel_centre::PixelCentre;
use crate::accel::Ray;
use crate::material::Bsdf;
use crate::octahedron;
use crate::sampling::SAMPLES;
use crate::scene::ShadingPoint;

/// What rows of pixels ask of their samples most, side by side: the samples themselves lie far apart in memory.
#[derive(Debug, Clone, Copy)]
pub(super) struct GBufferPixel {
    /// How far each sample lies from the lens, metres; [`f32::MAX`] for the sky.
    pub(super) distances: [f32; SAMPLES],
    /// Geometric normal of each sample, packed.
    normals: [u32; SAMPLES],
    /// Which lamps near the centre light it past the static scene, a bit each.
    lamps_free: u32,
    /// Which directions to the sun's disc the static scene leaves each sample, a bit each.
    pub(super) sun_free: [u8; SAMPLES],
    /// Which of the pixel's samples mirror, a bit each.
    pub(super) mirrors: u8,
}

impl GBufferPixel {
    /// Of a pixel's samples.
    pub(super) fn new(samples: &[GBufferSample; SAMPLES]) -> Self {
        let mirrors = samples.iter().rev().fold(0, |bits, s| bits << 1 | u8::from(s.mirrors()));
        Self {
            distances: samples.map(|s| s.hit.t),
            normals: samples.map(|s| s.normal),
            lamps_free: samples[0].lamps_free,
            sun_free: samples.map(|s| s.sun_free),
            mirrors,
        }
    }

    /// Whether the centre lies on something level, where rain splashes.
    pub(super) fn is_level(&self) -> bool {
        self.distances[0] < f32::MAX && octahedron::unpack(self.normals[0]).z > 0.9
    }

    /// The surface of a sample, seen along its ray.
    pub(super) fn facet(&self, ray: &Ray, sample: usize) -> ShadingPoint {
        ShadingPoint::along(ray, self.distances[sample], octahedron::unpack(self.normals[sample]))
    }

    /// The centre, seen along its ray.
    pub(super) fn centre<'a>(&self, ray: &Ray, bsdf: Option<&'a Bsdf>) -> PixelCentre<'a> {
        PixelCentre { facet: self.facet(ray, 0), bsdf, lamps_free: self.lamps_free }
    }
}
