//! What a ray meets of what stands still, for those who put things into a scene.

use super::{StaticScene, SurfaceInteraction};
use crate::accel::Ray;
use endless_world::ClassTag;
use glam::Vec3;

/// A point of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// World frame, metres.
    pub position: Vec3,
    /// Its class.
    pub tag: ClassTag,
}

impl StaticScene {
    /// The first surface along a ray, at most `reach_m` metres away; `direction` is of unit length.
    pub fn first_surface(&self, origin: Vec3, direction: Vec3, reach_m: f32) -> Option<SurfacePoint> {
        let ray = Ray { origin: origin.into(), direction: direction.into(), tmax: reach_m };
        let hit = self.accel.closest(&ray)?;
        let point = SurfaceInteraction::new(&self.instances, &ray, &hit);
        Some(SurfacePoint { position: point.position.into(), tag: point.tag() })
    }

    /// The same scene with more instances.
    #[must_use]
    pub fn with_instances(&self, more: impl IntoIterator<Item = super::Instance>) -> Self {
        let mut instances = self.instances.clone();
        instances.extend(more);
        Self::of(instances, self.lamps.clone())
    }
}
