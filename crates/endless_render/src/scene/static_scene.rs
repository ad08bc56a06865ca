//! The static scene, the same in every frame.

use super::Instance;
use crate::accel::Tlas;
use crate::light::Lamps;
use endless_scene::StreetLamp;
use std::sync::Arc;

/// Everything that stands still, ready to be traced: made once a map, and shared by all its videos.
#[derive(Debug, Clone)]
pub struct StaticScene {
    pub(crate) instances: Vec<Instance>,
    pub(crate) accel: Tlas,
    pub(crate) lamps: Arc<Lamps>,
}

impl StaticScene {
    /// A scene of instances, and of the lamps that are lit at night. Instances without triangles are left out.
    pub fn new(instances: Vec<Instance>, lamps: &[StreetLamp]) -> Self {
        Self::with_lamps(instances, Arc::new(Lamps::new(lamps)))
    }

    /// The same with more instances: what is there for the cameras of one video. Geometry is shared; what is made again
    /// is the top level of the hierarchy, in some milliseconds.
    #[must_use]
    pub fn with_instances(&self, more: impl IntoIterator<Item = Instance>) -> Self {
        Self::with_lamps(self.instances.iter().cloned().chain(more).collect(), Arc::clone(&self.lamps))
    }

    fn with_lamps(mut instances: Vec<Instance>, lamps: Arc<Lamps>) -> Self {
        instances.retain(|instance| !instance.geometry.is_empty());
        let accel = Tlas::build(instances.iter().map(Instance::placed).collect());
        Self { instances, accel, lamps }
    }

    /// Number of triangles as placed, for reports.
    pub fn placed_triangles(&self) -> usize {
        self.instances.iter().map(|i| i.geometry.mesh.triangles.len()).sum()
    }
}
