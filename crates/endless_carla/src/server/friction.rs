//! `static.trigger.friction`: boxes in which tyres grip otherwise.

use super::actor::Body;
use super::call_error::CallError;
use super::episode::Episode;
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

    /// Where it is, upright.
    fn outline(&self, transform: &Transform) -> OrientedBox {
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

impl Episode {
    /// Vehicles that have come into a box, or have left it, grip otherwise. Of two boxes the newer one counts.
    pub(super) fn feel_friction(&mut self) {
        let boxes = self.actors.values().filter_map(|actor| match &actor.body {
            Body::FrictionTrigger(trigger) => Some((trigger.outline(&actor.transform), trigger.friction)),
            _ => None,
        });
        let boxes: Vec<_> = boxes.collect();
        for actor in self.actors.values_mut() {
            if let Body::Vehicle(vehicle) = &mut actor.body {
                let outline = vehicle.body.outline();
                let here = boxes.iter().rev().find(|(bounds, _)| outline.touches(bounds));
                vehicle.body.set_friction_here(here.map(|(_, friction)| *friction));
            }
        }
    }
}
