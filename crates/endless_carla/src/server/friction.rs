//! `static.trigger.friction`: boxes in which tyres grip otherwise.

use super::call_error::CallError;
use crate::blueprint::Attributes;
use crate::frames;
use crate::physics::OrientedBox;
use crate::wire::{BoundingBox, Transform, Vector3D};
use endless_world::math::f64::sin_cos;
use glam::{DVec2, DVec3, Vec3};

/// The attributes' unit is Unreal's, the centimetre.
const M_PER_CM: f64 = 0.01;

/// A box in which tyres grip otherwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FrictionTrigger {
    /// CARLA's `tire_friction`.
    friction: f64,
    /// Half of its length, width and height, metres.
    extent: DVec3,
}

impl FrictionTrigger {
    pub(super) fn new(attributes: &Attributes<'_>) -> Result<Self, CallError> {
        let metres = |id: &str| attributes.number(id).map(|number| M_PER_CM * number);
        let extent = DVec3::new(metres("extent_x")?, metres("extent_y")?, metres("extent_z")?);
        Ok(Self { friction: attributes.number("friction")?, extent })
    }

    /// In its own frame.
    pub(super) fn bounds(&self) -> BoundingBox {
        let Vec3 { x, y, z } = self.extent.as_vec3();
        BoundingBox { extent: Vector3D { x, y, z }, ..BoundingBox::default() }
    }

    /// CARLA's `tire_friction`.
    pub(super) fn friction(&self) -> f64 {
        self.friction
    }

    /// Where it is, upright.
    pub(super) fn outline(&self, transform: &Transform) -> OrientedBox {
        let place = frames::place(transform);
        let (sin, cos) = sin_cos(place.yaw_rad);
        OrientedBox {
            centre: place.position.truncate(),
            half: self.extent.truncate(),
            along: DVec2::new(cos, sin),
            low_m: place.position.z - self.extent.z,
            high_m: place.position.z + self.extent.z,
        }
    }
}
