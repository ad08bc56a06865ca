//! Velocities of the rigid bodies of actors.

use endless_render::RigidVelocity;
use endless_world::{Actor, Motion, math};
use glam::Vec3A;

/// Of an actor's body. A vehicle turns as its front wheels are steered over a `wheelbase_m`.
pub(crate) fn of_body(actor: &Actor, wheelbase_m: f32) -> RigidVelocity {
    let turn = match actor.motion {
        Motion::Vehicle(m) if wheelbase_m > 0.0 => m.speed_mps * math::tan(m.steer_rad) / wheelbase_m,
        _ => 0.0,
    };
    RigidVelocity {
        linear_mps: Vec3A::from(actor.velocity_mps),
        angular_radps: Vec3A::Z * turn,
        about: Vec3A::from(actor.pose.position),
    }
}

/// Of a wheel that a body carries: it also turns about its `axle` (unit, to the left), at `hub`.
pub(crate) fn of_wheel(body: RigidVelocity, hub: Vec3A, axle: Vec3A, turn_radps: f32) -> RigidVelocity {
    RigidVelocity { linear_mps: body.at(hub), angular_radps: body.angular_radps + axle * turn_radps, about: hub }
}

/// Of a trailer that a body draws by a `hitch`, and that turns by itself.
pub(crate) fn of_trailer(body: RigidVelocity, hitch: Vec3A, turn_radps: f32) -> RigidVelocity {
    RigidVelocity { linear_mps: body.at(hitch), angular_radps: Vec3A::Z * turn_radps, about: hitch }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{Behaviour, InstanceId, ObjectClass, Pose, VehicleModelId, VehicleMotion, VehicleRef};
    use glam::Vec3;

    #[test]
    fn a_rolling_wheel_stands_on_the_road_and_its_top_is_twice_as_fast() {
        let car = Actor {
            id: InstanceId(1),
            rider_id: None,
            class: ObjectClass::Car,
            asset: VehicleRef { model: VehicleModelId(0), variant: 0 }.into(),
            pose: Pose::level(Vec3::new(5.0, 5.0, 0.0), 0.0),
            velocity_mps: Vec3::new(10.0, 0.0, 0.0),
            motion: Motion::Vehicle(VehicleMotion { speed_mps: 10.0, ..VehicleMotion::default() }),
            behaviour: Behaviour::default(),
            parked: false,
        };
        let wheel = of_wheel(of_body(&car, 2.6), Vec3A::new(6.3, 5.8, 0.3), Vec3A::Y, 10.0 / 0.3);
        assert!(wheel.at(Vec3A::new(6.3, 5.8, 0.0)).length() < 1e-4);
        assert!((wheel.at(Vec3A::new(6.3, 5.8, 0.6)) - Vec3A::X * 20.0).length() < 1e-4);
        // To the left, the inner side is the slower one.
        let bent = Actor {
            motion: Motion::Vehicle(VehicleMotion { speed_mps: 10.0, steer_rad: 0.3, ..VehicleMotion::default() }),
            ..car
        };
        let turning = of_body(&bent, 2.6);
        assert!(turning.at(Vec3A::new(5.0, 6.0, 0.0)).x < turning.at(Vec3A::new(5.0, 4.0, 0.0)).x);
    }
}
