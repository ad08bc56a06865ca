//! Objects by themselves: the pixels that one covers where nothing stands before it, and its extent in space.
//!
//! The pixel of an object's amodal mask is one whose centre's ray meets the object, as in the instance image: so where
//! nothing is in the way, both are the same to the pixel.

mod extent;
mod trace;

use crate::accel::Tlas;
use crate::scene::{FrameScene, Instance, StaticScene};
use endless_world::InstanceId;

/// The surfaces of one object at an instant, without all others.
#[derive(Debug)]
pub struct ObjectShape {
    instances: Vec<Instance>,
    accel: Tlas,
}

impl ObjectShape {
    fn of<'a>(instances: impl Iterator<Item = &'a Instance>) -> Option<Self> {
        let instances: Vec<Instance> = instances.cloned().collect();
        let accel = Tlas::build(instances.iter().map(Instance::placed).collect());
        (!instances.is_empty()).then_some(Self { instances, accel })
    }
}

impl FrameScene {
    /// One of the objects that move; `None` if none of them has this id.
    pub fn object_shape(&self, id: InstanceId) -> Option<ObjectShape> {
        ObjectShape::of(self.instances.iter().filter(|instance| instance.id == id))
    }
}

impl StaticScene {
    /// One of the objects that stand still; `None` if none of them has this id.
    pub fn object_shape(&self, id: InstanceId) -> Option<ObjectShape> {
        ObjectShape::of(self.instances.iter().filter(|instance| instance.id == id))
    }
}
