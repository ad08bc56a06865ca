//! The vertices of a mesh at one instant, and the hierarchy over its triangles.

use super::deformation::Deformation;
use crate::accel::{Blas, GeometryUse};
use endless_scene::Mesh;
use glam::{Vec3, Vec3A};
use std::sync::Arc;

/// The vertices and tree of a deformed mesh.
#[derive(Debug, Clone)]
pub(crate) struct PosedMesh {
    vertices: VertexSource,
    pub(crate) blas: Arc<Blas>,
    /// Boxes, `(low, high)`, that together hold it closely.
    pub(super) bounds: Vec<(Vec3A, Vec3A)>,
}

/// Source of vertex positions.
#[derive(Debug, Clone)]
enum VertexSource {
    /// The positions of the mesh itself.
    AsMade(Arc<Mesh>),
    /// Deformed positions. Normals are computed on demand: few are ever needed.
    Deformed { positions: Arc<[Vec3]>, deformation: Arc<dyn Deformation> },
}

impl PosedMesh {
    pub(super) fn new(mesh: Arc<Mesh>, purpose: GeometryUse) -> Self {
        let blas = Arc::new(Blas::build_for(purpose, &mesh.positions, &mesh.triangles));
        let bounds = close_bounds(&blas);
        Self { vertices: VertexSource::AsMade(mesh), blas, bounds }
    }

    /// Moves the vertices, in place; `rest` is the mesh that deforms.
    pub(super) fn deform(&mut self, rest: &Arc<Mesh>, deformation: &Arc<dyn Deformation>) {
        let blas = Arc::make_mut(&mut self.blas);
        blas.release();
        let mut positions = match &self.vertices {
            VertexSource::AsMade(mesh) => mesh.positions.as_slice().into(),
            VertexSource::Deformed { positions, .. } => Arc::clone(positions),
        };
        self.vertices = VertexSource::AsMade(Arc::clone(rest));
        deformation.positions(Arc::make_mut(&mut positions));
        blas.refit(Arc::clone(&positions));
        self.vertices = VertexSource::Deformed { positions, deformation: Arc::clone(deformation) };
        self.bounds = close_bounds(&self.blas);
    }

    /// Its vertex positions.
    #[inline]
    pub(crate) fn positions(&self) -> &[Vec3] {
        match &self.vertices {
            VertexSource::AsMade(mesh) => &mesh.positions,
            VertexSource::Deformed { positions, .. } => positions,
        }
    }

    /// The unit normal of a vertex.
    #[inline]
    pub(crate) fn normal(&self, vertex: usize) -> Vec3A {
        match &self.vertices {
            VertexSource::AsMade(mesh) => mesh.normals[vertex].into(),
            VertexSource::Deformed { deformation, .. } => deformation.normal(vertex).into(),
        }
    }
}

/// Boxes that together hold a mesh: some two dozen of a large one.
fn close_bounds(blas: &Blas) -> Vec<(Vec3A, Vec3A)> {
    const LARGE: usize = 1000;
    const COUNT: usize = 24;
    blas.parts(if blas.triangle_count() < LARGE { 1 } else { COUNT })
}
