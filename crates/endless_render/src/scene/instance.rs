//! Meshes placed in the world.

use super::{Geometry, RigidVelocity};
use crate::accel::{Blas, world_bounds};
use endless_scene::Material;
use endless_world::math::UnfusedMatrix;
use endless_world::{ClassTag, InstanceId, SignalId, VehicleLights};
use glam::{Affine3A, Mat3A, Vec3, Vec3A};
use std::sync::Arc;

/// A geometry standing somewhere, as something. At first it is stuff: it has no id, pixels carry their materials' classes,
/// and it stands still.
#[derive(Debug, Clone)]
pub struct Instance {
    pub(crate) geometry: Geometry,
    pub(crate) world_from_object: Affine3A,
    /// Inverse transpose, for normals.
    pub(crate) normal_matrix: Mat3A,
    pub(crate) id: InstanceId,
    /// Class of the whole instance; `None`: each material's own.
    pub(crate) class: Option<ClassTag>,
    /// Of its paint, and of the light of its lamp's lens.
    pub(crate) tint: Vec3A,
    /// Vehicle lights that are on.
    pub(crate) lights: VehicleLights,
    /// Signal group whose aspect lights its lenses.
    pub(crate) signal: Option<SignalId>,
    /// Its velocity.
    pub(crate) velocity: RigidVelocity,
    /// The moving object that it is a part of, by index; [`u16::MAX`] for what stands still.
    pub(crate) object: u16,
}

impl Instance {
    /// Stuff.
    pub fn new(geometry: &Geometry, world_from_object: Affine3A) -> Self {
        Self {
            geometry: geometry.clone(),
            world_from_object,
            normal_matrix: world_from_object.matrix3.inverse_unfused().transpose(),
            id: InstanceId::STUFF,
            class: None,
            tint: Vec3A::ONE,
            lights: VehicleLights::default(),
            signal: None,
            velocity: RigidVelocity::ZERO,
            object: u16::MAX,
        }
    }

    /// An object: all its pixels carry this id and class.
    #[must_use]
    pub fn with_id(self, id: InstanceId, class: ClassTag) -> Self {
        Self { id, class: Some(class), ..self }
    }

    /// With a linear colour that multiplies its [`CarPaint`](endless_scene::Surface::CarPaint).
    #[must_use]
    pub fn with_tint(self, tint: Vec3) -> Self {
        Self { tint: tint.into(), ..self }
    }

    /// With these of its [`VehicleLight`](endless_scene::Surface::VehicleLight)s lit.
    #[must_use]
    pub fn with_lights(self, lights: VehicleLights) -> Self {
        Self { lights, ..self }
    }

    /// With [`SignalLens`](endless_scene::Surface::SignalLens)es that show the aspect of a signal group.
    #[must_use]
    pub fn with_signal(self, signal: Option<SignalId>) -> Self {
        Self { signal, ..self }
    }

    /// Moving so at this instant: an open shutter blurs it.
    #[must_use]
    pub fn with_velocity(self, velocity: RigidVelocity) -> Self {
        Self { velocity, ..self }
    }

    /// With another mesh in its place.
    #[must_use]
    pub fn with_geometry(self, geometry: &Geometry) -> Self {
        Self { geometry: geometry.clone(), ..self }
    }

    /// Its mesh.
    pub fn geometry(&self) -> &Geometry {
        &self.geometry
    }

    /// Its class, if all of it has one.
    pub fn class(&self) -> Option<ClassTag> {
        self.class
    }

    /// The middle of its lamp's lens in the world; none if it is no lamp.
    pub(super) fn lens(&self) -> Option<Vec3A> {
        self.geometry.lens_middle().map(|middle| self.world_from_object.transform_point3a(middle))
    }

    /// World-space boxes that together hold it closely.
    pub(crate) fn close_bounds(&self) -> impl Iterator<Item = (Vec3A, Vec3A)> {
        self.geometry.posed.bounds.iter().map(|&bounds| world_bounds(bounds, &self.world_from_object))
    }

    /// The material of a triangle, and its number in the mesh.
    pub(crate) fn material_of(&self, triangle: u32) -> (u16, &Material) {
        let mesh = &*self.geometry.mesh;
        let number = mesh.triangle_materials[triangle as usize];
        (number, &mesh.materials[usize::from(number)])
    }

    /// For the acceleration structure.
    pub(crate) fn placed(&self) -> (Arc<Blas>, Affine3A) {
        (Arc::clone(&self.geometry.posed.blas), self.world_from_object)
    }
}
