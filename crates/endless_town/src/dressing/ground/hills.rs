//! Hills around a town, beyond its ground grid.

use super::ground_grid::GroundGrid;
use crate::palette::{HILL, LAWN, MEADOW};
use endless_scene::MeshBuilder;
use endless_world::math;
use endless_world::math::f64::{atan2, sin};
use glam::{DVec2, DVec3, Vec3};

impl GroundGrid {
    /// The grid's border, counter-clockwise.
    pub(super) fn border(&self) -> Vec<(usize, usize)> {
        let (x, y) = (self.nx - 1, self.ny - 1);
        let south = (0..x).map(|i| (i, 0));
        let east = (0..y).map(|i| (x, i));
        let north = (0..x).map(|i| (x - i, y));
        let west = (0..y).map(|i| (0, y - i));
        south.chain(east).chain(north).chain(west).collect()
    }

    /// The vertex of a ring of hills beyond vertex `k` of the border.
    pub(super) fn ring_point(&self, border: &[(usize, usize)], seed: u64, ring: usize, k: usize) -> DVec3 {
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

    pub(super) fn add_hills(&self, mesh: &mut MeshBuilder, seed: u64) {
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
