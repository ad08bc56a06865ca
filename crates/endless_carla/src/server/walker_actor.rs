//! People.

use super::call_error::CallError;
use super::walker_bones::WalkerPose;
use crate::blueprint::{Attributes, Blueprint, WalkerBlueprint};
use crate::frames;
use crate::physics::{Place, WalkerBody};
use crate::wire::{Transform, WalkerControl};
use endless_world::{Outfit, PersonRef, WalkerMotion};

/// A person.
pub(super) struct WalkerActor {
    pub(super) asset: PersonRef,
    pub(super) body: WalkerBody,
    pub(super) control: WalkerControl,
    /// That clients give it; pictures show its animation alone.
    pub(super) pose: WalkerPose,
    /// Of the actor's place above the ground, metres.
    pub(super) origin_height_m: f32,
}

impl WalkerActor {
    pub(super) fn new(
        walker: &WalkerBlueprint,
        blueprint: &Blueprint,
        attributes: &Attributes<'_>,
        transform: &Transform,
    ) -> Result<Self, CallError> {
        let rolls = attributes.has("use_wheelchair") && attributes.flag("use_wheelchair")?;
        let seed = walker.person_in_wheelchair.filter(|_| rolls).unwrap_or(walker.person);
        let extent = &blueprint.bounding_box.extent;
        let place = below(transform, walker.origin_height_m);
        Ok(Self {
            asset: PersonRef { outfit: Outfit::Fair, seed },
            body: WalkerBody::new(2.0 * f64::from(extent.z), extent.x.into(), place),
            control: WalkerControl::default(),
            pose: WalkerPose::default(),
            origin_height_m: walker.origin_height_m,
        })
    }

    /// What is seen of them at this time of the episode.
    pub(super) fn motion(&self, time_s: f64) -> WalkerMotion {
        self.body.motion(time_s)
    }

    pub(super) fn apply_control(&mut self, control: &WalkerControl) {
        self.control = control.clone();
    }

    /// Puts them somewhere.
    pub(super) fn put(&mut self, transform: &Transform) {
        self.body.put(below(transform, self.origin_height_m));
    }

    /// Puts them somewhere, walking: as the crowd of a client does.
    pub(super) fn put_walking(&mut self, transform: &Transform, speed_mps: f32) {
        self.body.put_walking(below(transform, self.origin_height_m), speed_mps.into());
        self.control.speed = speed_mps;
    }

    /// Where the actor is: CARLA's people have their place in their middle.
    pub(super) fn transform(&self) -> Transform {
        let mut transform = frames::transform_of(&self.body.place());
        transform.location.z += self.origin_height_m;
        transform
    }

    /// Where its feet are.
    pub(super) fn on_ground(&self, transform: &Transform) -> Transform {
        let mut transform = transform.clone();
        transform.location.z -= self.origin_height_m;
        transform
    }
}

fn below(transform: &Transform, height_m: f32) -> Place {
    let mut place = frames::place(transform);
    place.position.z -= f64::from(height_m);
    place
}
