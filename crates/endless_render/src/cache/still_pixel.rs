//! One pixel of the still picture, as rows of pixels ask for it most.

use super::centre::Place;
use super::still_sample::StillSample;
use crate::accel::Ray;
use crate::material::Look;
use crate::octahedron;
use crate::sampling::SAMPLES;
use crate::scene::Facet;

/// What rows of pixels ask of their samples most, side by side: the samples themselves lie far apart in memory.
#[derive(Debug, Clone, Copy)]
pub(super) struct StillPixel {
    /// How far each sample lies from the lens, metres; [`f32::MAX`] for the sky.
    pub(super) distances: [f32; SAMPLES],
    /// Geometric normal at the centre, packed.
    normal: u32,
    /// Which lamps near the centre light it past the still town, a bit each.
    lamps_free: u32,
    /// Which of the pixel's samples mirror, a bit each.
    pub(super) mirrors: u8,
}

impl StillPixel {
    /// Of a pixel's samples.
    pub(super) fn new(samples: &[StillSample; SAMPLES]) -> Self {
        let mirrors = samples.iter().rev().fold(0, |bits, s| bits << 1 | u8::from(s.mirrors()));
        let centre = &samples[0];
        let distances = samples.map(|s| s.hit.t);
        Self { distances, normal: centre.normal, lamps_free: centre.lamps_free, mirrors }
    }

    /// Whether the centre lies on something level, where rain splashes.
    pub(super) fn is_level(&self) -> bool {
        self.distances[0] < f32::MAX && octahedron::unpack(self.normal).z > 0.9
    }

    /// The centre, seen along its ray.
    pub(super) fn place<'a>(&self, ray: &Ray, look: Option<&'a Look>) -> Place<'a> {
        let facet = Facet::along(ray, self.distances[0], octahedron::unpack(self.normal));
        Place { facet, look, lamps_free: self.lamps_free }
    }
}
