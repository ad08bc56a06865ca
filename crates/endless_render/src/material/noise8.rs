//! Lattice noise of eight pixels side by side: the bits of [`noise`](super::noise) in each.

use super::noise::{self, hash8, unit8};
use super::noise_questions::NoiseQuestions;
use glam::Vec2;
use wide::{f32x8, u32x8};

/// The cell of a lattice that a corner without fractions belongs to.
#[inline]
fn cell_of(corner: f32x8) -> u32x8 {
    corner.fast_trunc_int().cast_unsigned()
}

/// What a salt adds to the row of a cell.
#[inline]
fn salted(row: u32x8, salt: u32) -> u32x8 {
    row + u32x8::splat(salt.wrapping_mul(0x9e37_79b9))
}

/// [`noise::cell2`] of eight cells, told by their corners.
#[inline]
pub(super) fn cell2x8([x, y]: [f32x8; 2], salt: u32) -> f32x8 {
    unit8(hash8(cell_of(x) ^ hash8(salted(cell_of(y), salt))))
}

/// [`noise::value2`] of eight places.
#[inline]
pub(super) fn value2x8(p: [f32x8; 2], salt: u32) -> f32x8 {
    let [value] = values2x8([p], [salt]);
    value
}

/// [`value2x8`] of one set of places or of two, each with its salt: two are found in hardly more time than one, as each
/// step waits for the one before.
#[inline(always)]
fn values2x8<const N: usize>(p: [[f32x8; 2]; N], salts: [u32; N]) -> [f32x8; N] {
    let corner = p.map(|p| p.map(f32x8::floor));
    let shares: [[f32x8; 2]; N] = std::array::from_fn(|n| {
        [0, 1].map(|k| p[n][k] - corner[n][k]).map(|t| t * t * (f32x8::splat(3.0) - f32x8::splat(2.0) * t))
    });
    let cells = corner.map(|corner| corner.map(cell_of));
    let rows: [u32x8; N] = std::array::from_fn(|n| salted(cells[n][1], salts[n]));
    let corners = if are_shared(&cells) {
        shared_corners(cells.map(|cell| cell[0]), rows)
    } else {
        std::array::from_fn(|n| noise::corners_of(cells[n][0], rows[n]))
    };
    std::array::from_fn(|n| noise::between(corners[n], shares[n]))
}

/// Whether all eight places lie in one cell. Pixels side by side mostly do, of all but the finest noise.
#[inline(always)]
fn are_shared<const N: usize>(cells: &[[u32x8; 2]; N]) -> bool {
    let differing = cells.as_flattened().iter().map(|cells| *cells ^ u32x8::splat(cells.as_array()[0]));
    differing.fold(u32x8::ZERO, |all, one| all | one).simd_eq(u32x8::ZERO).all()
}

/// [`noise::corners_of`] one cell that all eight share, or of two: four lanes each.
#[inline(always)]
fn shared_corners<const N: usize>(columns: [u32x8; N], rows: [u32x8; N]) -> [[f32x8; 4]; N] {
    const COLUMNS: u32x8 = u32x8::new([0, 1, 0, 1, 0, 1, 0, 1]);
    const ROWS: u32x8 = u32x8::new([0, 0, 1, 1, 0, 0, 1, 1]);
    let four_each = |cells: [u32x8; N]| u32x8::new(std::array::from_fn(|lane| cells[lane / 4 % N].as_array()[0]));
    let corners = unit8(hash8((four_each(columns) + COLUMNS) ^ hash8(four_each(rows) + ROWS)));
    std::array::from_fn(|n| [0, 1, 2, 3].map(|k| f32x8::splat(corners.as_array()[4 * n + k])))
}

/// [`noise::filtered_fbm2`] of eight places, each with its wavelength and its footprint, metres.
pub(super) fn filtered_fbm2x8(p: [f32x8; 2], wavelength_m: f32x8, octaves: u32, footprint_m: f32x8) -> f32x8 {
    let mut sum = FilteredSum {
        p,
        finest: footprint_m.fast_max(f32x8::splat(1e-4)),
        wavelength: wavelength_m,
        amplitude: 0.5,
        sum: f32x8::ZERO,
    };
    let mut octave = 0;
    while octave + 1 < octaves && sum.keeps(sum.wavelength * f32x8::splat(0.47)) {
        sum.add([octave, octave + 1]);
        octave += 2;
    }
    if octave < octaves && sum.keeps(sum.wavelength) {
        sum.add([octave]);
    }
    sum.sum
}

/// A sum of octaves, as far as it is added up.
struct FilteredSum {
    p: [f32x8; 2],
    /// The footprints take away what is shorter, metres.
    finest: f32x8,
    /// Of the next octave, metres.
    wavelength: f32x8,
    amplitude: f32,
    sum: f32x8,
}

impl FilteredSum {
    /// Whether a pixel keeps any of an octave.
    #[inline(always)]
    fn keeps(&self, wavelength: f32x8) -> bool {
        wavelength.simd_gt(self.finest).any()
    }

    /// Adds the next octaves.
    #[inline(always)]
    fn add<const N: usize>(&mut self, octaves: [u32; N]) {
        let next = octaves.map(|octave| {
            let offset = f32x8::splat(octave as f32 * 0.7 * 13.7);
            let place = self.p.map(|axis| axis / self.wavelength + offset);
            let half = f32x8::splat(0.5);
            let keep = (self.wavelength / self.finest * half - half).fast_clamp(f32x8::ZERO, f32x8::ONE);
            let scale = f32x8::splat(self.amplitude) * keep;
            self.amplitude *= 0.55;
            self.wavelength *= f32x8::splat(0.47);
            (place, scale)
        });
        let values = values2x8(next.map(|(place, _)| place), octaves.map(|octave| octave + 31));
        for ((_, scale), value) in next.into_iter().zip(values) {
            self.sum += scale * value;
        }
    }
}

/// [`noise::cells2`] of eight places.
pub(super) fn cells2x8(p: [f32x8; 2], salt: u32) -> [f32x8; 3] {
    let corner = p.map(f32x8::floor);
    let [column, row] = corner.map(cell_of);
    let features = if are_shared(&[[column, row]]) {
        shared_features(column, row, salt)
    } else {
        features_around(column, row, salt)
    };
    let mut found = nearest_features(p, corner, &features, salt);
    // Roots can be equal where the squares differ, and then the one-pixel way may hold another to be the nearest.
    let equal = found[0].simd_eq(found[1]);
    if equal.any() {
        settle(&mut found, p, salt, equal.to_bitmask());
    }
    found
}

/// The cells around a cell, by what is to be added to its column and row: in the order of the one-pixel way, in which
/// the first of equals is the nearest.
const AROUND: [[i32; 2]; 9] = [[1, 1], [-1, -1], [0, -1], [1, -1], [-1, 0], [0, 0], [1, 0], [-1, 1], [0, 1]];

/// Where in each of the cells around eight cells its feature point lies.
#[inline]
fn features_around(column: u32x8, row: u32x8, salt: u32) -> [[f32x8; 2]; 9] {
    let aside = |cells: u32x8, by: i32| cells + u32x8::splat(by as u32);
    let rows = [-1, 0, 1].map(|by| [salt, salt ^ 0x55].map(|salt| hash8(salted(aside(row, by), salt))));
    AROUND.map(|[c, r]| rows[(r + 1) as usize].map(|row| unit8(hash8(aside(column, c) ^ row))))
}

/// [`features_around`] one cell that all share: a lane each.
#[inline]
fn shared_features(column: u32x8, row: u32x8, salt: u32) -> [[f32x8; 2]; 9] {
    const COLUMNS: u32x8 = lanes_around(0);
    const ROWS: u32x8 = lanes_around(1);
    let features = [salt, salt ^ 0x55].map(|salt| {
        let row = salted(row, salt);
        let eight = unit8(hash8((column + COLUMNS) ^ hash8(row + ROWS)));
        let last = unit8(hash8(column ^ hash8(row + u32x8::splat(1))));
        (eight, last)
    });
    std::array::from_fn(|k| features.map(|(eight, last)| if k < 8 { f32x8::splat(eight.as_array()[k]) } else { last }))
}

/// What the first eight of [`AROUND`] add to columns (0) or to rows (1).
const fn lanes_around(axis: usize) -> u32x8 {
    let mut lanes = [0; 8];
    let mut k = 0;
    while k < 8 {
        lanes[k] = AROUND[k][axis] as u32;
        k += 1;
    }
    u32x8::new(lanes)
}

/// The distances of the two nearest feature points of those in the cells [`AROUND`] each place, and the nearest's id.
#[inline(always)]
fn nearest_features([x, y]: [f32x8; 2], corner: [f32x8; 2], features: &[[f32x8; 2]; 9], salt: u32) -> [f32x8; 3] {
    // Squares of distances: roots are taken of the two that matter.
    let (mut first, mut second) = (f32x8::splat(f32::MAX), f32x8::splat(f32::MAX));
    let mut nearest = [f32x8::ZERO; 2];
    for ([dx, dy], aside) in features.iter().zip(AROUND) {
        let low: [f32x8; 2] = std::array::from_fn(|k| corner[k] + f32x8::splat(aside[k] as f32));
        let (dx, dy) = (low[0] + *dx - x, low[1] + *dy - y);
        let distance = dx * dx + dy * dy;
        let nearer = distance.simd_lt(first);
        second = second.fast_min(distance.fast_max(first));
        first = first.fast_min(distance);
        nearest = std::array::from_fn(|k| nearer.select(low[k], nearest[k]));
    }
    [first.sqrt(), second.sqrt(), cell2x8(nearest, salt ^ 0xaa)]
}

/// Finds a few of eight places one after another.
#[cold]
fn settle(found: &mut [f32x8; 3], [x, y]: [f32x8; 2], salt: u32, lanes: u32) {
    let (x, y) = (x.to_array(), y.to_array());
    for lane in (0..8).filter(|lane| lanes >> lane & 1 == 1) {
        let one: [f32; 3] = noise::cells2(Vec2::new(x[lane], y[lane]), salt).into();
        for (found, one) in found.iter_mut().zip(one) {
            found.as_mut_array()[lane] = one;
        }
    }
}

/// Noise that a material wants of eight pixels: found when it is looked up.
pub(super) struct NoiseQuestions8 {
    footprint_m: f32x8,
}

/// One question.
#[derive(Clone, Copy)]
pub(super) enum Asked8 {
    Value { p: [f32x8; 2], salt: u32 },
    Sum { p: [f32x8; 2], wavelength_m: f32x8, octaves: u32 },
}

impl NoiseQuestions<f32x8> for NoiseQuestions8 {
    type Asked = Asked8;

    #[inline]
    fn new(footprint_m: f32x8) -> Self {
        Self { footprint_m }
    }

    #[inline]
    fn value2(&mut self, p: [f32x8; 2], salt: u32) -> Asked8 {
        Asked8::Value { p, salt }
    }

    #[inline]
    fn fbm2_of(&mut self, p: [f32x8; 2], wavelength_m: f32x8, octaves: u32) -> Asked8 {
        Asked8::Sum { p, wavelength_m, octaves }
    }

    #[inline]
    fn fbm2(&mut self, p: [f32x8; 2], wavelength_m: f32, octaves: u32) -> Self::Asked {
        self.fbm2_of(p, f32x8::splat(wavelength_m), octaves)
    }

    #[inline]
    fn found(&self) -> impl Fn(Asked8) -> f32x8 {
        |asked| match asked {
            Asked8::Value { p, salt } => value2x8(p, salt),
            Asked8::Sum { p, wavelength_m, octaves } => filtered_fbm2x8(p, wavelength_m, octaves, self.footprint_m),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Places of eight pixels, in one another's neighbourhood or far apart.
    fn places() -> impl Strategy<Value = [[f32; 8]; 2]> {
        let axis = || (-2e3f32..2e3, prop::array::uniform8(-1f32..1.0), 0..4i32);
        let axis = move || {
            axis().prop_map(|(at, aside, spread)| {
                aside.map(|aside| at + aside * [0.001, 0.1, 10.0, 1e3][spread as usize])
            })
        };
        (axis(), axis()).prop_map(|(x, y)| [x, y])
    }

    proptest! {
        #[test]
        fn values_of_eight_are_those_of_one_after_another([x, y] in places(), salt: u32) {
            let eight = value2x8([x, y].map(f32x8::new), salt).to_array();
            let cells = cell2x8([x, y].map(|axis| f32x8::new(axis).floor()), salt).to_array();
            for i in 0..8 {
                let p = Vec2::new(x[i], y[i]);
                prop_assert_eq!(eight[i].to_bits(), noise::value2(p, salt).to_bits());
                prop_assert_eq!(cells[i].to_bits(), noise::cell2(noise::corner_of(p).as_ivec2(), salt).to_bits());
            }
        }

        #[test]
        fn sums_of_eight_are_those_of_one_after_another(
            [x, y] in places(), wavelengths in prop::array::uniform8(0.02f32..90.0), octaves in 1u32..7,
            footprints in prop::array::uniform8(0.0005f32..3.0), alike: bool,
        ) {
            let wavelengths = if alike { [wavelengths[0]; 8] } else { wavelengths };
            let [wide_lengths, wide_prints] = [wavelengths, footprints].map(f32x8::new);
            let eight = filtered_fbm2x8([x, y].map(f32x8::new), wide_lengths, octaves, wide_prints).to_array();
            for i in 0..8 {
                let one = noise::filtered_fbm2(Vec2::new(x[i], y[i]), wavelengths[i], octaves, footprints[i]);
                prop_assert_eq!(eight[i].to_bits(), one.to_bits());
            }
        }

        #[test]
        fn feature_points_of_eight_are_those_of_one_after_another([x, y] in places(), salt: u32) {
            let eight = cells2x8([x, y].map(f32x8::new), salt).map(f32x8::to_array);
            for i in 0..8 {
                let one: [f32; 3] = noise::cells2(Vec2::new(x[i], y[i]), salt).into();
                prop_assert_eq!(eight.map(|found| found[i].to_bits()), one.map(f32::to_bits));
            }
        }
    }
}
