//! A file's scene as triangles in our frame: x ahead, y left, z up.

use super::container::GlbFile;
use super::source_material::{self, SourceMaterial};
use super::{ForwardAxis, ImportError, accessor};
use endless_world::math::UnfusedMatrix;
use glam::{Affine3A, Mat3, Mat4, Vec2, Vec3};
use gltf::Semantic;
use gltf::mesh::Mode;

/// Most triangles of a model, instances counted.
pub(super) const MOST_TRIANGLES: usize = 2_000_000;
/// Nodes this deep are a mistake.
const DEEPEST: usize = 64;
/// Most nodes, each counted as often as it stands below others.
const MOST_NODES: usize = 200_000;
/// Places beyond this are no places, in units of the file.
const FARTHEST: f32 = 1e5;

/// A scene.
#[derive(Debug)]
pub(super) struct SourceModel {
    pub(super) materials: Vec<SourceMaterial>,
    pub(super) parts: Vec<SourcePart>,
}

/// The triangles of one primitive of one node.
#[derive(Debug, Default)]
pub(super) struct SourcePart {
    /// Names of the node and those above it, outermost first, each with its number.
    pub(super) path: Vec<(usize, String)>,
    pub(super) positions: Vec<Vec3>,
    /// Unit; as long as the positions.
    pub(super) normals: Vec<Vec3>,
    pub(super) uvs: Vec<Vec2>,
    /// Linear; as long as the positions.
    pub(super) colors: Vec<Vec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// Index into the materials.
    pub(super) material_index: usize,
}

impl SourceModel {
    /// Smallest and largest corner of what triangles use.
    pub(super) fn bounds(&self) -> (Vec3, Vec3) {
        let used = self.parts.iter().flat_map(|p| p.triangles.iter().flatten().map(|&i| p.positions[i as usize]));
        used.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)))
    }

    /// Scales it and moves it.
    pub(super) fn place(&mut self, scale: f32, by: Vec3) {
        for p in self.parts.iter_mut().flat_map(|part| &mut part.positions) {
            *p = *p * scale + by;
        }
    }
}

/// From a file's axes to ours.
fn object_from_file(forward: ForwardAxis) -> Mat3 {
    // glTF: x to the left, y up, z ahead.
    let [ahead, left] = match forward {
        ForwardAxis::PlusZ => [Vec3::Z, Vec3::X],
        ForwardAxis::MinusZ => [-Vec3::Z, -Vec3::X],
        ForwardAxis::PlusX => [Vec3::X, -Vec3::Z],
        ForwardAxis::MinusX => [-Vec3::X, Vec3::Z],
    };
    Mat3::from_cols(ahead, left, Vec3::Y).transpose()
}

/// Reads the default scene.
///
/// # Errors
/// When it is damaged, too large or empty.
pub(super) fn read(opened: &GlbFile<'_>, forward: ForwardAxis) -> Result<SourceModel, ImportError> {
    let mut reader = Reader {
        opened,
        model: SourceModel { materials: source_material::all(opened)?, parts: vec![] },
        triangles: 0,
        nodes: 0,
    };
    let document = &opened.document;
    let root = Affine3A::from_mat3(object_from_file(forward));
    let mut path = Vec::new();
    match document.default_scene().or_else(|| document.scenes().next()) {
        Some(scene) => scene.nodes().try_for_each(|node| reader.node(&node, root, &mut path))?,
        None => return Err(ImportError::Empty),
    }
    if reader.triangles == 0 { Err(ImportError::Empty) } else { Ok(reader.model) }
}

struct Reader<'a> {
    opened: &'a GlbFile<'a>,
    model: SourceModel,
    triangles: usize,
    nodes: usize,
}

impl Reader<'_> {
    fn node(
        &mut self,
        node: &gltf::Node<'_>,
        object_from_parent: Affine3A,
        path: &mut Vec<(usize, String)>,
    ) -> Result<(), ImportError> {
        if path.len() >= DEEPEST || path.iter().any(|p| p.0 == node.index()) {
            return Err(ImportError::Damaged { what: format!("node {} lies within itself", node.index()) });
        }
        self.nodes += 1;
        if self.nodes > MOST_NODES {
            return Err(ImportError::Damaged { what: format!("it has more than {MOST_NODES} nodes") });
        }
        let own = Affine3A::from_mat4(Mat4::from_cols_array_2d(&node.transform().matrix()));
        let object_from_node = object_from_parent * own;
        if !object_from_node.is_finite() {
            return Err(ImportError::Damaged { what: format!("the place of node {} is not a number", node.index()) });
        }
        path.push((node.index(), node.name().unwrap_or_default().to_owned()));
        if let Some(mesh) = node.mesh() {
            let name = mesh.name().map_or_else(|| mesh.index().to_string(), str::to_owned);
            for primitive in mesh.primitives() {
                self.primitive(&primitive, object_from_node, path, &name)?;
            }
        }
        for child in node.children() {
            self.node(&child, object_from_node, path)?;
        }
        path.pop();
        Ok(())
    }

    fn primitive(
        &mut self,
        primitive: &gltf::Primitive<'_>,
        object_from_node: Affine3A,
        path: &[(usize, String)],
        mesh: &str,
    ) -> Result<(), ImportError> {
        let Some(accessor) = primitive.get(&Semantic::Positions) else { return Ok(()) };
        let count = accessor.count();
        let given: Vec<[f32; 3]> = accessor::vectors(self.opened, &accessor)?;
        let positions: Vec<Vec3> =
            given.iter().map(|&p| object_from_node.transform_point3(Vec3::from_array(p))).collect();
        let nowhere = |p: &Vec3| !p.is_finite() || p.abs().max_element() > FARTHEST;
        if let Some(vertex) = positions.iter().position(nowhere) {
            return Err(ImportError::NotFinite { mesh: mesh.chars().take(60).collect(), vertex });
        }
        let mut corners: Vec<u32> = match primitive.indices() {
            Some(indices) => accessor::indices(self.opened, &indices)?,
            None => (0..u32::try_from(count).unwrap_or(u32::MAX)).collect(),
        };
        if corners.iter().any(|&i| i as usize >= count) {
            return Err(ImportError::Damaged { what: format!("mesh '{mesh}' has indices beyond its vertices") });
        }
        if object_from_node.matrix3.determinant_unfused() < 0.0 && primitive.mode() == Mode::Triangles {
            corners.chunks_exact_mut(3).for_each(|t| t.swap(1, 2));
        }
        let triangles = joined(primitive.mode(), &corners, &positions);
        self.triangles += triangles.len();
        if self.triangles > MOST_TRIANGLES {
            return Err(ImportError::TooMany { most: MOST_TRIANGLES });
        }
        if triangles.is_empty() {
            return Ok(());
        }
        let material_index = primitive.material().index().unwrap_or(self.model.materials.len() - 1);
        let set = self.model.materials[material_index].texture.as_ref().map_or(0, |texture| texture.set);
        let normals = self.normals(primitive, object_from_node, &positions, &triangles)?;
        let uvs = match primitive.get(&Semantic::TexCoords(set)) {
            Some(accessor) => accessor::vectors(self.opened, &accessor)?.into_iter().map(finite).collect(),
            None => vec![],
        };
        let colors = match primitive.get(&Semantic::Colors(0)) {
            Some(accessor) => accessor::vectors::<3>(self.opened, &accessor)?.into_iter().map(tint).collect(),
            None => vec![],
        };
        let mut part = SourcePart { path: path.to_vec(), positions, normals, uvs, colors, triangles, material_index };
        part.uvs.resize(count, Vec2::ZERO);
        part.colors.resize(count, Vec3::ONE);
        self.model.parts.push(part);
        Ok(())
    }

    /// The file's normals; where there are none, those of the faces around a vertex.
    fn normals(
        &self,
        primitive: &gltf::Primitive<'_>,
        object_from_node: Affine3A,
        positions: &[Vec3],
        triangles: &[[u32; 3]],
    ) -> Result<Vec<Vec3>, ImportError> {
        let mut around = vec![Vec3::ZERO; positions.len()];
        for t in triangles {
            let [a, b, c] = t.map(|i| positions[i as usize]);
            let area = (b - a).cross(c - a);
            t.iter().for_each(|&i| around[i as usize] += area);
        }
        let mut normals: Vec<Vec3> = around.into_iter().map(|n| n.normalize_or(Vec3::Z)).collect();
        if let Some(accessor) = primitive.get(&Semantic::Normals) {
            let turn = object_from_node.matrix3.inverse_unfused().transpose();
            let given = accessor::vectors::<3>(self.opened, &accessor)?;
            for (normal, given) in normals.iter_mut().zip(given) {
                let turned = Vec3::from(turn * glam::Vec3A::from_array(given));
                *normal = turned.try_normalize().unwrap_or(*normal);
            }
        }
        Ok(normals)
    }
}

fn finite(uv: [f32; 2]) -> Vec2 {
    let uv = Vec2::from_array(uv);
    if uv.is_finite() { uv } else { Vec2::ZERO }
}

fn tint(color: [f32; 3]) -> Vec3 {
    Vec3::from_array(color.map(|c| if c.is_finite() { c.clamp(0.0, 1.0) } else { 1.0 }))
}

/// Triangles of a primitive, without those that have no area.
fn joined(mode: Mode, corners: &[u32], positions: &[Vec3]) -> Vec<[u32; 3]> {
    let all: Vec<[u32; 3]> = match mode {
        Mode::Triangles => corners.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect(),
        Mode::TriangleStrip => {
            let of = |(k, c): (usize, &[u32])| if k % 2 == 0 { [c[0], c[1], c[2]] } else { [c[1], c[0], c[2]] };
            corners.windows(3).enumerate().map(of).collect()
        }
        Mode::TriangleFan => {
            let rim = corners.get(1..).unwrap_or_default();
            rim.windows(2).map(|c| [corners[0], c[0], c[1]]).collect()
        }
        _ => vec![],
    };
    let solid = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| positions[i as usize]);
        (b - a).cross(c - a).length_squared() > 0.0
    };
    all.into_iter().filter(solid).collect()
}
