//! A person's geometry: a mesh that follows bones.

use endless_asset::{PersonModel, Stance};
use endless_render::{DeformableMesh, Deformation, Geometry};
use endless_world::{Gait, WalkerMotion};
use glam::Vec3;
use std::sync::Arc;

/// The mesh of a person on foot.
#[derive(Debug)]
pub(crate) struct PersonGeometry {
    model: Arc<PersonModel>,
    mesh: DeformableMesh,
}

/// A person as they stand at an instant.
#[derive(Debug)]
struct PosedPerson {
    model: Arc<PersonModel>,
    stance: Stance,
}

impl Deformation for PosedPerson {
    fn positions(&self, positions: &mut [Vec3]) {
        self.model.place(&self.stance, positions);
    }

    fn normal(&self, vertex: usize) -> Vec3 {
        self.model.normal(&self.stance, vertex)
    }
}

impl PersonGeometry {
    /// Ambient occlusion is that of mid-stride: legs and arms that touch at rest would be dark for ever.
    pub(crate) fn new(model: PersonModel) -> Self {
        let model = Arc::new(model);
        let stride = WalkerMotion { speed_mps: 1.3, gait: Gait::Walk, ..WalkerMotion::default() };
        let (low, high) = (Vec3::new(-0.25, -0.3, 0.0), Vec3::new(0.25, 0.3, model.height_m));
        let mesh = DeformableMesh::new(Arc::clone(&model.rest))
            .with_body_parts(Arc::clone(&model.parts))
            .with_ambient_occlusion(&posed(&model, &stride), low, high);
        Self { model, mesh }
    }

    /// The body as it stands in a motion.
    pub(crate) fn posed(&self, motion: &WalkerMotion) -> Geometry {
        self.mesh.deformed(&posed(&self.model, motion))
    }

    pub(crate) fn height_m(&self) -> f32 {
        self.model.height_m
    }
}

fn posed(model: &Arc<PersonModel>, motion: &WalkerMotion) -> Arc<dyn Deformation> {
    Arc::new(PosedPerson { model: Arc::clone(model), stance: model.stance(motion) })
}
