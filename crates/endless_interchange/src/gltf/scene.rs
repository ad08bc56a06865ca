//! Meshes and nodes: what stands where.

use super::binary::{Binary, TooLarge};
use super::material::Materials;
use endless_asset::{Catalogue, Prop, Trailer, VehicleModel, Wheel};
use endless_scene::Mesh;
use endless_town::{Town, What};
use endless_world::{ImageSize, PinholeCamera, VehicleModelId, math};
use glam::{Affine3A, Mat3, Quat, Vec3};
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// A file in the making.
pub(super) struct Scene<'a> {
    catalogue: &'a Catalogue,
    binary: Binary,
    materials: Materials,
    meshes: Vec<Value>,
    nodes: Vec<Value>,
}

/// A mesh's accessors: vertices, and the triangles of each material.
struct Geometry {
    attributes: Value,
    parts: Vec<(endless_scene::Material, usize)>,
}

/// From z up to y up.
fn y_up(v: Vec3) -> Vec3 {
    Vec3::new(v.x, v.z, -v.y)
}

/// A node's place. Towns place things with scales and turns only.
fn placed(world_from_object: Affine3A) -> Value {
    let (scale, turn, at) = world_from_object.to_scale_rotation_translation();
    let axis = y_up(Vec3::new(turn.x, turn.y, turn.z));
    let turn = Quat::from_xyzw(axis.x, axis.y, axis.z, turn.w).normalize();
    json!({
        "translation": y_up(at).to_array(),
        "rotation": turn.to_array(),
        "scale": [scale.x, scale.z, scale.y],
    })
}

impl<'a> Scene<'a> {
    /// Empty.
    pub(super) fn new(catalogue: &'a Catalogue) -> Self {
        Self { catalogue, binary: Binary::default(), materials: Materials::default(), meshes: vec![], nodes: vec![] }
    }

    /// The file of what was added, with these nodes at the top.
    ///
    /// # Errors
    /// [`TooLarge`] if it would have more than 4 GiB.
    pub(super) fn document(self, name: &str, roots: &[usize], cameras: &[Value]) -> Result<Vec<u8>, TooLarge> {
        let mut document = json!({
            "asset": { "version": "2.0", "generator": concat!("endless ", env!("CARGO_PKG_VERSION")) },
            "scene": 0,
            "scenes": [{ "name": name, "nodes": roots }],
            "nodes": self.nodes,
            "meshes": self.meshes,
            "materials": self.materials.described(),
        });
        if !cameras.is_empty() {
            document["cameras"] = json!(cameras);
        }
        self.binary.container(document)
    }

    /// One mesh at the origin.
    pub(super) fn single(&mut self, name: &str, mesh: &Mesh) -> Option<usize> {
        let geometry = self.geometry(mesh)?;
        let mesh = self.mesh(name, &geometry, None);
        Some(self.instance(name, mesh, Affine3A::IDENTITY))
    }

    /// One vehicle at the origin, in the paint of a variant, with its rider if it has one.
    pub(super) fn single_vehicle(&mut self, model: &VehicleModel, variant: u64) -> Option<usize> {
        let name = model.name();
        let tint = Some(model.tint(variant));
        let [body, wheel] = [("", model.body()), (" wheel", model.wheel_mesh())].map(|(part, mesh)| {
            let geometry = self.geometry(mesh)?;
            Some(self.mesh(&format!("{name}{part}"), &geometry, tint))
        });
        let rider = model.rider(variant).and_then(|rider| self.single("rider", &rider));
        let vehicle = self.vehicle(model, [body, wheel], Affine3A::IDENTITY);
        let trailer = model.trailer().and_then(|trailer| self.trailer(trailer, wheel, name, tint));
        self.group(name, &rider.into_iter().chain([vehicle]).chain(trailer).collect::<Vec<_>>())
    }

    /// What a vehicle draws, straight behind it.
    fn trailer(
        &mut self,
        trailer: &Trailer,
        wheel: Option<usize>,
        name: &str,
        tint: Option<[f32; 3]>,
    ) -> Option<usize> {
        let geometry = self.geometry(&trailer.body)?;
        let mesh = self.mesh(&format!("{name} trailer"), &geometry, tint);
        let mut parts = vec![self.instance("body", mesh, Affine3A::IDENTITY)];
        parts.extend(self.wheels(&trailer.wheels, wheel));
        self.group("trailer", &parts)
    }

    fn wheels(&mut self, wheels: &[Wheel], mesh: Option<usize>) -> Vec<usize> {
        let Some(mesh) = mesh else { return vec![] };
        let mut nodes = Vec::new();
        for at in wheels {
            let side = if at.mirrored { Vec3::new(1.0, -1.0, 1.0) } else { Vec3::ONE };
            let place = Affine3A::from_scale_rotation_translation(side, Quat::IDENTITY, at.position);
            nodes.push(self.instance("wheel", mesh, place));
        }
        nodes
    }

    /// A mesh's vertices and triangles; `None` if it has none.
    fn geometry(&mut self, mesh: &Mesh) -> Option<Geometry> {
        let mut of_material = vec![Vec::new(); mesh.materials.len()];
        for (triangle, &m) in mesh.triangles.iter().zip(&mesh.triangle_materials) {
            of_material[usize::from(m)].extend_from_slice(triangle);
        }
        if mesh.triangles.is_empty() {
            return None;
        }
        let upright = |n: Vec3| y_up(n.try_normalize().unwrap_or(Vec3::Z)).to_array();
        let attributes = json!({
            "POSITION": self.binary.vectors(mesh.positions.iter().map(|&p| y_up(p).to_array())),
            "NORMAL": self.binary.vectors(mesh.normals.iter().map(|&n| upright(n))),
        });
        let filled = mesh.materials.iter().zip(of_material).filter(|(_, indices)| !indices.is_empty());
        let parts = filled.map(|(&material, indices)| (material, self.binary.indices(&indices))).collect();
        Some(Geometry { attributes, parts })
    }

    fn mesh(&mut self, name: &str, geometry: &Geometry, tint: Option<[f32; 3]>) -> usize {
        let parts = geometry.parts.iter().map(|&(material, indices)| {
            let material = self.materials.index(material, tint);
            json!({ "attributes": geometry.attributes, "indices": indices, "material": material })
        });
        let parts: Vec<Value> = parts.collect();
        self.meshes.push(json!({ "name": name, "primitives": parts }));
        self.meshes.len() - 1
    }

    fn node(&mut self, node: Value) -> usize {
        self.nodes.push(node);
        self.nodes.len() - 1
    }

    fn instance(&mut self, name: &str, mesh: usize, world_from_object: Affine3A) -> usize {
        let mut node = placed(world_from_object);
        node["name"] = json!(name);
        node["mesh"] = json!(mesh);
        self.node(node)
    }

    /// A node over others; `None` over none.
    fn group(&mut self, name: &str, children: &[usize]) -> Option<usize> {
        (!children.is_empty()).then(|| self.node(json!({ "name": name, "children": children })))
    }

    /// The town's own meshes, each of them there once.
    pub(super) fn ground_and_buildings(&mut self, town: &Town) -> Option<usize> {
        let mut children = Vec::new();
        for placement in &town.placements {
            let What::Own(number) = placement.what else { continue };
            let mesh = &town.meshes[number as usize];
            let Some(geometry) = self.geometry(mesh) else { continue };
            let name = format!("{} {number}", usual_class(mesh));
            let mesh = self.mesh(&name, &geometry, None);
            children.push(self.instance(&name, mesh, placement.world_from_object));
        }
        self.group("Town", &children)
    }

    /// Plants, lamps, signs and the rest of the catalogue's.
    pub(super) fn furniture(&mut self, town: &Town) -> Option<usize> {
        let mut meshes: BTreeMap<(Prop, u32), Option<usize>> = BTreeMap::new();
        let mut children = Vec::new();
        for placement in &town.placements {
            let What::Prop(prop, variant) = placement.what else { continue };
            let variant = variant % self.catalogue.prop_variants(prop);
            let name = format!("{prop:?} {variant}");
            let mesh = match meshes.get(&(prop, variant)) {
                Some(known) => *known,
                None => {
                    let geometry = self.geometry(&self.catalogue.prop(prop, variant));
                    let mesh = geometry.map(|geometry| self.mesh(&name, &geometry, None));
                    meshes.insert((prop, variant), mesh);
                    mesh
                }
            };
            if let Some(mesh) = mesh {
                children.push(self.instance(&name, mesh, placement.world_from_object));
            }
        }
        self.group("Furniture", &children)
    }

    /// Parked vehicles: a body in the vehicle's colour, and its wheels.
    pub(super) fn parked(&mut self, town: &Town) -> Option<usize> {
        let mut models: BTreeMap<VehicleModelId, [Option<Geometry>; 2]> = BTreeMap::new();
        let mut bodies: BTreeMap<(VehicleModelId, [u32; 3]), [Option<usize>; 2]> = BTreeMap::new();
        let mut children = Vec::new();
        for parked in &town.parked {
            let number = parked.vehicle.model;
            let Some(model) = self.catalogue.vehicle(number) else { continue };
            let tint = model.tint(parked.vehicle.variant);
            let parts = models
                .entry(number)
                .or_insert_with(|| [self.geometry(model.body()), self.geometry(model.wheel_mesh())]);
            let meshes = *bodies.entry((number, tint.map(f32::to_bits))).or_insert_with(|| {
                let [body, wheel] = parts;
                let name = model.name();
                let body = body.as_ref().map(|g| self.mesh(name, g, Some(tint)));
                [body, wheel.as_ref().map(|g| self.mesh(&format!("{name} wheel"), g, Some(tint)))]
            });
            children.push(self.vehicle(model, meshes, parked.pose.world_from_object()));
        }
        self.group("Parked vehicles", &children)
    }

    fn vehicle(&mut self, model: &VehicleModel, [body, wheel]: [Option<usize>; 2], place: Affine3A) -> usize {
        let mut parts: Vec<usize> =
            body.into_iter().map(|mesh| self.instance("body", mesh, Affine3A::IDENTITY)).collect();
        parts.extend(self.wheels(model.wheels(), wheel));
        let mut node = placed(place);
        node["name"] = json!(model.name());
        node["children"] = json!(parts);
        self.node(node)
    }

    /// The camera sites: their node, and glTF's list of cameras.
    pub(super) fn cameras(&mut self, town: &Town) -> (Option<usize>, Vec<Value>) {
        let size = ImageSize { width: 1280, height: 720 };
        let aspect = size.width as f32 / size.height as f32;
        let mut cameras = Vec::new();
        let mut children = Vec::new();
        for site in &town.cameras {
            let camera = PinholeCamera::new(site, size);
            let [right, down, forward] =
                [camera.world_from_camera.x_axis, camera.world_from_camera.y_axis, camera.world_from_camera.z_axis];
            // glTF's cameras look along −z with y up.
            let turn = Quat::from_mat3(&Mat3::from_cols(y_up(right), y_up(-down), y_up(-forward))).normalize();
            let half = math::tan(site.horizontal_fov_rad / 2.0) / aspect;
            cameras.push(json!({
                "name": site.name, "type": "perspective",
                "perspective": { "yfov": 2.0 * math::atan(half), "aspectRatio": aspect, "znear": 0.1, "zfar": 4000.0 },
            }));
            let node = json!({
                "name": site.name, "camera": cameras.len() - 1,
                "translation": y_up(camera.position).to_array(), "rotation": turn.to_array(),
            });
            children.push(self.node(node));
        }
        (self.group("Cameras", &children), cameras)
    }
}

/// The class that most of a mesh's triangles carry.
fn usual_class(mesh: &Mesh) -> &'static str {
    let mut counts = BTreeMap::new();
    for &m in &mesh.triangle_materials {
        *counts.entry(mesh.materials[usize::from(m)].tag.name()).or_insert(0) += 1;
    }
    counts.into_iter().max_by_key(|(_, count)| *count).map_or("empty", |(name, _)| name)
}
