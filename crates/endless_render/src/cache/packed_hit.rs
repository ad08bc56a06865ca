//! Where a sample's ray met a triangle, in twelve bytes.

use crate::accel::Hit;
use wide::f32x8;

/// No instance.
const NOTHING: u32 = u32::MAX;

/// A [`Hit`] but for its distance, which is kept apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct PackedHit {
    /// [`NOTHING`] if the ray met nothing.
    instance: u32,
    triangle: u32,
    /// Barycentric weights of the triangle's second and third vertex; 65,535 is 1.
    weights: [u16; 2],
}

impl PackedHit {
    /// A ray that met nothing.
    pub(super) const NONE: Self = Self { instance: NOTHING, triangle: 0, weights: [0; 2] };

    pub(super) fn new(hit: &Hit) -> Self {
        let weights = [hit.u, hit.v].map(|w| (w.clamp(0.0, 1.0) * 65_535.0).round() as u16);
        Self { instance: hit.instance, triangle: hit.triangle, weights }
    }

    /// On a triangle of an instance, with weights as they are packed.
    pub(super) fn of(instance: u32, triangle: u32, weights: [u16; 2]) -> Self {
        Self { instance, triangle, weights }
    }

    /// Whether both are on one instance.
    pub(super) fn is_on_instance_of(&self, other: &Self) -> bool {
        self.instance == other.instance
    }

    /// Whether both are on one triangle.
    pub(super) fn is_on_triangle_of(&self, other: &Self) -> bool {
        self.instance == other.instance && self.triangle == other.triangle
    }

    /// The weights of eight triangles' second or third vertices, packed.
    pub(super) fn weights8(weights: f32x8) -> [u16; 8] {
        let share = weights.fast_clamp(f32x8::ZERO, f32x8::ONE);
        (share * f32x8::splat(65_535.0)).round().fast_trunc_int().to_array().map(|weight| weight as u16)
    }

    /// The hit at a distance.
    pub(super) fn at(&self, t: f32) -> Option<Hit> {
        let [u, v] = self.weights.map(|w| f32::from(w) / 65_535.0);
        (self.instance != NOTHING).then_some(Hit { t, instance: self.instance, triangle: self.triangle, u, v })
    }
}
