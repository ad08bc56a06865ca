//! A soup of triangles under construction.

use super::face::Face;
use super::runs::Runs;
use super::weld::{WeldCell, interner};
use endless_scene::{Material, Mesh};
use endless_world::math::UnfusedMatrix;
use glam::{Affine3A, Vec2, Vec3};

/// Triangles with a normal a corner. Parts are made one by one, smoothed, painted by [`crate::shape::Region`]s, and put
/// together.
#[derive(Debug, Clone, Default)]
pub(crate) struct Sculpt {
    pub(super) faces: Vec<Face>,
    pub(super) runs: Runs,
}

/// Below twice this area (m²) a triangle is dropped: nobody could see it, and its normal would be noise.
const DEGENERATE_AREA: f32 = 2e-8;

/// Positions nearer than about this count as one, metres.
const WELD_M: f32 = 5e-5;

fn key(p: Vec3) -> WeldCell {
    cell(p / WELD_M)
}

/// The nearest point of the unit grid.
fn cell(p: Vec3) -> WeldCell {
    WeldCell(p.to_array().map(|c| (c + 0.5f32.copysign(c)) as i32))
}

impl Sculpt {
    pub(crate) fn new() -> Self {
        Self::default()
    }

    /// All of them.
    pub(crate) fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// The same, to be moved or turned.
    pub(crate) fn faces_mut(&mut self) -> &mut [Face] {
        self.runs.forget();
        &mut self.faces
    }

    /// A flat triangle.
    pub(crate) fn triangle(&mut self, corners: [Vec3; 3], material: Material) {
        let face = Face { corners, normals: [Vec3::Z; 3], material };
        let n = face.area_normal();
        if n.length() > 2.0 * DEGENERATE_AREA {
            self.faces.push(Face { normals: [n.normalize_or(Vec3::Z); 3], ..face });
        }
    }

    /// A flat quadrilateral.
    pub(crate) fn quad(&mut self, [a, b, c, d]: [Vec3; 4], material: Material) {
        self.triangle([a, b, c], material);
        self.triangle([a, c, d], material);
    }

    /// A sheet over rows of equally many points. Seen from outside, columns go right and rows go up. `closed` joins the
    /// last column to the first.
    pub(crate) fn grid(&mut self, rows: &[Vec<Vec3>], closed: bool, material: Material) {
        for pair in rows.windows(2) {
            let n = pair[0].len();
            for j in 0..if closed { n } else { n - 1 } {
                let k = (j + 1) % n;
                self.quad([pair[0][j], pair[0][k], pair[1][k], pair[1][j]], material);
            }
        }
    }

    /// A fan over a closed, roughly flat polygon.
    pub(crate) fn polygon(&mut self, points: &[Vec3], material: Material) {
        let centre = points.iter().copied().sum::<Vec3>() / points.len() as f32;
        for (i, &p) in points.iter().enumerate() {
            self.triangle([centre, p, points[(i + 1) % points.len()]], material);
        }
    }

    /// Normals averaged over neighbours that meet at less than this angle.
    pub(crate) fn smooth(mut self, crease_deg: f32) -> Self {
        let limit = endless_world::math::cos(crease_deg.to_radians());
        let flat: Vec<Vec3> = self.faces.iter().map(|f| f.area_normal().normalize_or(Vec3::Z)).collect();
        // Places, those of corners, and corners by place: the first of each, and the next one of the same place.
        let mut places = interner(self.faces.len());
        let mut place_of = vec![0; self.faces.len() * 3];
        let mut first = Vec::with_capacity(self.faces.len());
        let mut next = vec![u32::MAX; self.faces.len() * 3];
        let mut angles = vec![0.0f32; self.faces.len() * 3];
        for (i, face) in self.faces.iter().enumerate().rev() {
            for k in (0..3).rev() {
                let [p, q, r] = [0, 1, 2].map(|j| face.corners[(k + j) % 3]);
                let cosine = (q - p).normalize_or_zero().dot((r - p).normalize_or_zero());
                let at = 3 * i + k;
                angles[at] = endless_world::math::acos(cosine.clamp(-1.0, 1.0));
                let (place, _) = places.insert_full(key(p));
                place_of[at] = place as u32;
                match first.get_mut(place) {
                    Some(first) => next[at] = std::mem::replace(first, at as u32),
                    None => first.push(at as u32),
                }
            }
        }
        for (i, face) in self.faces.iter_mut().enumerate() {
            for k in 0..3 {
                let mut sum = Vec3::ZERO;
                let mut at = first[place_of[3 * i + k] as usize] as usize;
                loop {
                    if flat[at / 3].dot(flat[i]) > limit {
                        sum += flat[at / 3] * angles[at];
                    }
                    if next[at] == u32::MAX {
                        break;
                    }
                    at = next[at] as usize;
                }
                face.normals[k] = sum.normalize_or(flat[i]);
            }
        }
        self
    }

    /// Puts another part beside this one.
    pub(crate) fn add(&mut self, other: Self) {
        self.faces.extend(other.faces);
    }

    /// The same, moved.
    pub(crate) fn placed(mut self, transform: Affine3A) -> Self {
        let normal_matrix = transform.matrix3.inverse_unfused().transpose();
        let flips = transform.matrix3.determinant_unfused() < 0.0;
        for face in self.faces_mut() {
            face.corners = face.corners.map(|p| transform.transform_point3(p));
            face.normals = face.normals.map(|n| (normal_matrix * n).normalize_or(Vec3::Z));
            if flips {
                face.corners.swap(1, 2);
                face.normals.swap(1, 2);
            }
        }
        self
    }

    /// The same, moved by a vector.
    pub(crate) fn at(self, offset: Vec3) -> Self {
        self.placed(Affine3A::from_translation(offset))
    }

    /// The mirror image, left for right.
    pub(crate) fn mirrored(&self) -> Self {
        self.clone().placed(Affine3A::from_scale(Vec3::new(1.0, -1.0, 1.0)))
    }

    /// This and its mirror image.
    pub(crate) fn both_sides(mut self) -> Self {
        let other = self.mirrored();
        self.add(other);
        self
    }

    /// Smallest and largest corner.
    pub(crate) fn bounds(&self) -> (Vec3, Vec3) {
        let corners = || self.faces.iter().flat_map(|f| f.corners);
        (corners().fold(Vec3::INFINITY, Vec3::min), corners().fold(Vec3::NEG_INFINITY, Vec3::max))
    }

    /// The finished mesh; corners alike in place and normal become one vertex. uv: metres along the face, v upward.
    pub(crate) fn into_mesh(self) -> Mesh {
        self.welded(true)
    }

    /// The same with fewer vertices: uv is that of whichever face came first, for surfaces that do not use it.
    pub(crate) fn into_mesh_without_seams(self) -> Mesh {
        self.welded(false)
    }

    fn welded(self, seams: bool) -> Mesh {
        let mut mesh = Mesh::default();
        let mut vertices = interner(self.faces.len());
        for face in &self.faces {
            let flat = face.area_normal();
            let size = flat.abs();
            let axis = if size.z >= size.x && size.z >= size.y { 2 } else { u8::from(size.y > size.x) };
            let mut indices = [0; 3];
            for k in 0..3 {
                let (p, n) = (face.corners[k], face.normals[k]);
                let normal_key = cell(n * 4096.0);
                let (vertex, is_new) = vertices.insert_full((key(p), normal_key, if seams { axis } else { 0 }));
                indices[k] = vertex as u32;
                if is_new {
                    mesh.positions.push(p);
                    mesh.normals.push(n);
                    mesh.uvs.push(match axis {
                        0 => Vec2::new(p.y, p.z),
                        1 => Vec2::new(p.x, p.z),
                        _ => Vec2::new(p.x, p.y),
                    });
                }
            }
            if indices[0] == indices[1] || indices[1] == indices[2] || indices[2] == indices[0] {
                continue;
            }
            let material = mesh.material_index(face.material);
            mesh.triangles.push(indices);
            mesh.triangle_materials.push(material);
        }
        mesh
    }
}
