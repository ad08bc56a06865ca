//! Lattice noise on integer hashes: fast, and the same bits everywhere.

use glam::{IVec2, IVec3, Vec2, Vec3, Vec3A};
use wide::{f32x4, f32x8, i32x8, u32x8};

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

/// [`value2`] of four places, each with its salt.
#[inline]
fn value2x4([x, y]: [[f32; 4]; 2], salts: [u32; 4]) -> [f32; 4] {
    let [x, y] = [x, y].map(f32x4::new);
    let corner = [x, y].map(f32x4::floor);
    let [u, v] = [x - corner[0], y - corner[1]].map(|t| t * t * (f32x4::splat(3.0) - f32x4::splat(2.0) * t));
    let [column, row] = corner.map(|c| c.trunc_int().to_array().map(|c| c as u32));
    let salts = salts.map(|salt| salt.wrapping_mul(0x9e37_79b9));
    // Lanes: the row of the corner, then the place.
    let rows =
        hash8(u32x8::new(std::array::from_fn(|i| row[i % 4].wrapping_add(i as u32 / 4).wrapping_add(salts[i % 4]))));
    let columns = u32x8::new(std::array::from_fn(|i| column[i % 4]));
    let [left, right] = [columns, columns + u32x8::splat(1)].map(|columns| unit8(hash8(columns ^ rows)));
    let u = u.to_array();
    let lines = (left + (right - left) * f32x8::new(std::array::from_fn(|i| u[i % 4]))).to_array();
    let [a, b] = [0, 4].map(|first| f32x4::new(std::array::from_fn(|i| lines[first + i])));
    ((a + (b - a) * v) * f32x4::splat(2.0) - f32x4::ONE).to_array()
}

/// [`value2`] of eight places, each with its salt.
#[inline]
pub(super) fn value2x8([x, y]: [f32x8; 2], salts: [u32; 8]) -> f32x8 {
    let corner = [x, y].map(f32x8::floor);
    let shares = [x - corner[0], y - corner[1]].map(|t| t * t * (f32x8::splat(3.0) - f32x8::splat(2.0) * t));
    let [column, row] = corner.map(|c| c.fast_trunc_int().cast_unsigned());
    between(corners_of(column, row + u32x8::new(salts) * u32x8::splat(0x9e37_79b9)), shares)
}

/// Value noise where it is known at the corners of the cells: low left and right, high left and right. The shares are
/// those of the right and the high ones.
#[inline(always)]
pub(super) fn between([low_left, low_right, high_left, high_right]: [f32x8; 4], [u, v]: [f32x8; 2]) -> f32x8 {
    let (a, b) = (low_left + (low_right - low_left) * u, high_left + (high_right - high_left) * u);
    (a + (b - a) * v) * f32x8::splat(2.0) - f32x8::ONE
}

/// [`cell2`] of cells and of those to the right, above, and to the right above; rows with their salts.
#[inline(always)]
pub(super) fn corners_of(column: u32x8, row: u32x8) -> [f32x8; 4] {
    let one = u32x8::splat(1);
    let [low, high] = [row, row + one].map(hash8);
    let at = |column: u32x8, row: u32x8| unit8(hash8(column ^ row));
    [at(column, low), at(column + one, low), at(column, high), at(column + one, high)]
}

/// [`hash`] of eight numbers.
#[inline]
pub(super) fn hash8(mut x: u32x8) -> u32x8 {
    x ^= x >> 16u32;
    x *= u32x8::splat(0x7feb_352d);
    x ^= x >> 15u32;
    x *= u32x8::splat(0x846c_a68b);
    x ^ (x >> 16u32)
}

/// [`unit`] of eight hashes.
#[inline]
pub(super) fn unit8(h: u32x8) -> f32x8 {
    // Below 2²⁴, so that the sign does not matter.
    f32x8::from_i32x8((h >> 8u32).cast_signed()) * f32x8::splat(1.0 / 16_777_216.0)
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
    for first in (0..octaves).step_by(4) {
        let (mut keeps, mut places, mut salts) = ([0.0; 4], [[0.0; 4]; 2], [0; 4]);
        let mut kept = 0;
        for octave in first..octaves.min(first + 4) {
            let keep = (wavelength / footprint_m.max(1e-4) * 0.5 - 0.5).clamp(0.0, 1.0);
            if keep == 0.0 {
                break;
            }
            let place = p / wavelength + octave as f32 * 0.7 * 13.7;
            (keeps[kept], places[0][kept], places[1][kept], salts[kept]) =
                (amplitude * keep, place.x, place.y, octave + 31);
            amplitude *= 0.55;
            wavelength *= 0.47;
            kept += 1;
        }
        if kept == 1 {
            return sum + keeps[0] * value2(Vec2::new(places[0][0], places[1][0]), salts[0]);
        }
        let values = value2x4(places, salts);
        for octave in 0..kept {
            sum += keeps[octave] * values[octave];
        }
        if kept < 4 {
            break;
        }
    }
    sum
}

/// The two nearest feature points of a jittered grid (Worley 1996): distances, and the id of the nearest in [0, 1).
pub(crate) fn cells2(p: Vec2, salt: u32) -> (f32, f32, f32) {
    const COLUMNS: i32x8 = i32x8::new([-1, 0, 1, -1, 0, 1, -1, 0]);
    const ROWS: i32x8 = i32x8::new([-1, -1, -1, 0, 0, 0, 1, 1]);
    let i = corner_of(p).as_ivec2();
    let (x, y) = (i32x8::splat(i.x) + COLUMNS, i32x8::splat(i.y) + ROWS);
    let [column, row] = [x, y].map(|c| u32x8::new(c.to_array().map(|c| c as u32)));
    let cell = |salt: u32| {
        let salt = u32x8::splat(salt.wrapping_mul(0x9e37_79b9));
        unit8(hash8(column ^ hash8(row + salt)))
    };
    let dx = f32x8::from_i32x8(x) + cell(salt) - f32x8::splat(p.x);
    let dy = f32x8::from_i32x8(y) + cell(salt ^ 0x55) - f32x8::splat(p.y);
    let distances = (dx * dx + dy * dy).sqrt().to_array();
    let last = i + IVec2::ONE;
    let aside = last.as_vec2() + Vec2::new(cell2(last, salt), cell2(last, salt ^ 0x55)) - p;
    // The standard library's root is one instruction, glam's a call.
    let last = (aside.x * aside.x + aside.y * aside.y).sqrt();
    let (mut first, mut second, mut nearest) = (last, f32::MAX, 8);
    for (cell, distance) in distances.into_iter().enumerate() {
        second = second.min(distance.max(first));
        nearest = if distance < first { cell as i32 } else { nearest };
        first = first.min(distance);
    }
    let nearest = i + IVec2::new(nearest % 3 - 1, nearest / 3 - 1);
    (first, second, cell2(nearest, salt ^ 0xaa))
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
        fn four_places_are_those_of_one_after_another(
            x in prop::array::uniform4(-1e4f32..1e4), y in prop::array::uniform4(-1e4f32..1e4), salts: [u32; 4],
        ) {
            let one = |i: usize| value2(Vec2::new(x[i], y[i]), salts[i]);
            prop_assert_eq!(value2x4([x, y], salts).map(f32::to_bits), std::array::from_fn(|i| one(i).to_bits()));
        }

        #[test]
        fn eight_places_are_those_of_one_after_another(
            x in prop::array::uniform8(-1e4f32..1e4), y in prop::array::uniform8(-1e4f32..1e4), salts: [u32; 8],
        ) {
            let one = |i: usize| value2(Vec2::new(x[i], y[i]), salts[i]);
            let eight = value2x8([x, y].map(f32x8::new), salts).to_array();
            prop_assert_eq!(eight.map(f32::to_bits), std::array::from_fn(|i| one(i).to_bits()));
        }

        #[test]
        fn the_nearest_feature_points_are_found(x in -1e3f32..1e3, y in -1e3f32..1e3, salt: u32) {
            let p = Vec2::new(x, y);
            let mut around: Vec<(f32, f32)> = (0..9)
                .map(|k| corner_of(p).as_ivec2() + IVec2::new(k % 3 - 1, k / 3 - 1))
                .map(|c| {
                    let feature = c.as_vec2() + Vec2::new(cell2(c, salt), cell2(c, salt ^ 0x55));
                    (feature.distance(p), cell2(c, salt ^ 0xaa))
                })
                .collect();
            around.sort_by(|a, b| a.0.total_cmp(&b.0));
            prop_assert_eq!(cells2(p, salt), (around[0].0, around[1].0, around[0].1));
        }

        #[test]
        fn octaves_are_summed_until_the_footprint_hides_them(
            x in -1e3f32..1e3, y in -1e3f32..1e3, wavelength_m in 0.02f32..90.0, octaves in 1u32..7,
            footprint_m in 0.0005f32..3.0,
        ) {
            let p = Vec2::new(x, y);
            let octave = |octave: u32| {
                let wavelength = (0..octave).fold(wavelength_m, |w, _| w * 0.47);
                let amplitude = (0..octave).fold(0.5f32, |a, _| a * 0.55);
                let keep = (wavelength / footprint_m * 0.5 - 0.5).clamp(0.0, 1.0);
                amplitude * keep * value2(p / wavelength + octave as f32 * 0.7 * 13.7, octave + 31)
            };
            let sum: f32 = (0..octaves).map(octave).fold(0.0, |sum, value| sum + value);
            prop_assert_eq!(filtered_fbm2(p, wavelength_m, octaves, footprint_m), sum);
        }

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
