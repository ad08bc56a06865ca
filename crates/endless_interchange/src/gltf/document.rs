//! Builds a glTF document: meshes, nodes, and the file of both (specification 2.0, sections 3 and 4).

use super::{buffer::GltfBuffer, material::MaterialTable};
use endless_asset::Catalogue;
use endless_scene::{Material, Mesh};
use glam::{Affine3A, Quat, Vec3};
use gltf::{
    Semantic,
    binary::{Glb, Header},
    json::{
        self, Accessor, Asset, Index, Node, Root,
        mesh::{Mode, Primitive},
        scene::UnitQuaternion,
        validation::Checked::{self, Valid},
    },
};
use std::collections::BTreeMap;

/// More than a `.glb` can hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct TooLarge;

/// A file in the making.
pub(super) struct GltfDocument<'a> {
    pub(super) catalogue: &'a Catalogue,
    pub(super) root: Root,
    buffer: GltfBuffer,
    materials: MaterialTable,
}

/// A mesh's accessors.
pub(super) struct MeshAccessors {
    vertices: BTreeMap<Checked<Semantic>, Index<Accessor>>,
    /// The triangles of each material.
    triangles: Vec<(Material, Index<Accessor>)>,
}

/// From z up to y up.
pub(super) fn y_up(v: Vec3) -> Vec3 {
    Vec3::new(v.x, v.z, -v.y)
}

/// A node with a name and a transform. Towns place objects with scales and rotations only.
pub(super) fn node_at(name: &str, world_from_object: Affine3A) -> Node {
    let (scale, turn, at) = world_from_object.to_scale_rotation_translation();
    let axis = y_up(Vec3::new(turn.x, turn.y, turn.z));
    let turn = Quat::from_xyzw(axis.x, axis.y, axis.z, turn.w).normalize();
    Node {
        name: Some(name.to_owned()),
        translation: Some(y_up(at).to_array()),
        rotation: Some(UnitQuaternion(turn.to_array())),
        scale: Some([scale.x, scale.z, scale.y]),
        ..Node::default()
    }
}

impl<'a> GltfDocument<'a> {
    /// Empty.
    pub(super) fn new(catalogue: &'a Catalogue) -> Self {
        let generator = Some(concat!("endless ", env!("CARGO_PKG_VERSION")).to_owned());
        let root = Root { asset: Asset { generator, ..Asset::default() }, ..Root::default() };
        Self { catalogue, root, buffer: GltfBuffer::default(), materials: MaterialTable::default() }
    }

    /// A mesh's vertices and triangles; `None` if it has none.
    pub(super) fn accessors(&mut self, mesh: &Mesh) -> Option<MeshAccessors> {
        let mut of_material = vec![Vec::new(); mesh.materials.len()];
        for (triangle, &m) in mesh.triangles.iter().zip(&mesh.triangle_materials) {
            of_material[usize::from(m)].extend_from_slice(triangle);
        }
        if mesh.triangles.is_empty() {
            return None;
        }
        let Self { buffer, root, .. } = self;
        let upright = |n: Vec3| y_up(n.try_normalize().unwrap_or(Vec3::Z)).to_array();
        let vertices = BTreeMap::from([
            (Valid(Semantic::Positions), buffer.vectors(root, mesh.positions.iter().map(|&p| y_up(p).to_array()))),
            (Valid(Semantic::Normals), buffer.vectors(root, mesh.normals.iter().map(|&n| upright(n)))),
        ]);
        let filled = mesh.materials.iter().zip(of_material).filter(|(_, indices)| !indices.is_empty());
        let triangles = filled.map(|(&material, indices)| (material, buffer.indices(root, &indices))).collect();
        Some(MeshAccessors { vertices, triangles })
    }

    /// A mesh of these accessors, its paint in a vehicle's colour.
    pub(super) fn mesh(&mut self, name: &str, of: &MeshAccessors, tint: Option<[f32; 3]>) -> Index<json::Mesh> {
        let primitive = |&(material, indices): &(Material, Index<Accessor>)| Primitive {
            attributes: of.vertices.clone(),
            indices: Some(indices),
            material: Some(self.materials.index(material, tint)),
            mode: Valid(Mode::Triangles),
            targets: None,
            extensions: None,
            extras: None,
        };
        let primitives = of.triangles.iter().map(primitive).collect();
        let name = Some(name.to_owned());
        self.root.push(json::Mesh { name, primitives, weights: None, extensions: None, extras: None })
    }

    /// A mesh at a place.
    pub(super) fn instance(&mut self, name: &str, mesh: Index<json::Mesh>, world_from_object: Affine3A) -> Index<Node> {
        self.root.push(Node { mesh: Some(mesh), ..node_at(name, world_from_object) })
    }

    /// One mesh at the origin.
    pub(super) fn single(&mut self, name: &str, mesh: &Mesh) -> Option<Index<Node>> {
        let accessors = self.accessors(mesh)?;
        let mesh = self.mesh(name, &accessors, None);
        Some(self.instance(name, mesh, Affine3A::IDENTITY))
    }

    /// A node over others; `None` over none.
    pub(super) fn group(&mut self, name: &str, children: Vec<Index<Node>>) -> Option<Index<Node>> {
        let node = |children| Node { name: Some(name.to_owned()), children: Some(children), ..Node::default() };
        (!children.is_empty()).then(|| self.root.push(node(children)))
    }

    /// The file of what was added, with these nodes at the top.
    ///
    /// # Errors
    /// [`TooLarge`] if it would have more than 4 GiB.
    pub(super) fn finish(self, name: &str, nodes: Vec<Index<Node>>) -> Result<Vec<u8>, TooLarge> {
        let Self { mut root, buffer, materials, .. } = self;
        let scene = json::Scene { name: Some(name.to_owned()), nodes, extensions: None, extras: None };
        root.scene = Some(root.push(scene));
        root.materials = materials.described();
        let bin = buffer.finish(&mut root);
        let text = json::serialize::to_vec(&root).expect("plain numbers and words");
        // Two heads, three lengths, and what aligns the two parts.
        if u32::try_from(text.len() + bin.len() + 64).is_err() {
            return Err(TooLarge);
        }
        let header = Header { magic: *b"glTF", version: 2, length: 0 };
        let file = Glb { header, json: text.into(), bin: Some(bin.into()) };
        Ok(file.to_vec().expect("memory takes what is written"))
    }
}
