//! Street lamps: many small lights in a grid, so that a point asks only those that reach it.

use endless_scene::StreetLamp;
use endless_world::math;
use glam::{Vec2, Vec3A};

/// Beyond this a lamp's light is nothing.
const RANGE_M: f32 = 32.0;
const CELL_M: f32 = 16.0;
/// Lamps that a cell knows: a bit each in a mask.
const MOST: usize = 32;

/// One street lamp.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PointLamp {
    /// Just below the lens.
    pub(crate) position: Vec3A,
    /// Luminous intensity straight down, kcd a channel.
    pub(crate) intensity: Vec3A,
}

impl PointLamp {
    /// Illuminance of a surface facing the lamp, klx a channel: inverse square, batwing distribution with a cut-off
    /// towards the horizon, faded out at the end of its range.
    #[inline]
    pub(crate) fn illuminance_at(&self, point: Vec3A) -> (Vec3A, Vec3A) {
        let to_lamp = self.position - point;
        let distance_squared = to_lamp.length_squared().max(0.01);
        if distance_squared > RANGE_M * RANGE_M {
            return (Vec3A::ZERO, Vec3A::Z);
        }
        let distance = distance_squared.sqrt();
        let direction = to_lamp / distance;
        let down = direction.z;
        // Street luminaires throw more light aside than down: about 1 / cos² up to 65°, none above 80°.
        let batwing = (1.0 / (down * down).max(0.16)).min(2.6) * math::smoothstep(0.10, 0.42, down);
        let q = distance_squared / (RANGE_M * RANGE_M);
        let window = (1.0 - q * q).max(0.0);
        (self.intensity * (batwing * window * window / distance_squared), direction)
    }
}

/// All lamps of a scene.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lamps {
    lights: Vec<PointLamp>,
    low: Vec2,
    columns: usize,
    rows: usize,
    /// The nearest lamps in reach of each cell, at most [`MOST`], ascending.
    cells: Vec<Vec<u16>>,
}

impl Lamps {
    /// Indexes lamps.
    pub(crate) fn new(lamps: &[StreetLamp]) -> Self {
        let lights: Vec<PointLamp> = lamps
            .iter()
            .map(|l| PointLamp {
                position: Vec3A::from(l.position) - Vec3A::Z * 0.12,
                intensity: Vec3A::from_array(l.color) * (l.intensity_cd * 1e-3),
            })
            .collect();
        let Some(first) = lights.first() else { return Self::default() };
        let flat = |l: &PointLamp| Vec2::new(l.position.x, l.position.y);
        let (low, high) = lights.iter().fold((flat(first), flat(first)), |(a, b), l| (a.min(flat(l)), b.max(flat(l))));
        let (low, high) = (low - RANGE_M, high + RANGE_M);
        let size = ((high - low) / CELL_M).ceil();
        let (columns, rows) = (size.x as usize, size.y as usize);
        let mut cells = vec![Vec::new(); columns * rows];
        for (i, light) in lights.iter().enumerate() {
            for row in 0..rows {
                for column in 0..columns {
                    let cell_low = low + Vec2::new(column as f32, row as f32) * CELL_M;
                    let nearest = flat(light).clamp(cell_low, cell_low + CELL_M);
                    if nearest.distance(flat(light)) < RANGE_M {
                        cells[row * columns + column].push(i as u16);
                    }
                }
            }
        }
        for (i, cell) in cells.iter_mut().enumerate().filter(|(_, cell)| cell.len() > MOST) {
            let centre = low + (Vec2::new((i % columns) as f32, (i / columns) as f32) + 0.5) * CELL_M;
            cell.sort_by(|&a, &b| {
                let distance = |i: u16| flat(&lights[usize::from(i)]).distance_squared(centre);
                distance(a).total_cmp(&distance(b)).then(a.cmp(&b))
            });
            cell.truncate(MOST);
            cell.sort_unstable();
        }
        Self { lights, low, columns, rows, cells }
    }

    /// The lamp, by its place in the list, whose lens has its middle at a place; none if that is the lens of none.
    pub(crate) fn at(&self, lens: Vec3A) -> Option<usize> {
        /// Bowls and flat heads have their middles not quite where their light is, metres.
        const BESIDE_M: f32 = 0.6;
        let distance = |&place: &u16| self.lights[usize::from(place)].position.distance(lens);
        let nearest = self.indices_near(lens).iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        (distance(nearest) < BESIDE_M).then_some(usize::from(*nearest))
    }

    /// The same lamps with their light changed by factors a channel, given their places in the list and where they hang.
    #[must_use]
    pub(crate) fn scaled(&self, factors: impl Fn(usize, Vec3A) -> Vec3A) -> Self {
        let mut lamps = self.clone();
        for (place, lamp) in lamps.lights.iter_mut().enumerate() {
            lamp.intensity *= factors(place, lamp.position);
        }
        lamps
    }

    /// Lamps that may reach a point; the position in this list is the lamp's bit in masks of that point.
    pub(crate) fn near(&self, point: Vec3A) -> impl Iterator<Item = &PointLamp> {
        self.indices_near(point).iter().map(|&i| &self.lights[usize::from(i)])
    }

    /// The same as indices into [`Self::all`], ascending.
    pub(crate) fn indices_near(&self, point: Vec3A) -> &[u16] {
        let cell = ((Vec2::new(point.x, point.y) - self.low) / CELL_M).floor();
        let inside =
            cell.x >= 0.0 && cell.y >= 0.0 && (cell.x as usize) < self.columns && (cell.y as usize) < self.rows;
        if inside { &self.cells[cell.y as usize * self.columns + cell.x as usize] } else { &[] }
    }

    /// All of them.
    pub(crate) fn all(&self) -> &[PointLamp] {
        &self.lights
    }

    /// How far a lamp reaches, metres.
    pub(crate) const fn range_m() -> f32 {
        RANGE_M
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn a_lamp_follows_the_inverse_square() {
        let lamps =
            Lamps::new(&[StreetLamp { position: Vec3::new(0.0, 0.0, 8.12), color: [1.0; 3], intensity_cd: 5000.0 }]);
        let at = |z: f32| {
            lamps.near(Vec3A::new(0.0, 0.0, z)).map(|l| l.illuminance_at(Vec3A::new(0.0, 0.0, z)).0.x).sum::<f32>()
        };
        // 5 kcd at 4 m and at 8 m: a quarter (the range window takes less than 1 %).
        assert!((at(4.0) / at(0.0) - 4.0).abs() < 0.05);
        assert!((at(0.0) - 5.0 / 64.0).abs() < 0.001);
        assert!(lamps.near(Vec3A::new(500.0, 0.0, 0.0)).next().is_none());
    }
}
