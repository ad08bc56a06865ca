//! Holes that a file leaves between the lanes of a junction: paved over.

use crate::dressing::ground::pavement_index::PavementIndex;
use crate::palette::ASPHALT;
use crate::palette::NO_LANE;
use endless_road::{JunctionId, RoadNetwork};
use endless_scene::MeshBuilder;
use glam::{DVec2, DVec3, Vec2};

/// Side of the cells in which holes are looked for, metres.
const CELL_M: f64 = 0.5;
/// Around a junction's lanes, metres.
const AROUND_M: f64 = 16.0;
/// Larger holes are islands or lawns, m².
const MOST_M2: f64 = 110.0;
/// Below the pavements around.
const BELOW_M: f64 = 0.006;

/// A grid over one junction.
struct InfillPatch<'a> {
    pavement: &'a PavementIndex,
    low: DVec2,
    nx: usize,
    ny: usize,
    open: Vec<bool>,
}

/// Outlines that together cover the holes, at the height of the road around.
pub(crate) fn holes(network: &RoadNetwork, pavement: &PavementIndex) -> Vec<[DVec3; 4]> {
    let mut found = Vec::new();
    for junction in 0..network.junctions.len() {
        let id = JunctionId(junction as u16);
        let lanes = network.lanes.iter().filter(|l| l.junction == Some(id));
        let points = lanes.flat_map(|l| l.centerline.points()).map(|p| p.truncate());
        let (low, high) = points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)));
        let size = high - low;
        // What is called a junction of several hundred metres is none to be paved.
        if size.x >= 0.0 && size.max_element() < 250.0 {
            InfillPatch::new(pavement, low - AROUND_M, high + AROUND_M).fill(&mut found);
        }
    }
    found
}

/// Paves what [`holes`] found.
pub(crate) fn pave(mesh: &mut MeshBuilder, holes: &[[DVec3; 4]]) {
    for corners in holes {
        let uvs = corners.map(|p| Vec2::new(p.x as f32, NO_LANE));
        mesh.quad(corners.map(|p| (p - DVec3::Z * BELOW_M).as_vec3()), uvs, ASPHALT);
    }
}

impl<'a> InfillPatch<'a> {
    fn new(pavement: &'a PavementIndex, low: DVec2, high: DVec2) -> Self {
        let size = (high - low) / CELL_M;
        let (nx, ny) = (size.x.ceil() as usize, size.y.ceil() as usize);
        let mut patch = Self { pavement, low, nx, ny, open: Vec::new() };
        patch.open = (0..nx * ny).map(|i| !pavement.is_paved(patch.middle(i))).collect();
        patch
    }

    fn middle(&self, i: usize) -> DVec2 {
        self.low + DVec2::new((i % self.nx) as f64 + 0.5, (i / self.nx) as f64 + 0.5) * CELL_M
    }

    fn neighbours(&self, i: usize) -> impl Iterator<Item = usize> {
        let (x, y) = (i % self.nx, i / self.nx);
        let (nx, ny) = (self.nx, self.ny);
        [(0i64, 1i64), (1, 0), (0, -1), (-1, 0)].into_iter().filter_map(move |(dx, dy)| {
            let (x, y) = (x as i64 + dx, y as i64 + dy);
            let inside = x >= 0 && y >= 0 && x < nx as i64 && y < ny as i64;
            inside.then(|| y as usize * nx + x as usize)
        })
    }

    fn fill(&self, found: &mut Vec<[DVec3; 4]>) {
        let mut seen = vec![false; self.open.len()];
        for start in 0..self.open.len() {
            if seen[start] || !self.open[start] {
                continue;
            }
            let (mut hole, mut next) = (vec![start], 0);
            seen[start] = true;
            while next < hole.len() {
                for i in self.neighbours(hole[next]) {
                    if self.open[i] && !std::mem::replace(&mut seen[i], true) {
                        hole.push(i);
                    }
                }
                next += 1;
            }
            let at_rim = |i: &usize| {
                let (x, y) = (i % self.nx, i / self.nx);
                x == 0 || y == 0 || x + 1 == self.nx || y + 1 == self.ny
            };
            let small = hole.len() as f64 * CELL_M * CELL_M < MOST_M2;
            if small && !hole.iter().any(at_rim) && self.is_in_the_road(&hole) {
                self.outlines(hole, found);
            }
        }
    }

    /// Whether at least a quarter of a hole's border is carriageway.
    fn is_in_the_road(&self, hole: &[usize]) -> bool {
        let border: Vec<usize> = hole.iter().flat_map(|&i| self.neighbours(i)).filter(|&i| !self.open[i]).collect();
        let road = border.iter().filter(|&&i| self.pavement.is_carriageway(self.middle(i))).count();
        road * 4 >= border.len()
    }

    /// The hole and a cell beyond it.
    fn outlines(&self, mut hole: Vec<usize>, found: &mut Vec<[DVec3; 4]>) {
        let rim: Vec<usize> =
            hole.iter().flat_map(|&i| self.neighbours(i)).flat_map(|i| self.neighbours(i).chain([i])).collect();
        hole.extend(rim);
        hole.sort_unstable();
        hole.dedup();
        // Runs of cells along x become one quad.
        let mut from = 0;
        while from < hole.len() {
            let mut to = from + 1;
            while to < hole.len() && hole[to] == hole[to - 1] + 1 && to - from < 6 && !hole[to].is_multiple_of(self.nx)
            {
                to += 1;
            }
            let (a, b) = (self.middle(hole[from]) - CELL_M / 2.0, self.middle(hole[to - 1]) + CELL_M / 2.0);
            let corners = [a, DVec2::new(b.x, a.y), b, DVec2::new(a.x, b.y)];
            found.extend(self.on_road(corners));
            from = to;
        }
    }

    /// The corners at the height of the road next to each.
    fn on_road(&self, corners: [DVec2; 4]) -> Option<[DVec3; 4]> {
        let height = |p: DVec2| {
            (0..14).find_map(|ring| {
                let around = (0..8).filter_map(|k| {
                    let q =
                        p + crate::geometry::unit(std::f64::consts::FRAC_PI_4 * f64::from(k)) * (0.5 * f64::from(ring));
                    self.pavement
                        .at(q)
                        .filter(|(piece, _)| crate::dressing::ground::pavement_index::is_carriageway(piece.kind))
                        .map(|(_, z)| z)
                        .min_by(f64::total_cmp)
                });
                around.min_by(f64::total_cmp)
            })
        };
        let mut found = [DVec3::ZERO; 4];
        for (to, p) in found.iter_mut().zip(corners) {
            *to = p.extend(height(p)?);
        }
        Some(found)
    }
}
