//! Props that come and go with the actors.

use endless_asset::Prop;
use endless_render::{Footprint, Geometry, Instance, MovingObject};
use endless_world::{ClassTag, InstanceId};
use glam::{Affine3A, Vec2};

/// A prop that somebody has put somewhere, and may move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedProp {
    /// In pictures.
    pub id: InstanceId,
    /// Of all its pixels.
    pub class: ClassTag,
    /// Which.
    pub prop: Prop,
    /// Which variant of it.
    pub variant: u32,
    /// Where.
    pub world_from_object: Affine3A,
}

impl PlacedProp {
    /// What is drawn of it.
    pub(crate) fn drawn(&self, geometry: &Geometry) -> MovingObject {
        let instance = Instance::new(geometry, self.world_from_object).with_id(self.id, self.class);
        let (low, high) = geometry.mesh().bounds();
        let half_m = Vec2::new(0.5 * (high.x - low.x), low.y.abs().max(high.y.abs()));
        let footprint = Footprint {
            world_from_object: self.world_from_object,
            ahead_m: 0.5 * (low.x + high.x),
            half_m,
            height_m: high.z.max(0.0),
        };
        MovingObject { instances: vec![instance], footprint }
    }
}
