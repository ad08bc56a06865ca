//! Lattice noise on integer hashes: fast, and the same bits everywhere.

use glam::{IVec2, IVec3, Vec2, Vec3, Vec3A};

/// The corner of a lattice's cell that a place lies in. `Vec2::floor` is a call of libm; this is one instruction.
#[inline]
pub(crate) fn corner_of(p: Vec2) -> Vec2 {
    Vec2::new(p.x.floor(), p.y.floor())
}

/// Mixes all bits.
#[inline]
pub(crate) fn hash(mut x: u32) -> u32 {
    // lowbias32 (Wellons 2018).
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

/// Uniform in [0, 1) for a lattice cell.
#[inline]
pub(crate) fn cell2(p: IVec2, salt: u32) -> f32 {
    unit(hash(p.x as u32 ^ hash((p.y as u32).wrapping_add(salt.wrapping_mul(0x9e37_79b9)))))
}

/// Uniform in [0, 1) for a lattice cell.
#[inline]
pub(crate) fn cell3(p: IVec3, salt: u32) -> f32 {
    unit(hash(p.x as u32 ^ hash(p.y as u32 ^ hash((p.z as u32).wrapping_add(salt.wrapping_mul(0x9e37_79b9))))))
}

/// Uniform in [0, 1) from a counter.
#[inline]
pub(crate) fn cell1(i: u32, salt: u32) -> f32 {
    unit(hash(i ^ hash(salt)))
}

#[inline]
fn unit(h: u32) -> f32 {
    (h >> 8) as f32 * (1.0 / 16_777_216.0)
}

#[inline]
fn fade(t: f32) -> f32 {
    t * t * (3.0 - 2.0 * t)
}

/// Value noise in [−1, 1].
#[inline]
pub(crate) fn value2(p: Vec2, salt: u32) -> f32 {
    let base = corner_of(p);
    let f = p - base;
    let i = base.as_ivec2();
    let (u, v) = (fade(f.x), fade(f.y));
    let c = |x, y| cell2(i + IVec2::new(x, y), salt);
    let (a, b) = (c(0, 0) + (c(1, 0) - c(0, 0)) * u, c(0, 1) + (c(1, 1) - c(0, 1)) * u);
    (a + (b - a) * v) * 2.0 - 1.0
}

/// Value noise in [−1, 1].
#[inline]
pub(crate) fn value3(p: Vec3, salt: u32) -> f32 {
    let base = Vec3::new(p.x.floor(), p.y.floor(), p.z.floor());
    let f = p - base;
    let i = base.as_ivec3();
    let (u, v, w) = (fade(f.x), fade(f.y), fade(f.z));
    let c = |x, y, z| cell3(i + IVec3::new(x, y, z), salt);
    let line = |y, z| c(0, y, z) + (c(1, y, z) - c(0, y, z)) * u;
    let plane = |z| line(0, z) + (line(1, z) - line(0, z)) * v;
    let (a, b) = (plane(0), plane(1));
    (a + (b - a) * w) * 2.0 - 1.0
}

/// Fractal sum of value noise, about [−1, 1]; each octave doubles the frequency.
pub(crate) fn fbm2(p: Vec2, octaves: u32, gain: f32) -> f32 {
    let (mut sum, mut norm, mut amplitude, mut q) = (0.0, 0.0, 1.0, p);
    for octave in 0..octaves {
        sum += amplitude * value2(q, octave);
        norm += amplitude;
        amplitude *= gain;
        // Turned a little, so that lattices do not line up.
        q = Vec2::new(1.6 * q.x - 1.2 * q.y, 1.2 * q.x + 1.6 * q.y) + 17.0;
    }
    sum / norm * 1.5
}

/// Fractal noise of unit base frequency `1 / wavelength_m`, with the octaves that a footprint would alias left out.
pub(crate) fn filtered_fbm2(p: Vec2, wavelength_m: f32, octaves: u32, footprint_m: f32) -> f32 {
    let (mut sum, mut amplitude, mut wavelength) = (0.0, 0.5, wavelength_m);
    for octave in 0..octaves {
        let keep = (wavelength / footprint_m.max(1e-4) * 0.5 - 0.5).clamp(0.0, 1.0);
        if keep == 0.0 {
            break;
        }
        let turn = octave as f32 * 0.7;
        sum += amplitude * keep * value2(p / wavelength + turn * 13.7, octave + 31);
        amplitude *= 0.55;
        wavelength *= 0.47;
    }
    sum
}

/// The two nearest feature points of a jittered grid (Worley 1996): distances, and the id of the nearest in [0, 1).
pub(crate) fn cells2(p: Vec2, salt: u32) -> (f32, f32, f32) {
    let i = corner_of(p).as_ivec2();
    let (mut first, mut second, mut id) = (f32::MAX, f32::MAX, 0.0);
    for y in -1..=1 {
        for x in -1..=1 {
            let c = i + IVec2::new(x, y);
            let feature = c.as_vec2() + Vec2::new(cell2(c, salt), cell2(c, salt ^ 0x55));
            let distance = feature.distance(p);
            if distance < first {
                (second, first, id) = (first, distance, cell2(c, salt ^ 0xaa));
            } else if distance < second {
                second = distance;
            }
        }
    }
    (first, second, id)
}

/// A random colour around 1, the same for the same cell.
pub(crate) fn tint(p: IVec2, salt: u32, spread: f32) -> Vec3A {
    let grey = 1.0 + (cell2(p, salt) - 0.5) * 2.0 * spread;
    Vec3A::new(
        grey + (cell2(p, salt + 1) - 0.5) * spread * 0.4,
        grey + (cell2(p, salt + 2) - 0.5) * spread * 0.3,
        grey + (cell2(p, salt + 3) - 0.5) * spread * 0.4,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn noise_stays_in_range(x in -1e4f32..1e4, y in -1e4f32..1e4) {
            let p = Vec2::new(x, y);
            prop_assert!(value2(p, 3).abs() <= 1.0);
            prop_assert!(value3(Vec3::new(x, y, 2.5), 3).abs() <= 1.0);
            prop_assert!(fbm2(p, 6, 0.5).abs() <= 1.5);
            let (first, second, id) = cells2(p, 1);
            prop_assert!(first <= second && (0.0..1.0).contains(&id));
        }
    }
}
