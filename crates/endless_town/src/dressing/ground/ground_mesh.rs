//! The mesh of the ground grid, finer where land cover of different kinds meets.

use super::ground_grid::GroundGrid;
use endless_scene::{Material, MeshBuilder};
use glam::{DVec2, DVec3, Vec3};

/// Finer cells along a side of a cell in which ground of different kinds meets.
const FINER: usize = 3;

impl GroundGrid {
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
    pub(super) fn add_border(
        &self,
        mesh: &mut MeshBuilder,
        (x, y): (usize, usize),
        material: &dyn Fn(DVec2) -> Material,
    ) {
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
    pub(super) fn add_cut(
        &self,
        mesh: &mut MeshBuilder,
        corners: [(DVec2, Material); 3],
        kind: &dyn Fn(DVec2) -> Material,
    ) {
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

    pub(super) fn normal(&self, x: usize, y: usize) -> Vec3 {
        let at = |x: usize, y: usize| self.heights[y.min(self.ny - 1) * self.nx + x.min(self.nx - 1)];
        let dx = at(x + 1, y) - at(x.saturating_sub(1), y);
        let dy = at(x, y + 1) - at(x, y.saturating_sub(1));
        DVec3::new(-dx, -dy, 2.0 * self.cell).normalize().as_vec3()
    }

    pub(super) fn normal_near(&self, p: DVec2) -> Vec3 {
        let q = ((p - self.low) / self.cell).round().max(DVec2::ZERO);
        self.normal((q.x as usize).min(self.nx - 1), (q.y as usize).min(self.ny - 1))
    }
}
