//! Meshes that deform in every frame, such as people.

use super::{Geometry, deformation::Deformation, posed_mesh::PosedMesh};
use crate::accel::GeometryUse;
use endless_scene::Mesh;
use endless_world::BodyPart;
use glam::Vec3;
use std::sync::{Arc, Mutex, PoisonError};

/// A mesh that deforms, with its rest pose. The memory of posed meshes that are no longer used is reused.
#[derive(Debug)]
pub struct DeformableMesh {
    rest: Geometry,
    posed: Mutex<Vec<Arc<PosedMesh>>>,
}

impl DeformableMesh {
    /// From a mesh in its rest pose.
    pub fn new(rest: impl Into<Arc<Mesh>>) -> Self {
        Self { rest: Geometry::for_use(rest.into(), GeometryUse::Deforming), posed: Mutex::default() }
    }

    /// With ambient occlusion as it is in some typical form, for all forms; see [`Geometry::with_ambient_occlusion`].
    #[must_use]
    pub fn with_ambient_occlusion(self, typical: &Arc<dyn Deformation>, low: Vec3, high: Vec3) -> Self {
        if self.rest.is_empty() {
            return self;
        }
        let ambient_occlusion = self.deformed(typical).with_ambient_occlusion(low, high).ambient_occlusion;
        Self { rest: Geometry { ambient_occlusion, ..self.rest }, posed: Mutex::default() }
    }

    /// As somebody's body; see [`Geometry::with_body_parts`].
    #[must_use]
    pub fn with_body_parts(self, parts: Arc<[BodyPart]>) -> Self {
        Self { rest: self.rest.with_body_parts(parts), ..self }
    }

    /// The mesh as it stands.
    pub fn deformed(&self, deformation: &Arc<dyn Deformation>) -> Geometry {
        if self.rest.is_empty() {
            return self.rest.clone();
        }
        let mut posed = self.spare().unwrap_or_else(|| self.rest.posed.as_ref().clone());
        posed.deform(&self.rest.mesh, deformation);
        let posed = Arc::new(posed);
        self.posed.lock().unwrap_or_else(PoisonError::into_inner).push(Arc::clone(&posed));
        Geometry { posed, ..self.rest.clone() }
    }

    /// A form that was made for an instant that is gone.
    fn spare(&self) -> Option<PosedMesh> {
        let mut posed = self.posed.lock().unwrap_or_else(PoisonError::into_inner);
        let free = posed.iter().position(|posed| Arc::strong_count(posed) == 1)?;
        Arc::into_inner(posed.swap_remove(free))
    }
}
