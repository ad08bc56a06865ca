//! How large somebody is who can be touched.

use crate::Footprint;
use endless_world::{Actor, Motion, TrailerSpec, VehicleSpec, math};
use glam::Vec2;

/// Size of a body on the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodySize {
    /// Half length and half width, metres; of a vehicle with a trailer, both as they go straight on.
    pub half: Vec2,
    /// What it tows.
    pub trailer: Option<TrailerSpec>,
}

impl BodySize {
    /// Of a vehicle.
    pub fn of(spec: &VehicleSpec) -> Self {
        Self { half: 0.5 * Vec2::new(spec.length_m, spec.width_m), trailer: spec.trailer }
    }

    /// Of somebody rigid, half length and half width, metres.
    pub fn rigid(half: Vec2) -> Self {
        Self { half, trailer: None }
    }

    /// The ground under an actor of this size: one rectangle, or those of the towing vehicle and of its trailer.
    pub(super) fn footprints(&self, actor: &Actor) -> impl Iterator<Item = Footprint> + use<> {
        let whole = Footprint::of(actor, self.half);
        let hitch_rad = match actor.motion {
            Motion::Vehicle(motion) => motion.hitch_rad,
            Motion::Walker(_) => 0.0,
        };
        // From the rear to the front of a piece, metres ahead of a place.
        let piece = |place: Vec2, along: Vec2, rear: f32, front: f32| Footprint {
            centre: place + along * (0.5 * (rear + front)),
            along,
            half: Vec2::new(0.5 * (front - rear), whole.half.y),
            velocity: whole.velocity,
        };
        let parts = match self.trailer {
            None => [Some(whole), None],
            Some(TrailerSpec { hitch_m, front_m, towing_rear_m, .. }) => {
                let hitch = whole.centre + whole.along * hitch_m;
                let towed = Vec2::new(math::cos(hitch_rad), math::sin(hitch_rad)).rotate(whole.along);
                [
                    Some(piece(whole.centre, whole.along, towing_rear_m, whole.half.x)),
                    Some(piece(hitch, towed, -whole.half.x - hitch_m, front_m - hitch_m)),
                ]
            }
        };
        parts.into_iter().flatten()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{Behaviour, InstanceId, ObjectClass, Pose, VehicleModelId, VehicleMotion, VehicleRef};
    use glam::Vec3;
    use std::f32::consts::FRAC_PI_2;

    #[test]
    fn a_trailer_turns_about_its_hitch() {
        let trailer = TrailerSpec { hitch_m: -2.0, axle_m: -6.0, front_m: -1.0, towing_rear_m: -2.5 };
        let size = BodySize { half: Vec2::new(8.0, 1.2), trailer: Some(trailer) };
        let actor = |hitch_rad| Actor {
            id: InstanceId(1),
            rider_id: None,
            class: ObjectClass::Truck,
            asset: VehicleRef { model: VehicleModelId(0), variant: 0 }.into(),
            pose: Pose::level(Vec3::new(100.0, 50.0, 0.0), 0.0),
            velocity_mps: Vec3::ZERO,
            motion: Motion::Vehicle(VehicleMotion { hitch_rad, ..VehicleMotion::default() }),
            behaviour: Behaviour::default(),
            parked: false,
        };
        let straight: Vec<Footprint> = size.footprints(&actor(0.0)).collect();
        assert_eq!((straight[0].centre, straight[0].half), (Vec2::new(102.75, 50.0), Vec2::new(5.25, 1.2)));
        assert_eq!((straight[1].centre, straight[1].half), (Vec2::new(95.5, 50.0), Vec2::new(3.5, 1.2)));
        // Turned to the left, the trailer's rear is to the right of the hitch.
        let bent: Vec<Footprint> = size.footprints(&actor(FRAC_PI_2)).collect();
        assert_eq!(bent[0], straight[0]);
        assert!((bent[1].centre - Vec2::new(98.0, 47.5)).length() < 1e-4, "{:?}", bent[1]);
        assert_eq!(BodySize::rigid(size.half).footprints(&actor(0.3)).count(), 1);
    }
}
