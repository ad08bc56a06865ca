//! Eight vectors side by side.

use glam::Vec3A;
use wide::f32x8;

/// Eight vectors: x, y, z.
pub(crate) type Vec3x8 = [f32x8; 3];

/// Vectors put side by side.
#[inline]
pub(crate) fn side_by_side(v: [Vec3A; 8]) -> Vec3x8 {
    let [x, y, z, ..] = f32x8::transpose(v.map(|v| f32x8::new([v.x, v.y, v.z, 0.0, 0.0, 0.0, 0.0, 0.0])));
    [x, y, z]
}

/// One vector eight times.
#[inline]
pub(crate) fn splat(v: Vec3A) -> Vec3x8 {
    v.to_array().map(f32x8::splat)
}

/// One of eight vectors.
#[inline]
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

/// [`Vec3A::normalize_or`], lane by lane: the same bits.
#[inline]
pub(crate) fn normalize_or(v: Vec3x8, fallback: &Vec3x8) -> Vec3x8 {
    let over = f32x8::ONE / dot(&v, &v).sqrt();
    let usable = over.simd_gt(f32x8::ZERO) & over.simd_lt(f32x8::splat(f32::INFINITY));
    std::array::from_fn(|k| usable.select(v[k] * over, fallback[k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_side_by_side_keep_their_places() {
        let v = side_by_side(std::array::from_fn(|i| Vec3A::new(0.0, 10.0, 20.0) + i as f32));
        for (k, axis) in v.into_iter().enumerate() {
            assert_eq!(axis.to_array(), std::array::from_fn(|i| (10 * k + i) as f32));
        }
    }
}
