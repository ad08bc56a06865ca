//! Meshes as the renderer holds them: with a hierarchy over their triangles, shared by all their instances.

use super::ambient_occlusion::AmbientOcclusion;
use super::posed_mesh::PosedMesh;
use crate::accel::GeometryUse;
use endless_scene::{Material, Mesh, Surface};
use endless_world::BodyPart;
use glam::{Vec3, Vec3A};
use std::sync::Arc;

/// A mesh ready to be traced. Clones are cheap and share everything.
#[derive(Debug, Clone)]
pub struct Geometry {
    /// The mesh; if it deforms, in its rest pose.
    pub(crate) mesh: Arc<Mesh>,
    /// Share of the surroundings that each vertex sees past its own body; `None`: all of them.
    pub(super) ambient_occlusion: Option<Arc<AmbientOcclusion>>,
    /// The part of somebody's body that each triangle shows.
    pub(super) body_parts: Option<Arc<[BodyPart]>>,
    /// Vertices and tree of a deformed mesh.
    pub(crate) posed: Arc<PosedMesh>,
}

impl Geometry {
    /// For static meshes, which many rays hit: builds a good hierarchy.
    pub fn new(mesh: impl Into<Arc<Mesh>>) -> Self {
        Self::for_use(mesh.into(), GeometryUse::Still)
    }

    /// For rigid moving meshes, such as vehicles: builds a hierarchy quickly.
    pub fn rigid(mesh: impl Into<Arc<Mesh>>) -> Self {
        Self::for_use(mesh.into(), GeometryUse::Rigid)
    }

    pub(super) fn for_use(mesh: Arc<Mesh>, purpose: GeometryUse) -> Self {
        let posed = Arc::new(PosedMesh::new(Arc::clone(&mesh), purpose));
        Self { mesh, ambient_occlusion: None, body_parts: None, posed }
    }

    /// With ambient occlusion by itself and by the ground beneath it, traced at vertices as they are seen. `low` and
    /// `high` bound the whole object in its own frame, metres: of a wheel, the whole vehicle.
    #[must_use]
    pub fn with_ambient_occlusion(self, low: Vec3, high: Vec3) -> Self {
        let ambient_occlusion = AmbientOcclusion::new(Arc::clone(&self.posed), low, high);
        Self { ambient_occlusion: Some(Arc::new(ambient_occlusion)), ..self }
    }

    /// As somebody's body, with the part that each triangle of the mesh shows.
    #[must_use]
    pub fn with_body_parts(self, parts: Arc<[BodyPart]>) -> Self {
        Self { body_parts: Some(parts), ..self }
    }

    /// The part of a body that a triangle shows, if it is one.
    pub(crate) fn body_part(&self, triangle: u32) -> Option<BodyPart> {
        self.body_parts.as_ref()?.get(triangle as usize).copied()
    }

    /// The mesh that it was made of.
    pub fn mesh(&self) -> &Arc<Mesh> {
        &self.mesh
    }

    /// The same mesh without the triangles of some materials, for static scenes.
    #[must_use]
    pub fn without(&self, leaves_out: impl Fn(&Material) -> bool) -> Self {
        let mesh = &*self.mesh;
        let is_left = |&(_, material): &(&[u32; 3], &u16)| !leaves_out(&mesh.materials[usize::from(*material)]);
        let (triangles, triangle_materials) =
            mesh.triangles.iter().zip(&mesh.triangle_materials).filter(is_left).map(|(t, m)| (*t, *m)).unzip();
        Self::new(Mesh { triangles, triangle_materials, ..mesh.clone() })
    }

    /// The middle of the lens of a street lamp in the object's frame; none if it has none.
    pub(super) fn lens_middle(&self) -> Option<Vec3A> {
        let mesh = &*self.mesh;
        let is_lens: Vec<bool> = mesh.materials.iter().map(|material| material.surface == Surface::LampLens).collect();
        if !is_lens.contains(&true) {
            return None;
        }
        let of_lens = mesh.triangles.iter().zip(&mesh.triangle_materials).filter(|(_, m)| is_lens[usize::from(**m)]);
        let corners =
            of_lens.flat_map(|(corners, _)| corners.map(|corner| Vec3A::from(mesh.positions[corner as usize])));
        let bounds = corners.fold(None, |known: Option<(Vec3A, Vec3A)>, at| {
            Some(known.map_or((at, at), |(low, high)| (low.min(at), high.max(at))))
        });
        bounds.map(|(low, high)| 0.5 * (low + high))
    }

    /// Whether it has no triangles: instances of it are left out.
    pub fn is_empty(&self) -> bool {
        self.mesh.triangles.is_empty()
    }
}
