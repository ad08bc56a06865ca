//! Coarse quadrilaterals that become smooth skins by subdivision (Catmull and Clark 1978), bone weights and all.

use super::skeleton::BONES;
use super::skin::{Skin, Weights};
use endless_scene::{Material, Mesh};
use glam::{Vec2, Vec3};
use std::collections::BTreeMap;

/// A control mesh of quadrilaterals; edges of one face are borders.
#[derive(Debug, Clone, Default)]
pub(crate) struct Cage {
    pub(crate) points: Vec<Vec3>,
    pub(crate) weights: Vec<Weights>,
    faces: Vec<([u32; 4], Material)>,
}

fn blended(parts: &[(&Weights, f32)]) -> Weights {
    let mut out = [0.0; BONES];
    for (weights, share) in parts {
        for (o, w) in out.iter_mut().zip(*weights) {
            *o += w * share;
        }
    }
    out
}

/// Corners of its own for a triangle that looks away from the normals that it shares: on the inner side of a hem that is turned.
fn creased(mesh: &mut Mesh, weights: &mut Vec<Weights>, triangle: [u32; 3], across: Vec3) -> [u32; 3] {
    triangle.map(|i| {
        let i = i as usize;
        mesh.positions.push(mesh.positions[i]);
        mesh.uvs.push(mesh.uvs[i]);
        mesh.normals.push(across.normalize());
        weights.push(weights[i]);
        (mesh.positions.len() - 1) as u32
    })
}

impl Cage {
    /// Adds a point and returns its number.
    pub(crate) fn point(&mut self, at: Vec3, weights: Weights) -> u32 {
        self.points.push(at);
        self.weights.push(weights);
        (self.points.len() - 1) as u32
    }

    /// A row of points that all follow the same bones or each its own.
    pub(crate) fn row(&mut self, points: &[Vec3], weights: impl Fn(Vec3) -> Weights) -> Vec<u32> {
        points.iter().map(|&p| self.point(p, weights(p))).collect()
    }

    /// A face, counter-clockwise seen from outside unless it is flipped.
    pub(crate) fn quad(&mut self, [a, b, c, d]: [u32; 4], flipped: bool, material: Material) {
        self.faces.push((if flipped { [a, d, c, b] } else { [a, b, c, d] }, material));
    }

    /// A sheet between two rows: seen from outside columns go right and rows go up. `closed` joins the ends.
    pub(crate) fn strip(
        &mut self,
        low: &[u32],
        high: &[u32],
        closed: bool,
        flipped: bool,
        material: impl Fn(usize) -> Material,
    ) {
        let n = low.len();
        for j in 0..if closed { n } else { n - 1 } {
            let k = (j + 1) % n;
            self.quad([low[j], low[k], high[k], high[j]], flipped, material(j));
        }
    }

    /// One step of subdivision.
    pub(crate) fn refined(&self) -> Self {
        let n = self.points.len();
        let mut out = Self { points: self.points.clone(), weights: self.weights.clone(), faces: Vec::new() };
        let mut edges: BTreeMap<(u32, u32), (u32, u32)> = BTreeMap::new();
        let mut face_points = Vec::with_capacity(self.faces.len());
        for (corners, _) in &self.faces {
            let c = corners.map(|i| i as usize);
            let middle = 0.25 * c.iter().map(|&i| self.points[i]).sum::<Vec3>();
            let weights = blended(&c.map(|i| (&self.weights[i], 0.25)));
            face_points.push(out.point(middle, weights));
            for k in 0..4 {
                let (a, b) = (corners[k], corners[(k + 1) % 4]);
                let face = face_points[face_points.len() - 1];
                edges.entry((a.min(b), a.max(b))).and_modify(|e| e.1 = face).or_insert((face, u32::MAX));
            }
        }
        // Of each old point: faces, sum of their points, sum of edges' middles, sum and count of border neighbours.
        let mut around = vec![(0u32, Vec3::ZERO, Vec3::ZERO, Vec3::ZERO, 0u32); n];
        for ((corners, _), &face) in self.faces.iter().zip(&face_points) {
            for &i in corners {
                around[i as usize].0 += 1;
                around[i as usize].1 += out.points[face as usize];
            }
        }
        let mut edge_points = BTreeMap::new();
        for (&(a, b), &(f, g)) in &edges {
            let (p, q) = (self.points[a as usize], self.points[b as usize]);
            let middle = 0.5 * (p + q);
            let border = g == u32::MAX;
            let at =
                if border { middle } else { 0.5 * middle + 0.25 * (out.points[f as usize] + out.points[g as usize]) };
            let weights = blended(&[(&self.weights[a as usize], 0.5), (&self.weights[b as usize], 0.5)]);
            edge_points.insert((a, b), out.point(at, weights));
            for (i, other) in [(a, q), (b, p)] {
                let entry = &mut around[i as usize];
                entry.2 += middle;
                if border {
                    entry.3 += other;
                    entry.4 += 1;
                }
            }
        }
        for (i, &(count, faces, middles, neighbours, borders)) in around.iter().enumerate() {
            let (p, k) = (self.points[i], count as f32);
            out.points[i] = match (borders, count) {
                (0, 3..) => (faces / k + 2.0 * middles / k + (k - 3.0) * p) / k,
                // Corners of a sheet stay.
                (2, 2..) => 0.75 * p + 0.125 * neighbours,
                _ => p,
            };
        }
        for (&(corners, material), &face) in self.faces.iter().zip(&face_points) {
            let edge = |k: usize| {
                let (a, b) = (corners[k % 4], corners[(k + 1) % 4]);
                edge_points[&(a.min(b), a.max(b))]
            };
            for k in 0..4 {
                out.faces.push(([corners[k], edge(k), face, edge(k + 3)], material));
            }
        }
        out
    }

    /// Smooth normals.
    pub(crate) fn normals(&self) -> Vec<Vec3> {
        let mut normals = vec![Vec3::ZERO; self.points.len()];
        for (corners, _) in &self.faces {
            let p = corners.map(|i| self.points[i as usize]);
            let n = (p[2] - p[0]).cross(p[3] - p[1]);
            for &i in corners {
                normals[i as usize] += n;
            }
        }
        normals.iter().map(|n| n.normalize_or(Vec3::Z)).collect()
    }

    /// Puts the faces into a skin, after moving each point along its normal by `bump` metres; `fold` leans normals.
    pub(crate) fn add_to(&self, skin: &mut Skin, bump: impl Fn(Vec3, Vec3) -> f32, fold: impl Fn(Vec3) -> Vec3) {
        let mut moved = self.clone();
        for (p, n) in moved.points.iter_mut().zip(self.normals()) {
            *p += n * bump(*p, n);
        }
        let normals = moved.normals();
        let mut mesh = Mesh {
            uvs: vec![Vec2::ZERO; moved.points.len()],
            normals: moved.points.iter().zip(&normals).map(|(&p, &n)| (n + fold(p)).normalize_or(n)).collect(),
            positions: moved.points,
            ..Mesh::default()
        };
        let mut weights = moved.weights;
        for &([a, b, c, d], material) in &moved.faces {
            let m = mesh.material_index(material);
            let p = |i: u32| mesh.positions[i as usize];
            // The shorter diagonal.
            let halves = if (p(a) - p(c)).length() <= (p(b) - p(d)).length() {
                [[a, b, c], [a, c, d]]
            } else {
                [[b, c, d], [b, d, a]]
            };
            for t in halves {
                let corners = t.map(|i| mesh.positions[i as usize]);
                let across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
                if across.length() > 4e-9 {
                    let shading: Vec3 = t.iter().map(|&i| mesh.normals[i as usize]).sum();
                    let t = if shading.dot(across) < 0.0 { creased(&mut mesh, &mut weights, t, across) } else { t };
                    mesh.triangles.push(t);
                    mesh.triangle_materials.push(m);
                }
            }
        }
        skin.add_mesh(&mesh, |i, _| weights[i]);
    }
}
