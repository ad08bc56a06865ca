//! Vehicles: a body, wheels that share a mesh, a rider, a trailer.

use super::document::{GltfDocument, node_at};
use endless_asset::{Trailer, VehicleModel, Wheel};
use glam::{Affine3A, Quat, Vec3};
use gltf::json::{self, Index, Node};

/// The meshes of a vehicle in one colour.
#[derive(Debug, Clone, Copy)]
pub(super) struct VehicleMeshes {
    pub(super) body: Option<Index<json::Mesh>>,
    /// That all of its wheels share.
    pub(super) wheel: Option<Index<json::Mesh>>,
}

impl GltfDocument<'_> {
    /// One vehicle at the origin, in the paint of a variant, with its rider if it has one.
    pub(super) fn single_vehicle(&mut self, model: &VehicleModel, variant: u64) -> Option<Index<Node>> {
        let name = model.name();
        let tint = Some(model.tint(variant));
        let mut mesh = |name: &str, mesh| self.accessors(mesh).map(|a| self.mesh(name, &a, tint));
        let body = mesh(name, model.body());
        let wheel = mesh(&format!("{name} wheel"), model.wheel_mesh());
        let rider = model.rider(variant).and_then(|rider| self.single("rider", &rider));
        let vehicle = self.vehicle(model, VehicleMeshes { body, wheel }, Affine3A::IDENTITY);
        let trailer = model.trailer().and_then(|trailer| self.trailer(trailer, wheel, name, tint));
        self.group(name, rider.into_iter().chain([vehicle]).chain(trailer).collect())
    }

    /// A vehicle of the meshes of its body and of its wheels.
    pub(super) fn vehicle(
        &mut self,
        model: &VehicleModel,
        VehicleMeshes { body, wheel }: VehicleMeshes,
        place: Affine3A,
    ) -> Index<Node> {
        let mut parts: Vec<Index<Node>> =
            body.into_iter().map(|mesh| self.instance("body", mesh, Affine3A::IDENTITY)).collect();
        parts.extend(self.wheels(model.wheels(), wheel));
        self.root.push(Node { children: Some(parts), ..node_at(model.name(), place) })
    }

    /// What a vehicle draws, straight behind it.
    fn trailer(
        &mut self,
        trailer: &Trailer,
        wheel: Option<Index<json::Mesh>>,
        name: &str,
        tint: Option<[f32; 3]>,
    ) -> Option<Index<Node>> {
        let accessors = self.accessors(&trailer.body)?;
        let mesh = self.mesh(&format!("{name} trailer"), &accessors, tint);
        let mut parts = vec![self.instance("body", mesh, Affine3A::IDENTITY)];
        parts.extend(self.wheels(&trailer.wheels, wheel));
        self.group("trailer", parts)
    }

    fn wheels(&mut self, wheels: &[Wheel], mesh: Option<Index<json::Mesh>>) -> Vec<Index<Node>> {
        let Some(mesh) = mesh else { return vec![] };
        let mut nodes = Vec::new();
        for at in wheels {
            let side = if at.mirrored { Vec3::new(1.0, -1.0, 1.0) } else { Vec3::ONE };
            let place = Affine3A::from_scale_rotation_translation(side, Quat::IDENTITY, at.position);
            nodes.push(self.instance("wheel", mesh, place));
        }
        nodes
    }
}
