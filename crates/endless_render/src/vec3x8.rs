//! Eight vectors side by side.

use wide::f32x8;

/// Eight vectors: x, y, z.
pub(crate) type Vec3x8 = [f32x8; 3];

pub(crate) fn dot(a: &Vec3x8, b: &Vec3x8) -> f32x8 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Vectors of no length stay as they are.
pub(crate) fn normalize(v: Vec3x8) -> Vec3x8 {
    let over = f32x8::ONE / dot(&v, &v).fast_max(f32x8::splat(1e-30)).sqrt();
    v.map(|axis| axis * over)
}
