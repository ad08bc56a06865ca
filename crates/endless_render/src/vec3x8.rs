//! Eight vectors side by side.

use glam::Vec3A;
use wide::f32x8;

/// Eight vectors: x, y, z.
pub(crate) type Vec3x8 = [f32x8; 3];

/// Eight vectors, from one after the other.
pub(crate) fn side_by_side(vectors: &[Vec3A; 8]) -> Vec3x8 {
    [0, 1, 2].map(|axis| f32x8::new(vectors.map(|v| v[axis])))
}

/// One of eight vectors.
pub(crate) fn lane_of(all: &Vec3x8, lane: usize) -> Vec3A {
    Vec3A::from_array(all.each_ref().map(|axis| axis.as_array()[lane]))
}

pub(crate) fn dot(a: &Vec3x8, b: &Vec3x8) -> f32x8 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Vectors of no length stay as they are.
pub(crate) fn normalize(v: Vec3x8) -> Vec3x8 {
    let over = f32x8::ONE / dot(&v, &v).fast_max(f32x8::splat(1e-30)).sqrt();
    v.map(|axis| axis * over)
}
