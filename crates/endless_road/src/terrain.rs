//! The lie of the land as a grid of heights.

use glam::DVec2;

/// Heights on a square grid, linear between its vertices and level beyond its edges.
#[derive(Debug, Clone, PartialEq)]
pub struct Terrain {
    low: DVec2,
    step_m: f64,
    columns: usize,
    heights: Vec<f64>,
}

impl Terrain {
    /// Samples a height function, metres, every `step_m` metres over a box.
    pub fn new(low: DVec2, high: DVec2, step_m: f64, height: impl Fn(DVec2) -> f64) -> Self {
        let cells = ((high - low) / step_m).ceil().max(DVec2::ONE);
        let (columns, rows) = (cells.x as usize + 1, cells.y as usize + 1);
        let vertex = |i: usize| low + DVec2::new((i % columns) as f64, (i / columns) as f64) * step_m;
        let heights = (0..columns * rows).map(|i| height(vertex(i))).collect();
        Self { low, step_m, columns, heights }
    }

    /// The smallest and largest corner of the grid.
    pub fn bounds(&self) -> [DVec2; 2] {
        let rows = self.heights.len() / self.columns;
        [self.low, self.low + DVec2::new((self.columns - 1) as f64, (rows - 1) as f64) * self.step_m]
    }

    /// Height at a place, metres.
    pub fn height(&self, p: DVec2) -> f64 {
        let rows = self.heights.len() / self.columns;
        let most = DVec2::new((self.columns - 1) as f64, (rows - 1) as f64);
        let q = ((p - self.low) / self.step_m).clamp(DVec2::ZERO, most);
        let (x, y) = ((q.x as usize).min(self.columns - 2), (q.y as usize).min(rows - 2));
        let (u, v) = (q.x - x as f64, q.y - y as f64);
        let at = |x: usize, y: usize| self.heights[y * self.columns + x];
        let row = |y: usize| at(x, y) * (1.0 - u) + at(x + 1, y) * u;
        row(y) * (1.0 - v) + row(y + 1) * v
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn planes_are_kept(x in -90.0..90.0f64, y in -40.0..40.0f64, a in -0.3..0.3f64, b in -0.3..0.3f64) {
            let plane = |p: DVec2| 3.0 + a * p.x + b * p.y;
            let terrain = Terrain::new(DVec2::new(-100.0, -50.0), DVec2::new(101.0, 50.0), 7.0, plane);
            let p = DVec2::new(x, y);
            prop_assert!((terrain.height(p) - plane(p)).abs() < 1e-9);
        }
    }

    #[test]
    fn the_land_goes_on_level_beyond_the_grid() {
        let terrain = Terrain::new(DVec2::ZERO, DVec2::splat(10.0), 5.0, |p| p.x);
        assert!((terrain.height(DVec2::new(400.0, -70.0)) - 10.0).abs() < 1e-9);
        assert_eq!(terrain.bounds(), [DVec2::ZERO, DVec2::splat(10.0)]);
    }
}
