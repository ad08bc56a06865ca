//! Triangle meshes and a builder for them.

use crate::Material;
use endless_world::math::UnfusedMatrix;
use glam::{Affine3A, Vec2, Vec3};

/// An indexed triangle mesh with smooth normals and a material per triangle.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Object frame, metres.
    pub positions: Vec<Vec3>,
    /// Unit shading normals, one a vertex.
    pub normals: Vec<Vec3>,
    /// Surface coordinates, one a vertex; see [`crate::Surface`] for what they mean.
    pub uvs: Vec<Vec2>,
    /// Vertex indices, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Index into `materials`, one a triangle.
    pub triangle_materials: Vec<u16>,
    /// Material table.
    pub materials: Vec<Material>,
}

impl Mesh {
    /// Smallest and largest corner; zero for an empty mesh.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        let Some(&first) = self.positions.first() else { return (Vec3::ZERO, Vec3::ZERO) };
        self.positions.iter().fold((first, first), |(low, high), &p| (low.min(p), high.max(p)))
    }

    /// Index of a material, added if it is new.
    pub fn material_index(&mut self, material: Material) -> u16 {
        let index = self.materials.iter().position(|&m| m == material).unwrap_or_else(|| {
            self.materials.push(material);
            self.materials.len() - 1
        });
        u16::try_from(index).expect("fewer than 65536 materials in a mesh")
    }

    /// Appends another mesh, transformed.
    pub fn append(&mut self, other: &Self, self_from_other: Affine3A) {
        let base = u32::try_from(self.positions.len()).expect("fewer than 2^32 vertices");
        let normal_matrix = self_from_other.matrix3.inverse_unfused().transpose();
        let flips = self_from_other.matrix3.determinant_unfused() < 0.0;
        self.positions.extend(other.positions.iter().map(|&p| self_from_other.transform_point3(p)));
        self.normals.extend(other.normals.iter().map(|&n| (normal_matrix * n).normalize_or_zero()));
        self.uvs.extend_from_slice(&other.uvs);
        let map: Vec<u16> = other.materials.iter().map(|&m| self.material_index(m)).collect();
        for (&[a, b, c], &m) in other.triangles.iter().zip(&other.triangle_materials) {
            let triangle = if flips { [a, c, b] } else { [a, b, c] };
            self.triangles.push(triangle.map(|i| i + base));
            self.triangle_materials.push(map[usize::from(m)]);
        }
    }
}

/// Builds meshes face by face. Faces made by one call share vertices only within that call, so edges between calls are
/// sharp.
#[derive(Debug, Clone, Default)]
pub struct MeshBuilder {
    mesh: Mesh,
}

impl MeshBuilder {
    /// Empty.
    pub fn new() -> Self {
        Self::default()
    }

    /// The finished mesh.
    pub fn finish(self) -> Mesh {
        self.mesh
    }

    /// A flat quadrilateral, corners counter-clockwise seen from outside.
    pub fn quad(&mut self, corners: [Vec3; 4], uvs: [Vec2; 4], material: Material) {
        let normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]).normalize_or(Vec3::Z);
        let base = self.vertices(corners.iter().zip(&uvs).map(|(&p, &uv)| (p, normal, uv)));
        self.triangle_indices([base, base + 1, base + 2], material);
        self.triangle_indices([base, base + 2, base + 3], material);
    }

    /// A flat triangle, corners counter-clockwise seen from outside.
    pub fn triangle(&mut self, corners: [Vec3; 3], uvs: [Vec2; 3], material: Material) {
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or(Vec3::Z);
        let base = self.vertices(corners.iter().zip(&uvs).map(|(&p, &uv)| (p, normal, uv)));
        self.triangle_indices([base, base + 1, base + 2], material);
    }

    /// An axis-aligned box; uv in metres along each face.
    pub fn cuboid(&mut self, low: Vec3, high: Vec3, material: Material) {
        let c = |x: u8, y: u8, z: u8| {
            Vec3::new(
                if x == 0 { low.x } else { high.x },
                if y == 0 { low.y } else { high.y },
                if z == 0 { low.z } else { high.z },
            )
        };
        let d = high - low;
        let faces = [
            ([c(0, 0, 0), c(1, 0, 0), c(1, 0, 1), c(0, 0, 1)], d.x, d.z),
            ([c(1, 0, 0), c(1, 1, 0), c(1, 1, 1), c(1, 0, 1)], d.y, d.z),
            ([c(1, 1, 0), c(0, 1, 0), c(0, 1, 1), c(1, 1, 1)], d.x, d.z),
            ([c(0, 1, 0), c(0, 0, 0), c(0, 0, 1), c(0, 1, 1)], d.y, d.z),
            ([c(0, 0, 1), c(1, 0, 1), c(1, 1, 1), c(0, 1, 1)], d.x, d.y),
            ([c(0, 1, 0), c(1, 1, 0), c(1, 0, 0), c(0, 0, 0)], d.x, d.y),
        ];
        for (corners, u, v) in faces {
            self.quad(corners, [Vec2::ZERO, Vec2::new(u, 0.0), Vec2::new(u, v), Vec2::new(0.0, v)], material);
        }
    }

    /// Adds vertices (position, unit normal, uv) and returns the index of the first.
    pub fn vertices(&mut self, vertices: impl IntoIterator<Item = (Vec3, Vec3, Vec2)>) -> u32 {
        let base = u32::try_from(self.mesh.positions.len()).expect("fewer than 2^32 vertices");
        for (position, normal, uv) in vertices {
            self.mesh.positions.push(position);
            self.mesh.normals.push(normal);
            self.mesh.uvs.push(uv);
        }
        base
    }

    /// A triangle over vertices added before, counter-clockwise seen from outside.
    pub fn triangle_indices(&mut self, indices: [u32; 3], material: Material) {
        let m = self.mesh.material_index(material);
        self.mesh.triangles.push(indices);
        self.mesh.triangle_materials.push(m);
    }

    /// Appends a mesh, transformed.
    pub fn mesh(&mut self, mesh: &Mesh, self_from_mesh: Affine3A) {
        self.mesh.append(mesh, self_from_mesh);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Surface;
    use endless_world::ClassTag;

    #[test]
    fn a_box_is_closed_and_faces_outwards() {
        let mut b = MeshBuilder::new();
        b.cuboid(
            Vec3::new(-1.0, -2.0, 0.0),
            Vec3::new(1.0, 2.0, 3.0),
            Material::new(Surface::Metal, [0.5; 3], ClassTag::Static),
        );
        let m = b.finish();
        assert_eq!(m.bounds(), (Vec3::new(-1.0, -2.0, 0.0), Vec3::new(1.0, 2.0, 3.0)));
        // Signed volume by the divergence theorem.
        let volume: f32 = m
            .triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|i| m.positions[i as usize]);
                a.dot(b.cross(c)) / 6.0
            })
            .sum();
        assert!((volume - 24.0).abs() < 1e-4);
    }
}
