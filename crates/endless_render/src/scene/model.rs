//! Meshes as the renderer holds them, and their instances.

use super::Velocity;
use crate::accel::{Blas, Use, world_bounds};
use endless_asset::{PersonModel, Stance};
use endless_scene::Mesh;
use endless_world::{ClassTag, InstanceId, SignalId, WalkerMotion};
use glam::{Affine3A, Mat3A, Vec3, Vec3A};
use std::sync::Arc;

/// What does not change when a mesh deforms.
#[derive(Debug, Clone)]
pub(crate) struct Shape {
    /// As it was made: of what deforms, its vertices are those of the rest pose.
    pub(crate) mesh: Arc<Mesh>,
    /// Share of the surroundings that each vertex sees past its own body, 0 to 1; empty means 1 everywhere.
    pub(crate) openness: Vec<f32>,
}

/// What changes when a mesh deforms.
#[derive(Debug, Clone)]
pub(crate) struct Body {
    form: Form,
    pub(crate) blas: Arc<Blas>,
    /// Boxes, `(low, high)`, that together hold it closely.
    parts: Vec<(Vec3A, Vec3A)>,
}

/// Where vertices are.
#[derive(Debug, Clone)]
enum Form {
    /// Where they were made.
    Made(Arc<Mesh>),
    /// Those of a person, where they were put. Normals follow from how one stands: few are ever asked for.
    Posed { positions: Arc<[Vec3]>, person: Arc<PersonModel>, stance: Stance },
}

/// Of a mesh, which is shared; `None` if it has no triangles.
pub(crate) fn model(mesh: Arc<Mesh>, purpose: Use) -> Option<(Arc<Shape>, Arc<Body>)> {
    if mesh.triangles.is_empty() {
        return None;
    }
    let blas = Arc::new(Blas::build_for(purpose, &mesh.positions, &mesh.triangles));
    let parts = parts(&blas);
    let body = Body { form: Form::Made(Arc::clone(&mesh)), blas, parts };
    let shape = Shape { mesh, openness: Vec::new() };
    Some((Arc::new(shape), Arc::new(body)))
}

/// Boxes that together hold a mesh: some two dozen of a large one.
fn parts(blas: &Blas) -> Vec<(Vec3A, Vec3A)> {
    const LARGE: usize = 1000;
    const PARTS: usize = 24;
    blas.parts(if blas.triangle_count() < LARGE { 1 } else { PARTS })
}

impl Body {
    /// Poses what is the body of a person, in place.
    pub(crate) fn pose(&mut self, person: &Arc<PersonModel>, motion: &WalkerMotion) {
        let blas = Arc::make_mut(&mut self.blas);
        blas.release();
        let stance = person.stance(motion);
        let mut positions = match &self.form {
            Form::Made(mesh) => mesh.positions.as_slice().into(),
            Form::Posed { positions, .. } => Arc::clone(positions),
        };
        self.form = Form::Made(Arc::clone(&person.rest));
        person.place(&stance, Arc::make_mut(&mut positions));
        blas.refit(Arc::clone(&positions));
        self.form = Form::Posed { positions, person: Arc::clone(person), stance };
        self.parts = parts(&self.blas);
    }

    /// Where its vertices are.
    #[inline]
    pub(crate) fn positions(&self) -> &[Vec3] {
        match &self.form {
            Form::Made(mesh) => &mesh.positions,
            Form::Posed { positions, .. } => positions,
        }
    }

    /// The unit normal of a vertex.
    #[inline]
    pub(crate) fn normal(&self, vertex: usize) -> Vec3A {
        match &self.form {
            Form::Made(mesh) => mesh.normals[vertex].into(),
            Form::Posed { person, stance, .. } => person.normal(stance, vertex).into(),
        }
    }
}

/// A mesh standing somewhere, as something.
#[derive(Debug, Clone)]
pub(crate) struct Instance {
    pub(crate) shape: Arc<Shape>,
    pub(crate) body: Arc<Body>,
    pub(crate) world_from_object: Affine3A,
    /// Inverse transpose, for normals.
    pub(crate) normal_matrix: Mat3A,
    pub(crate) id: InstanceId,
    /// Class of the whole instance; `None`: each material's own.
    pub(crate) class: Option<ClassTag>,
    /// Paint.
    pub(crate) tint: Vec3A,
    /// Vehicle lights that are on (CARLA's bits).
    pub(crate) lights: u32,
    /// Signal group whose aspect lights its lenses.
    pub(crate) signal: Option<SignalId>,
    /// How it moves.
    pub(crate) velocity: Velocity,
    /// The moving object that it is a part of, by index; [`u16::MAX`] for the town.
    pub(crate) object: u16,
}

impl Instance {
    /// World-space boxes that together hold it.
    pub(crate) fn parts(&self) -> impl Iterator<Item = (Vec3A, Vec3A)> {
        self.body.parts.iter().map(|&bounds| world_bounds(bounds, &self.world_from_object))
    }

    /// A piece of the town: no id, materials' own classes.
    pub(crate) fn stuff(shape: Arc<Shape>, body: Arc<Body>, world_from_object: Affine3A) -> Self {
        Self {
            shape,
            body,
            world_from_object,
            normal_matrix: world_from_object.matrix3.inverse().transpose(),
            id: InstanceId::STUFF,
            class: None,
            tint: Vec3A::ONE,
            lights: 0,
            signal: None,
            velocity: Velocity::ZERO,
            object: u16::MAX,
        }
    }

    /// For the acceleration structure.
    pub(crate) fn placed(&self) -> (Arc<Blas>, Affine3A) {
        (Arc::clone(&self.body.blas), self.world_from_object)
    }
}
