//! Ground heights on a grid: they follow the roads, are smooth between them, and rise to hills all around.

use crate::dressing::ground::pavement_index::PavementIndex;
use crate::palette::{HILL, LAWN, MEADOW};
use endless_road::Terrain;
use endless_scene::{Material, MeshBuilder};
use endless_world::math;
use endless_world::math::f64::{atan2, sin};
use glam::{DVec2, DVec3, Vec3};
use rayon::prelude::*;

/// Ground around the roads that belongs to the grid, metres.
pub(crate) const MARGIN_M: f64 = 90.0;
/// Most cells, and the side of the finest, metres.
const MOST_CELLS: f64 = 240_000.0;
const FINEST_M: f64 = 2.0;
/// Finer cells along a side of a cell in which ground of different kinds meets.
const FINER: usize = 3;
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
    low: DVec2,
    cell: f64,
    /// Vertices, one more than cells.
    nx: usize,
    ny: usize,
    /// As seen, below pavements too.
    heights: Vec<f64>,
    /// Without the cut below pavements.
    level: Vec<f64>,
    /// Terrain beyond the roads' banks, where the map has it.
    terrain: Option<Terrain>,
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
            land.know_terrain(terrain, &mut known);
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
    fn know_terrain(&self, terrain: &Terrain, known: &mut [Option<f64>]) {
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

    fn vertex(&self, x: usize, y: usize) -> DVec2 {
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

    /// The grid as a mesh, and hills around it. `material` says what covers a place.
    pub(crate) fn add(&self, mesh: &mut MeshBuilder, seed: u64, material: &dyn Fn(DVec2) -> Material) {
        let base = mesh.vertices((0..self.nx * self.ny).map(|i| {
            let p = self.vertex(i % self.nx, i / self.nx).extend(self.heights[i]).as_vec3();
            (p, self.normal(i % self.nx, i / self.nx), p.truncate())
        }));
        let index = |x: usize, y: usize| base + (y * self.nx + x) as u32;
        let covers: Vec<Material> =
            (0..self.nx * self.ny).map(|i| material(self.vertex(i % self.nx, i / self.nx))).collect();
        for y in 0..self.ny - 1 {
            for x in 0..self.nx - 1 {
                let i = y * self.nx + x;
                let m = covers[i];
                if [i + 1, i + self.nx, i + self.nx + 1].iter().any(|&k| covers[k] != m) {
                    self.add_border(mesh, (x, y), material);
                    continue;
                }
                mesh.triangle_indices([index(x, y), index(x + 1, y), index(x + 1, y + 1)], m);
                mesh.triangle_indices([index(x, y), index(x + 1, y + 1), index(x, y + 1)], m);
            }
        }
        self.add_hills(mesh, seed);
    }

    /// A cell in which ground of different kinds meets: finer triangles, cut where the kind changes.
    fn add_border(&self, mesh: &mut MeshBuilder, (x, y): (usize, usize), material: &dyn Fn(DVec2) -> Material) {
        let at = |i: usize, k: usize| self.vertex(x, y) + DVec2::new(i as f64, k as f64) * (self.cell / FINER as f64);
        let corners: Vec<(DVec2, Material)> = (0..=FINER)
            .flat_map(|k| (0..=FINER).map(move |i| (i, k)))
            .map(|(i, k)| (at(i, k), material(at(i, k))))
            .collect();
        let index = |i: usize, k: usize| k * (FINER + 1) + i;
        for k in 0..FINER {
            for i in 0..FINER {
                let (a, b) = (index(i, k), index(i + 1, k));
                let (c, d) = (index(i + 1, k + 1), index(i, k + 1));
                for triangle in [[a, b, c], [a, c, d]] {
                    self.add_cut(mesh, triangle.map(|v| corners[v]), material);
                }
            }
        }
    }

    /// A triangle of one or two kinds of ground.
    fn add_cut(&self, mesh: &mut MeshBuilder, corners: [(DVec2, Material); 3], kind: &dyn Fn(DVec2) -> Material) {
        let mut add = |triangle: [DVec2; 3], m: Material| {
            let vertices = triangle.map(|p| (p.extend(self.height(p)).as_vec3(), self.normal_near(p), p.as_vec2()));
            let base = mesh.vertices(vertices);
            mesh.triangle_indices([base, base + 1, base + 2], m);
        };
        // The corner that differs from the two others.
        let single = (0..3).find(|&k| corners[(k + 1) % 3].1 == corners[(k + 2) % 3].1);
        let Some(k) = single else {
            let middle = (corners[0].0 + corners[1].0 + corners[2].0) / 3.0;
            add(corners.map(|c| c.0), kind(middle));
            return;
        };
        let [(a, own), (b, other), (c, _)] = [corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]];
        if own == other {
            add([a, b, c], own);
            return;
        }
        let change = |to: DVec2| {
            let (mut here, mut there) = (0.0, 1.0);
            for _ in 0..5 {
                let middle = (here + there) / 2.0;
                if kind(a.lerp(to, middle)) == own { here = middle } else { there = middle }
            }
            a.lerp(to, (here + there) / 2.0)
        };
        let (p, q) = (change(b), change(c));
        add([a, p, q], own);
        add([p, b, c], other);
        add([p, c, q], other);
    }

    fn normal(&self, x: usize, y: usize) -> Vec3 {
        let at = |x: usize, y: usize| self.heights[y.min(self.ny - 1) * self.nx + x.min(self.nx - 1)];
        let dx = at(x + 1, y) - at(x.saturating_sub(1), y);
        let dy = at(x, y + 1) - at(x, y.saturating_sub(1));
        DVec3::new(-dx, -dy, 2.0 * self.cell).normalize().as_vec3()
    }

    fn normal_near(&self, p: DVec2) -> Vec3 {
        let q = ((p - self.low) / self.cell).round().max(DVec2::ZERO);
        self.normal((q.x as usize).min(self.nx - 1), (q.y as usize).min(self.ny - 1))
    }

    /// The grid's border, counter-clockwise.
    fn border(&self) -> Vec<(usize, usize)> {
        let (x, y) = (self.nx - 1, self.ny - 1);
        let south = (0..x).map(|i| (i, 0));
        let east = (0..y).map(|i| (x, i));
        let north = (0..x).map(|i| (x - i, y));
        let west = (0..y).map(|i| (0, y - i));
        south.chain(east).chain(north).chain(west).collect()
    }

    /// The vertex of a ring of hills beyond vertex `k` of the border.
    fn ring_point(&self, border: &[(usize, usize)], seed: u64, ring: usize, k: usize) -> DVec3 {
        let (x, y) = border[k % border.len()];
        let from = self.vertex(x, y);
        let z = self.heights[y * self.nx + x];
        let middle = self.vertex(self.nx / 2, self.ny / 2);
        let (out, rise) = RINGS[ring];
        let p = from + (from - middle).normalize_or(DVec2::X) * out;
        if let Some(terrain) = &self.terrain {
            let join = (out / 40.0).min(1.0);
            let ground = z + (terrain.height(p) - z) * join;
            return p.extend(ground + rise * hilliness(p - middle, seed));
        }
        let fade = 1.0 / (1.0 + out / 250.0);
        p.extend(z * fade + (z.min(0.0)) * (1.0 - fade) + rise * hilliness(p - middle, seed))
    }

    fn add_hills(&self, mesh: &mut MeshBuilder, seed: u64) {
        let border = self.border();
        for ring in 0..RINGS.len() - 1 {
            let material = [MEADOW, MEADOW, LAWN][ring.min(2)];
            let material = if ring > 2 { HILL } else { material };
            for k in 0..border.len() {
                let point = |ring: usize, k: usize| self.ring_point(&border, seed, ring, k).as_vec3();
                let corners = [point(ring, k + 1), point(ring, k), point(ring + 1, k), point(ring + 1, k + 1)];
                mesh.quad(corners, corners.map(Vec3::truncate), material);
            }
        }
    }

    /// A place on the hills, from two numbers in 0..1 and a ring.
    pub(crate) fn on_hills(&self, seed: u64, ring: usize, (u, v): (f64, f64)) -> DVec3 {
        let border = self.border();
        let k = ((u * border.len() as f64) as usize).min(border.len() - 1);
        self.ring_point(&border, seed, ring, k).lerp(self.ring_point(&border, seed, ring + 1, k), v)
    }
}

/// Distance beyond the grid and height of each ring, metres.
const RINGS: [(f64, f64); 8] =
    [(0.0, 0.0), (30.0, 0.8), (80.0, 5.0), (170.0, 17.0), (320.0, 36.0), (600.0, 60.0), (1100.0, 80.0), (1800.0, 60.0)];

/// 0.3 to 1: where hills are high.
fn hilliness(p: DVec2, seed: u64) -> f64 {
    let phase = (seed % 97) as f64;
    let around = atan2(p.y, p.x);
    let wave = sin(3.0 * around + phase) + 0.7 * sin(7.0 * around + 2.3 * phase) + 0.4 * sin(0.011 * p.x + 0.017 * p.y);
    f64::from(math::lerp(0.3, 1.0, math::smoothstep(-1.6, 1.8, wave as f32)))
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
