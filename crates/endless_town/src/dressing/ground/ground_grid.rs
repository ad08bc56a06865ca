//! Ground heights on a grid: they follow the roads, are smooth between them, and rise to hills all around.

use crate::dressing::ground::pavement_index::PavementIndex;
use endless_road::Terrain;
use glam::DVec2;
use rayon::prelude::*;

/// Ground around the roads that belongs to the grid, metres.
pub(crate) const MARGIN_M: f64 = 90.0;
/// Most cells, and the side of the finest, metres.
const MOST_CELLS: f64 = 240_000.0;
const FINEST_M: f64 = 2.0;
/// Beside pavements the ground lies this much below them, under them this much.
const BESIDE_M: f64 = 0.05;
const UNDER_M: f64 = 0.45;
/// Asphalt between strips lies on the land if no further above or below it; else it is on a bridge or under one, metres.
const ALIKE_M: f64 = 1.2;
/// Width of banks: the least, and by metre of height between a road and the terrain.
const LEAST_BANK_M: f64 = 5.0;
const BANK: f64 = 1.7;

/// A grid of heights.
#[derive(Debug, Clone)]
pub(crate) struct GroundGrid {
    pub(super) low: DVec2,
    pub(super) cell: f64,
    /// Vertices, one more than cells.
    pub(super) nx: usize,
    pub(super) ny: usize,
    /// As seen, below pavements too.
    pub(super) heights: Vec<f64>,
    /// Without the cut below pavements.
    pub(super) level: Vec<f64>,
    /// Terrain beyond the roads' banks, where the map has it.
    pub(super) terrain: Option<Terrain>,
}

impl GroundGrid {
    /// Through the pavements of a map, and as its terrain lies away from them; bridges do not carry land.
    pub(crate) fn new(
        pavement: &PavementIndex,
        on_bridge: &(dyn Fn(u32) -> bool + Sync),
        terrain: Option<&Terrain>,
        low: DVec2,
        high: DVec2,
    ) -> Self {
        let (low, high) = (low - MARGIN_M, high + MARGIN_M);
        let size = high - low;
        let cell = (size.x * size.y / MOST_CELLS).sqrt().max(FINEST_M);
        let (nx, ny) = ((size.x / cell).ceil() as usize + 1, (size.y / cell).ceil() as usize + 1);
        let flat = vec![0.0; nx * ny];
        let mut land = Self { low, cell, nx, ny, heights: flat.clone(), level: flat, terrain: terrain.cloned() };
        let ground = |p: DVec2| {
            let here = pavement.at(p).filter(|(piece, _)| !on_bridge(piece.strip));
            here.map(|(_, z)| z).min_by(f64::total_cmp)
        };
        // The lowest road near by decides, so that none is buried by a higher one beside it.
        let way = |k: usize| crate::geometry::unit(std::f64::consts::FRAC_PI_4 * k as f64) * (cell * 0.75);
        let ways: [DVec2; 8] = std::array::from_fn(way);
        let place = |i: usize| {
            let p = land.vertex(i % nx, i / nx);
            let here = ground(p);
            let around = ways.iter().filter_map(|way| ground(p + way));
            (around.chain(here).min_by(f64::total_cmp), here.is_some())
        };
        let (mut known, under): (Vec<Option<f64>>, Vec<bool>) = (0..nx * ny).into_par_iter().map(place).unzip();
        if let Some(terrain) = terrain {
            land.apply_terrain(terrain, &mut known);
        }
        land.level = spread(&known, nx, ny);
        let between = |i: usize| {
            let level = land.level[i];
            pavement.between(land.vertex(i % nx, i / nx)).filter(|z| (z - level).abs() < ALIKE_M).min_by(f64::total_cmp)
        };
        let cut = |i: usize| match between(i) {
            Some(z) => z.min(land.level[i]) - UNDER_M,
            None => land.level[i] - if under[i] { UNDER_M } else { BESIDE_M },
        };
        land.heights = (0..nx * ny).into_par_iter().map(cut).collect();
        land
    }

    /// Takes the terrain's height wherever no bank reaches from a road that lies above or below it.
    fn apply_terrain(&self, terrain: &Terrain, known: &mut [Option<f64>]) {
        let natural: Vec<f64> =
            (0..known.len()).map(|i| terrain.height(self.vertex(i % self.nx, i / self.nx))).collect();
        let mut reach: Vec<f64> = known
            .iter()
            .zip(&natural)
            .map(|(known, natural)| known.map_or(0.0, |z| LEAST_BANK_M + BANK * (z - natural).abs()))
            .collect();
        let n = known.len();
        for _ in 0..2 {
            for i in 0..n {
                let before = if i % self.nx > 0 { reach[i - 1] } else { 0.0 };
                let below = if i >= self.nx { reach[i - self.nx] } else { 0.0 };
                reach[i] = reach[i].max(before.max(below) - self.cell);
            }
            for i in (0..n).rev() {
                let after = if (i + 1) % self.nx > 0 && i + 1 < n { reach[i + 1] } else { 0.0 };
                let above = if i + self.nx < n { reach[i + self.nx] } else { 0.0 };
                reach[i] = reach[i].max(after.max(above) - self.cell);
            }
        }
        for i in 0..n {
            if known[i].is_none() && reach[i] <= 0.0 {
                known[i] = Some(natural[i]);
            }
        }
    }

    pub(super) fn vertex(&self, x: usize, y: usize) -> DVec2 {
        self.low + DVec2::new(x as f64, y as f64) * self.cell
    }

    fn sample(&self, field: &[f64], p: DVec2) -> f64 {
        let q = ((p - self.low) / self.cell).clamp(DVec2::ZERO, DVec2::new((self.nx - 1) as f64, (self.ny - 1) as f64));
        let (x, y) = ((q.x as usize).min(self.nx - 2), (q.y as usize).min(self.ny - 2));
        let (u, v) = (q.x - x as f64, q.y - y as f64);
        let at = |x: usize, y: usize| field[y * self.nx + x];
        // The same two triangles as the mesh has.
        let (a, b, c, d) = (at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
        if u >= v { a + (b - a) * u + (c - b) * v } else { a + (c - d) * u + (d - a) * v }
    }

    /// Height of the ground as it is seen.
    pub(crate) fn height(&self, p: DVec2) -> f64 {
        self.sample(&self.heights, p)
    }

    /// Height of the ground before it is cut away below pavements.
    pub(crate) fn level(&self, p: DVec2) -> f64 {
        self.sample(&self.level, p)
    }

    /// Lowest and highest ground on an outline.
    pub(crate) fn range(&self, outline: &[DVec2]) -> (f64, f64) {
        let heights = outline.iter().map(|&p| self.level(p));
        heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), z| (l.min(z), h.max(z)))
    }

    /// The height that half the places on an outline lie above, of those on the grid.
    pub(crate) fn middle(&self, outline: &[DVec2]) -> f64 {
        let high = self.vertex(self.nx - 1, self.ny - 1);
        let inside = outline.iter().filter(|p| p.cmpge(self.low).all() && p.cmple(high).all());
        let mut heights: Vec<f64> = inside.map(|&p| self.level(p)).collect();
        heights.sort_by(f64::total_cmp);
        heights.get(heights.len() / 2).copied().unwrap_or(0.0)
    }
}

/// Fills what is unknown: averages over ever coarser grids, then smoothing that leaves the known alone.
fn spread(known: &[Option<f64>], nx: usize, ny: usize) -> Vec<f64> {
    let mut field = pull(known, nx, ny);
    for _ in 0..60 {
        for i in 0..field.len() {
            if known[i].is_some() {
                continue;
            }
            let (x, y) = (i % nx, i / nx);
            let (l, r) = (x.saturating_sub(1), (x + 1).min(nx - 1));
            let (d, u) = (y.saturating_sub(1), (y + 1).min(ny - 1));
            field[i] = (field[y * nx + l] + field[y * nx + r] + field[d * nx + x] + field[u * nx + x]) / 4.0;
        }
    }
    field
}

/// Each unknown takes the mean of the known in the smallest square around it that has any (pull and push).
fn pull(known: &[Option<f64>], nx: usize, ny: usize) -> Vec<f64> {
    if known.iter().all(Option::is_some) || nx * ny <= 1 {
        return known.iter().map(|k| k.unwrap_or(0.0)).collect();
    }
    let (hx, hy) = (nx.div_ceil(2), ny.div_ceil(2));
    let mut sums = vec![(0.0, 0u32); hx * hy];
    for (i, z) in known.iter().enumerate().filter_map(|(i, k)| k.map(|z| (i, z))) {
        let sum = &mut sums[(i / nx / 2) * hx + (i % nx) / 2];
        *sum = (sum.0 + z, sum.1 + 1);
    }
    let halved: Vec<Option<f64>> = sums.iter().map(|&(z, n)| (n > 0).then(|| z / f64::from(n))).collect();
    let coarse = pull(&halved, hx, hy);
    (0..nx * ny)
        .map(|i| {
            known[i].unwrap_or_else(|| {
                // Between the four coarse cells around, so that no steps show.
                let (x, y) = ((i % nx) as f64 / 2.0 - 0.25, (i / nx) as f64 / 2.0 - 0.25);
                let (x, y) = (x.clamp(0.0, (hx - 1) as f64), y.clamp(0.0, (hy - 1) as f64));
                let (x0, y0) = (x as usize, y as usize);
                let (x1, y1) = ((x0 + 1).min(hx - 1), (y0 + 1).min(hy - 1));
                let (u, v) = (x - x0 as f64, y - y0 as f64);
                let row = |y: usize| coarse[y * hx + x0] * (1.0 - u) + coarse[y * hx + x1] * u;
                row(y0) * (1.0 - v) + row(y1) * v
            })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use proptest::prelude::*;

    #[test]
    fn land_lies_below_the_asphalt_between_strips_and_knows_bridges() {
        let (low, high) = (DVec2::ZERO, DVec2::splat(80.0));
        let square = |from: f64, z: f64| {
            [(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)].map(|(x, y)| DVec3::new(from + x, from + y, z))
        };
        let mut pavement = PavementIndex::new(&[], low, high);
        pavement.add_between(&square(10.0, -0.1));
        pavement.add_between(&square(50.0, 6.0));
        let land = GroundGrid::new(&pavement, &|_| false, None, low, high);
        assert!(land.height(DVec2::splat(20.0)) < -0.1 - 0.3);
        // Grass beside it reaches up to its edge, not through it.
        assert!((0..20).all(|k| land.height(DVec2::new(10.5 + 0.95 * f64::from(k), 11.0)) < -0.1));
        assert!((land.height(DVec2::splat(60.0)) + BESIDE_M).abs() < 1e-9, "a bridge leaves the land as it is");
        assert!(pavement.is_paved(DVec2::splat(60.0)) && pavement.is_carriageway(DVec2::new(29.0, 11.0)));
        assert!(!pavement.is_paved(DVec2::splat(40.0)) && pavement.height(DVec2::splat(60.0), 3.0).is_none());
    }

    proptest! {
        #[test]
        fn unknown_heights_stay_between_the_known(
            places in prop::collection::vec((0usize..30, 0usize..20, -5.0..20.0f64), 1..12),
        ) {
            let mut known = vec![None; 600];
            for &(x, y, z) in &places {
                known[y * 30 + x] = Some(z);
            }
            let (low, high) = known.iter().flatten().fold((f64::MAX, f64::MIN), |(l, h), &z| (l.min(z), h.max(z)));
            let field = spread(&known, 30, 20);
            for (z, known) in field.iter().zip(&known) {
                prop_assert!((low - 1e-9..=high + 1e-9).contains(z));
                prop_assert!(known.is_none_or(|k| (k - z).abs() < 1e-12));
            }
        }
    }
}
