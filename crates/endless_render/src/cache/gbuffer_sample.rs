//! One sub-pixel sample of the static picture; its light is kept in parts, by what can change them.

use super::packed_hit::PackedHit;
use crate::accel::Ray;
use crate::octahedron;
use crate::rgb9e5::Rgb9e5;
use crate::scene::ShadingPoint;
use glam::Vec3A;

/// The parts of a sample's radiance, fog applied, kcd/m²: 16 bytes. One tells a whole pixel that is uniform or of nothing
/// but sky.
#[derive(Debug, Clone, Copy)]
pub(super) struct GBufferSample {
    /// Emitted by the surface and scattered in by the air.
    pub(super) rest: Rgb9e5,
    /// Reflected sky and bounced light; moving objects nearby darken it.
    pub(super) ambient: Rgb9e5,
    /// By day the sun's light if nothing were in its way; at night that of all lamps, shadowed by the static scene.
    pub(super) direct: Rgb9e5,
    /// Geometric normal, packed.
    pub(super) normal: u32,
}

/// What a sample saw, and which lamps light it: 16 bytes, kept where something that moves can ask for the material.
#[derive(Debug, Clone, Copy)]
pub(super) struct LitHit {
    pub(super) hit: PackedHit,
    /// Which lamps near it light it past the static scene, a bit each.
    pub(super) lamps_free: u32,
}

impl GBufferSample {
    /// Black sky.
    pub(super) const NONE: Self = Self { rest: Rgb9e5::ZERO, ambient: Rgb9e5::ZERO, direct: Rgb9e5::ZERO, normal: 0 };
}

/// What a sample's coat mirrors, where it is strong enough to be seen: 20 bytes.
#[derive(Debug, Clone, Copy)]
pub(super) struct MirrorSample {
    /// Of the static scene, kcd/m², fog applied.
    pub(super) light: Rgb9e5,
    /// Share of the mirrored light that arrives, fog applied.
    weight: Rgb9e5,
    /// Where the mirror ray goes, packed.
    pub(super) direction: u32,
    /// How far that ray gets in the static scene, metres.
    pub(super) reach: f32,
    /// The coat's; 255 is 1.
    roughness: u8,
}

/// What is told of a mirror.
pub(super) struct Mirror {
    pub(super) light: Vec3A,
    pub(super) weight: Vec3A,
    pub(super) direction: Vec3A,
    pub(super) reach: f32,
    pub(super) roughness: f32,
}

impl MirrorSample {
    /// No mirror.
    pub(super) const NONE: Self =
        Self { light: Rgb9e5::ZERO, weight: Rgb9e5::ZERO, direction: 0, reach: 0.0, roughness: 0 };

    pub(super) fn new(mirror: &Mirror) -> Self {
        Self {
            light: Rgb9e5::new(mirror.light),
            weight: Rgb9e5::new(mirror.weight),
            direction: octahedron::pack(mirror.direction),
            reach: mirror.reach,
            roughness: (mirror.roughness.clamp(0.0, 1.0) * 255.0).round() as u8,
        }
    }

    /// Where the mirror ray goes.
    pub(super) fn direction(&self) -> Vec3A {
        octahedron::unpack(self.direction)
    }

    /// The ray into the mirror, as far as the static scene.
    pub(super) fn ray(&self, facet: &ShadingPoint) -> Ray {
        Ray { origin: facet.ray_origin(), direction: self.direction(), tmax: self.reach }
    }

    /// Share of the mirrored light that arrives.
    pub(super) fn weight(&self) -> Vec3A {
        self.weight.get()
    }

    /// The coat's.
    pub(super) fn roughness(&self) -> f32 {
        f32::from(self.roughness) / 255.0
    }
}
