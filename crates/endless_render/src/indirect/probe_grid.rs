//! A grid of irradiance probes in the air of what a camera sees: the ambient light of everything that moves.

use super::harmonics::SphericalHarmonics;
use glam::{UVec3, Vec2, Vec3A};

pub(super) const SPACING_M: f32 = 6.0;
/// Layers of probes.
pub(super) const LAYERS: usize = 5;
/// Heights of the layers above the ground: dense where cars and people are.
pub(super) const HEIGHTS_M: [f32; LAYERS] = [0.8, 2.2, 4.5, 9.0, 18.0];

/// Where probes are wanted.
pub(crate) struct ProbeRegion {
    /// Corners of a rectangle, seen from above.
    pub(crate) low: Vec2,
    pub(crate) high: Vec2,
    /// Height of the lowest ground in it.
    pub(crate) ground: f32,
    /// Which of many equal patterns the probes' rays follow.
    pub(crate) pattern: u32,
}

/// The probes around one camera's view.
pub(crate) struct ProbeGrid {
    low: Vec2,
    ground: Ground,
    pub(super) size: UVec3,
    pub(super) probes: Vec<Probe>,
}

/// From where the heights of probes count.
enum Ground {
    /// A plane at the lowest ground.
    Level(f32),
    /// The ground below each column of probes, row by row.
    Columns(Vec<f32>),
}

/// Light, and its trust beside its numbers: 0 inside walls, 1 in the open.
#[derive(Debug, Clone, Copy)]
pub(super) struct Probe(SphericalHarmonics);

impl Probe {
    pub(super) const NONE: Self = Self(SphericalHarmonics::ZERO);

    pub(super) fn new(light: SphericalHarmonics, trust: f32) -> Self {
        Self(light.with_spare(trust))
    }
}

impl ProbeGrid {
    /// A grid over a rectangle of ground, without its probes.
    pub(super) fn over(&ProbeRegion { low, high, ground, .. }: &ProbeRegion) -> Self {
        let columns = ((high.x - low.x) / SPACING_M).ceil().max(1.0) as u32 + 1;
        let rows = ((high.y - low.y) / SPACING_M).ceil().max(1.0) as u32 + 1;
        let ground = Ground::Level(ground);
        Self { low, ground, size: UVec3::new(columns, rows, LAYERS as u32), probes: Vec::new() }
    }

    /// A grid of known probes, layer by layer, over the ground below each column, row by row; `low` is its first corner.
    pub(super) fn of_columns(low: Vec2, columns: u32, ground: Vec<f32>, probes: Vec<Probe>) -> Self {
        let rows = ground.len() as u32 / columns;
        Self { low, ground: Ground::Columns(ground), size: UVec3::new(columns, rows, LAYERS as u32), probes }
    }

    /// Where a probe is.
    pub(super) fn position(&self, x: u32, y: u32, z: u32) -> Vec3A {
        let ground = match &self.ground {
            Ground::Level(ground) => *ground,
            Ground::Columns(ground) => ground[(y * self.size.x + x) as usize],
        };
        Vec3A::new(self.low.x + x as f32 * SPACING_M, self.low.y + y as f32 * SPACING_M, ground + HEIGHTS_M[z as usize])
    }

    /// Illuminance of a surface with this normal, klx: trilinear between the probes in the open.
    pub(crate) fn irradiance(&self, position: Vec3A, normal: Vec3A) -> Vec3A {
        let last = self.size - UVec3::ONE;
        let u = ((position.x - self.low.x) / SPACING_M).clamp(0.0, last.x as f32);
        let v = ((position.y - self.low.y) / SPACING_M).clamp(0.0, last.y as f32);
        let (x0, y0) = (u as u32, v as u32);
        let (fx, fy) = (u - u.floor(), v - v.floor());
        let columns = [(x0, 1.0 - fx), ((x0 + 1).min(last.x), fx)];
        let rows = [(y0, 1.0 - fy), ((y0 + 1).min(last.y), fy)];
        let height = position.z - self.ground_at(columns, rows);
        let layer = HEIGHTS_M[1..LAYERS - 1].iter().filter(|&&h| h <= height).count();
        let w = ((height - HEIGHTS_M[layer]) / (HEIGHTS_M[layer + 1] - HEIGHTS_M[layer])).clamp(0.0, 1.0);
        let layers = [(layer as u32, 1.0 - w), (layer as u32 + 1, w)];
        let mut sum = SphericalHarmonics::ZERO;
        let mut total = 0.0;
        for (z, of_layer) in layers {
            for (y, of_row) in rows {
                let row = (z * self.size.y + y) * self.size.x;
                for (x, of_column) in columns {
                    let Probe(light) = &self.probes[(row + x) as usize];
                    let weight = of_column * of_row * of_layer;
                    let weight = weight * light.spare() + 1e-6 * weight;
                    sum.accumulate(light, weight);
                    total += weight;
                }
            }
        }
        sum.irradiance(normal) / total.max(1e-9)
    }

    /// Between these columns and rows, each with its share.
    fn ground_at(&self, columns: [(u32, f32); 2], rows: [(u32, f32); 2]) -> f32 {
        match &self.ground {
            Ground::Level(ground) => *ground,
            Ground::Columns(ground) => {
                let along = |y: u32| columns.map(|(x, share)| ground[(y * self.size.x + x) as usize] * share);
                rows.into_iter().map(|(y, share)| along(y).iter().sum::<f32>() * share).sum()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::noise;
    use crate::sampling::{hammersley, sphere_direction};
    use proptest::prelude::*;

    fn grid() -> ProbeGrid {
        let (low, high) = (Vec2::new(-5.0, 2.0), Vec2::new(14.0, 13.0));
        let mut grid = ProbeGrid::over(&ProbeRegion { low, high, ground: 1.5, pattern: 0 });
        let probe = |i: u32| {
            let mut light = SphericalHarmonics::ZERO;
            for k in 0..6 {
                let number = |salt: u32| noise::cell1(i, 8 * k + salt);
                let direction = sphere_direction(Vec2::new(number(0), number(1)));
                light.add(direction, Vec3A::new(number(2), number(3), number(4)), 2.0);
            }
            Probe::new(light, (noise::cell1(i, 99) * 1.5 - 0.2).clamp(0.0, 1.0))
        };
        grid.probes = (0..grid.size.element_product()).map(probe).collect();
        grid
    }

    /// Illuminance by the corners' numbers.
    fn corner_by_corner(grid: &ProbeGrid, position: Vec3A, normal: Vec3A) -> Vec3A {
        let last = grid.size - UVec3::ONE;
        let u = ((position.x - grid.low.x) / SPACING_M).clamp(0.0, last.x as f32);
        let v = ((position.y - grid.low.y) / SPACING_M).clamp(0.0, last.y as f32);
        let height = position.z - 1.5;
        let layer = HEIGHTS_M.partition_point(|&h| h <= height).clamp(1, HEIGHTS_M.len() - 1) - 1;
        let w = ((height - HEIGHTS_M[layer]) / (HEIGHTS_M[layer + 1] - HEIGHTS_M[layer])).clamp(0.0, 1.0);
        let low = UVec3::new(u as u32, v as u32, layer as u32);
        let (mut sum, mut total) = (SphericalHarmonics::ZERO, 0.0);
        for corner in 0..8u32 {
            let aside = UVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
            let of_axis = |aside, share: f32| if aside == 1 { share } else { 1.0 - share };
            let weight = of_axis(aside.x, u - low.x as f32) * of_axis(aside.y, v - low.y as f32) * of_axis(aside.z, w);
            let at = (low + aside).min(last);
            let Probe(light) = &grid.probes[((at.z * grid.size.y + at.y) * grid.size.x + at.x) as usize];
            let weight = weight * light.spare() + 1e-6 * weight;
            sum.accumulate(light, weight);
            total += weight;
        }
        sum.irradiance(normal) / total.max(1e-9)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn light_is_that_of_the_corners(
            places in prop::collection::vec((-9f32..20.0, -3f32..19.0, 0f32..24.0, 0u32..999, any::<bool>()), 64),
        ) {
            let grid = grid();
            for (x, y, z, facing, on_probe) in places {
                let place = Vec3A::new(x, y, z);
                let place = if on_probe { ((place - grid.position(0, 0, 0)) / 6.0).floor() * 6.0 + grid.position(0, 0, 0) } else { place };
                let normal = sphere_direction(hammersley(facing, 999));
                let (found, expected) = (grid.irradiance(place, normal), corner_by_corner(&grid, place, normal));
                prop_assert_eq!(found.to_array().map(f32::to_bits), expected.to_array().map(f32::to_bits));
            }
        }
    }
}
