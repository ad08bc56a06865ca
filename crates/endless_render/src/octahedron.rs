//! Unit vectors in four bytes (Cigolle et al. 2014, "oct32").

use crate::exact8::{self, negated};
use crate::vec3x8::{Vec3x8, dot};
use glam::{Vec2, Vec3A};
use wide::{f32x8, i32x8, u32x8};

/// Packs a unit vector; [`unpack`] gives it back to about 1/20,000.
pub(crate) fn pack(v: Vec3A) -> u32 {
    let p = Vec2::new(v.x, v.y) / (v.x.abs() + v.y.abs() + v.z.abs()).max(1e-9);
    let p = if v.z < 0.0 { over(p) } else { p };
    let [x, y] = [p.x, p.y].map(|c| (c * 32767.0).round() as i16 as u16);
    u32::from(x) | u32::from(y) << 16
}

/// The unit vector that was packed.
pub(crate) fn unpack(packed: u32) -> Vec3A {
    let [x, y] = [packed as u16, (packed >> 16) as u16].map(|c| f32::from(c as i16) / 32767.0);
    let z = 1.0 - x.abs() - y.abs();
    let p = if z < 0.0 { over(Vec2::new(x, y)) } else { Vec2::new(x, y) };
    Vec3A::new(p.x, p.y, z).normalize()
}

/// The lower half folds over the diagonals.
fn over(p: Vec2) -> Vec2 {
    let sign = |c: f32| if c < 0.0 { -1.0 } else { 1.0 };
    Vec2::new((1.0 - p.y.abs()) * sign(p.x), (1.0 - p.x.abs()) * sign(p.y))
}

/// [`pack`] of eight.
#[inline]
pub(crate) fn pack8([x, y, z]: &Vec3x8) -> [u32; 8] {
    let sum = (x.abs() + y.abs() + z.abs()).fast_max(f32x8::splat(1e-9));
    let p = folded8([*x / sum, *y / sum], *z);
    let [x, y] = p.map(|c| exact8::round_int(c * f32x8::splat(32767.0)).cast_unsigned());
    (x & u32x8::splat(0xffff) | y << 16u32).to_array()
}

/// [`unpack`] of eight.
#[inline]
pub(crate) fn unpack8(packed: &[u32; 8]) -> Vec3x8 {
    let packed = u32x8::new(*packed);
    let number = |high_half: u32x8| {
        let whole: i32x8 = high_half.cast_signed() >> 16u32;
        f32x8::from_i32x8(whole) / f32x8::splat(32767.0)
    };
    let (x, y) = (number(packed << 16u32), number(packed));
    let z = f32x8::ONE - x.abs() - y.abs();
    let [x, y] = folded8([x, y], z);
    let length = dot(&[x, y, z], &[x, y, z]).sqrt();
    [x / length, y / length, z / length]
}

/// Those in the lower half folded over the diagonals.
#[inline]
fn folded8([x, y]: [f32x8; 2], z: f32x8) -> [f32x8; 2] {
    let lower = z.simd_lt(f32x8::ZERO);
    let over = |along: f32x8, across: f32x8| negated(f32x8::ONE - across.abs(), along.simd_lt(f32x8::ZERO));
    [lower.select(over(x, y), x), lower.select(over(y, x), y)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::{hammersley, sphere_direction};
    use crate::vec3x8::side_by_side;
    use proptest::prelude::*;

    fn check_eight(v: [Vec3A; 8]) {
        let packed = pack8(&side_by_side(v));
        assert_eq!(packed, v.map(pack), "{v:?}");
        check_unpacked(packed);
    }

    fn check_unpacked(packed: [u32; 8]) {
        let found = unpack8(&packed).map(f32x8::to_array);
        for (i, packed) in packed.into_iter().enumerate() {
            let one = unpack(packed).to_array();
            assert_eq!(found.map(|axis| axis[i].to_bits()), one.map(f32::to_bits), "{packed:x}");
        }
    }

    #[test]
    fn eight_are_packed_as_one_after_another() {
        let parts = [-1.0, -0.7, -0.0, 0.0, 0.3, 1.0];
        let along = |i: usize| Vec3A::new(parts[i % 6], parts[i / 6 % 6], parts[i / 36]);
        for i in 0..216 {
            check_eight(std::array::from_fn(|k| along((i + k) % 216).normalize_or_zero()));
            check_eight(std::array::from_fn(|k| along((i * k) % 216) * 1e-12));
        }
        for i in 0..100_000 {
            check_eight(std::array::from_fn(|k| sphere_direction(hammersley(8 * i + k as u32, 800_000))));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(16_384))]

        #[test]
        fn any_eight_are_unpacked_as_one_after_another(packed: [u32; 8]) {
            check_unpacked(packed);
            // On the diagonals, and within one half.
            check_unpacked(packed.map(|packed| (packed & 0x7fff) | (0x7fff - (packed & 0x7fff)) << 16));
            check_unpacked(packed.map(|packed| packed & 0x3fff_3fff));
        }
    }

    #[test]
    fn what_is_packed_comes_back() {
        for i in 0..10_000 {
            let v = sphere_direction(hammersley(i, 10_000));
            assert!(unpack(pack(v)).distance(v) < 1e-4, "{v}");
        }
        for axis in [Vec3A::X, Vec3A::Y, Vec3A::Z, -Vec3A::X, -Vec3A::Y, -Vec3A::Z] {
            assert_eq!(unpack(pack(axis)), axis);
        }
    }
}
