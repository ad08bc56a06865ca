//! Eight unit vectors at once in four bytes each: the same bits as one by one ([`crate::octahedron`]).

use crate::vec3x8::{Vec3x8, dot};
use wide::{f32x8, i32x8};

const MOST: f32x8 = f32x8::new([32_767.0; 8]);

/// Packs eight unit vectors.
pub(crate) fn pack8(v: &Vec3x8) -> [u32; 8] {
    let length = (v[0].abs() + v[1].abs() + v[2].abs()).fast_max(f32x8::splat(1e-9));
    let [x, y] = folded(v[2], [v[0] / length, v[1] / length]).map(|c| (c * MOST).round().fast_trunc_int());
    let packed: i32x8 = (x & i32x8::splat(0xffff)) | (y << 16i32);
    packed.to_array().map(|packed| packed as u32)
}

/// The unit vectors that were packed.
pub(crate) fn unpack8(packed: [u32; 8]) -> Vec3x8 {
    let packed = i32x8::new(packed.map(|packed| packed as i32));
    // The sign of each half spreads over what is above it.
    let [x, y] = [(packed << 16i32) >> 16i32, packed >> 16i32].map(|c: i32x8| c.round_float() / MOST);
    let z = f32x8::ONE - x.abs() - y.abs();
    let [x, y] = folded(z, [x, y]);
    let v = [x, y, z];
    let length = dot(&v, &v).sqrt();
    v.map(|axis| axis / length)
}

/// The lower half, of negative height, folds over the diagonals.
fn folded(height: f32x8, [x, y]: [f32x8; 2]) -> [f32x8; 2] {
    let below = height.simd_lt(f32x8::ZERO);
    let over = |own: f32x8, other: f32x8| {
        let flat = f32x8::ONE - other.abs();
        own.simd_lt(f32x8::ZERO).select(flat ^ f32x8::splat(-0.0), flat)
    };
    [below.select(over(x, y), x), below.select(over(y, x), y)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::octahedron::{pack, unpack};
    use crate::sampling::{hammersley, sphere_direction};
    use glam::Vec3A;

    #[test]
    fn eight_are_those_of_one_after_another() {
        let mut vectors: Vec<Vec3A> = (0..9_990).map(|i| sphere_direction(hammersley(i, 9_990))).collect();
        vectors.extend([Vec3A::X, Vec3A::Y, Vec3A::Z, -Vec3A::X, -Vec3A::Y, -Vec3A::Z]);
        vectors.extend([Vec3A::new(-0.0, 0.6, -0.8), Vec3A::new(0.6, -0.8, -0.0), Vec3A::new(-0.6, -0.8, 0.0)]);
        vectors.push(Vec3A::new(0.0, -0.0, -1.0));
        assert_eq!(vectors.len() % 8, 0);
        for eight in vectors.as_chunks::<8>().0 {
            let packed = pack8(&[0, 1, 2].map(|axis| f32x8::new(eight.map(|v| v[axis]))));
            assert_eq!(packed, eight.map(pack));
            let [x, y, z] = unpack8(packed).map(f32x8::to_array);
            for lane in 0..8 {
                let own = unpack(packed[lane]).to_array().map(f32::to_bits);
                assert_eq!([x[lane], y[lane], z[lane]].map(f32::to_bits), own, "{}", eight[lane]);
            }
        }
    }
}
