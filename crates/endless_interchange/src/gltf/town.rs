//! The contents of a town: its own meshes, the catalogue's, parked vehicles, cameras.

use super::document::{GltfDocument, MeshAccessors, y_up};
use super::vehicle::VehicleMeshes;
use endless_asset::Prop;
use endless_scene::Mesh;
use endless_town::{PlacedObject, Town};
use endless_world::{ImageSize, PinholeCamera, VehicleModelId, math};
use glam::{Mat3, Quat};
use gltf::json::{
    self, Index, Node,
    camera::{Perspective, Type},
    scene::UnitQuaternion,
    validation::Checked::Valid,
};
use std::collections::BTreeMap;

impl GltfDocument<'_> {
    /// The town's own meshes, each of them there once.
    pub(super) fn ground_and_buildings(&mut self, town: &Town) -> Option<Index<Node>> {
        let mut children = Vec::new();
        for placement in &town.placements {
            let PlacedObject::TownMesh(number) = placement.object else { continue };
            let mesh = &town.meshes[number as usize];
            let Some(accessors) = self.accessors(mesh) else { continue };
            let name = format!("{} {number}", most_frequent_class(mesh));
            let mesh = self.mesh(&name, &accessors, None);
            children.push(self.instance(&name, mesh, placement.world_from_object));
        }
        self.group("Town", children)
    }

    /// Plants, lamps, signs and the rest of the catalogue's.
    pub(super) fn furniture(&mut self, town: &Town) -> Option<Index<Node>> {
        let mut meshes: BTreeMap<(Prop, u32), Option<Index<json::Mesh>>> = BTreeMap::new();
        let mut children = Vec::new();
        for placement in &town.placements {
            let PlacedObject::Prop(prop, variant) = placement.object else { continue };
            let variant = variant % self.catalogue.prop_variants(prop);
            let name = format!("{prop:?} {variant}");
            let mesh = match meshes.get(&(prop, variant)) {
                Some(known) => *known,
                None => {
                    let accessors = self.accessors(&self.catalogue.prop(prop, variant));
                    let mesh = accessors.map(|accessors| self.mesh(&name, &accessors, None));
                    meshes.insert((prop, variant), mesh);
                    mesh
                }
            };
            if let Some(mesh) = mesh {
                children.push(self.instance(&name, mesh, placement.world_from_object));
            }
        }
        self.group("Furniture", children)
    }

    /// Parked vehicles: a body in the vehicle's colour, and its wheels.
    pub(super) fn parked(&mut self, town: &Town) -> Option<Index<Node>> {
        let mut models: BTreeMap<VehicleModelId, [Option<MeshAccessors>; 2]> = BTreeMap::new();
        let mut bodies: BTreeMap<(VehicleModelId, [u32; 3]), VehicleMeshes> = BTreeMap::new();
        let mut children = Vec::new();
        for parked in &town.parked {
            let number = parked.vehicle.model;
            let Some(model) = self.catalogue.vehicle(number) else { continue };
            let tint = model.tint(parked.vehicle.variant);
            let parts = models
                .entry(number)
                .or_insert_with(|| [self.accessors(model.body()), self.accessors(model.wheel_mesh())]);
            let meshes = *bodies.entry((number, tint.map(f32::to_bits))).or_insert_with(|| {
                let [body, wheel] = parts;
                let name = model.name();
                let body = body.as_ref().map(|g| self.mesh(name, g, Some(tint)));
                let wheel = wheel.as_ref().map(|g| self.mesh(&format!("{name} wheel"), g, Some(tint)));
                VehicleMeshes { body, wheel }
            });
            children.push(self.vehicle(model, meshes, parked.pose.world_from_object()));
        }
        self.group("Parked vehicles", children)
    }

    /// The camera sites.
    pub(super) fn cameras(&mut self, town: &Town) -> Option<Index<Node>> {
        let size = ImageSize { width: 1280, height: 720 };
        let aspect = size.width as f32 / size.height as f32;
        let mut children = Vec::new();
        for site in &town.cameras {
            let camera = PinholeCamera::new(site, size);
            let [right, down, forward] =
                [camera.world_from_camera.x_axis, camera.world_from_camera.y_axis, camera.world_from_camera.z_axis];
            // glTF's cameras look along −z with y up.
            let turn = Quat::from_mat3(&Mat3::from_cols(y_up(right), y_up(-down), y_up(-forward))).normalize();
            let half = math::tan(site.horizontal_fov_rad / 2.0) / aspect;
            let perspective = Perspective {
                aspect_ratio: Some(aspect),
                yfov: 2.0 * math::atan(half),
                zfar: Some(4000.0),
                znear: 0.1,
                extensions: None,
                extras: None,
            };
            let lens = self.root.push(json::Camera {
                name: Some(site.name.clone()),
                orthographic: None,
                perspective: Some(perspective),
                type_: Valid(Type::Perspective),
                extensions: None,
                extras: None,
            });
            children.push(self.root.push(Node {
                name: Some(site.name.clone()),
                camera: Some(lens),
                translation: Some(y_up(camera.position).to_array()),
                rotation: Some(UnitQuaternion(turn.to_array())),
                ..Node::default()
            }));
        }
        self.group("Cameras", children)
    }
}

/// The class that most of a mesh's triangles carry.
fn most_frequent_class(mesh: &Mesh) -> &'static str {
    let mut counts = BTreeMap::new();
    for &m in &mesh.triangle_materials {
        *counts.entry(mesh.materials[usize::from(m)].tag.name()).or_insert(0) += 1;
    }
    counts.into_iter().max_by_key(|(_, count)| *count).map_or("empty", |(name, _)| name)
}
