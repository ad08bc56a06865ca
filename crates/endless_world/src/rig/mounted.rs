//! Sensors that somebody carries.

use super::rotation::{rotation_from_angles, rotation_vector};
use crate::{Actor, Pose, SensorPose};
use glam::{DQuat, DVec3};

/// Where a sensor is that an actor carries: at a place of its object frame (x forward, y left, z up from the ground under
/// its middle, metres), turned by yaw, pitch and roll against it (to the left, nose up, left side up; radians).
///
/// Actors tell no angular velocity: it follows from `near`, the same actor at an instant this many seconds later (negative:
/// earlier); without it, it is 0. The velocity is that of the actor, and of the turn at the end of the lever arm.
pub fn carried(actor: &Actor, at: [f64; 3], turned_rad: [f64; 3], near: Option<(&Actor, f64)>) -> SensorPose {
    let [yaw, pitch, roll] = turned_rad;
    let rotation = world_from_object(&actor.pose);
    let lever = rotation * DVec3::from_array(at);
    let angular_velocity_radps = near.filter(|(_, later_s)| *later_s != 0.0).map_or(DVec3::ZERO, |(near, later_s)| {
        rotation_vector(world_from_object(&near.pose) * rotation.conjugate()) / later_s
    });
    SensorPose {
        position: actor.pose.position.as_dvec3() + lever,
        world_from_sensor: rotation * rotation_from_angles(yaw, pitch, roll),
        velocity_mps: actor.velocity_mps.as_dvec3() + angular_velocity_radps.cross(lever),
        angular_velocity_radps,
    }
}

/// The same pose, moving so that it comes to the next one in this time: with the velocities that an inertial sensor should
/// begin with, because those of actors are rounded, and in bends are those of the way that they follow.
#[must_use]
pub fn moving_to(pose: &SensorPose, next: &SensorPose, seconds: f64) -> SensorPose {
    SensorPose {
        velocity_mps: (next.position - pose.position) / seconds,
        angular_velocity_radps: rotation_vector(next.world_from_sensor * pose.world_from_sensor.conjugate()) / seconds,
        ..*pose
    }
}

fn world_from_object(pose: &Pose) -> DQuat {
    rotation_from_angles(pose.yaw_rad.into(), pose.pitch_rad.into(), pose.roll_rad.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Behaviour, InstanceId, Motion, ObjectClass, VehicleModelId, VehicleMotion, VehicleRef};
    use glam::Vec3;
    use proptest::prelude::*;

    fn actor(pose: Pose, velocity_mps: Vec3) -> Actor {
        Actor {
            id: InstanceId(1),
            rider_id: None,
            class: ObjectClass::Car,
            asset: VehicleRef { model: VehicleModelId(0), variant: 0 }.into(),
            pose,
            velocity_mps,
            motion: Motion::Vehicle(VehicleMotion::default()),
            behaviour: Behaviour::default(),
            parked: false,
        }
    }

    proptest! {
        #[test]
        fn it_is_where_the_body_carries_it(
            x in -300.0..300.0f32, y in -300.0..300.0f32, yaw in -3.1..3.1f32, pitch in -0.3..0.3f32, roll in -0.5..0.5f32,
            at in [-3.0..3.0f64, -1.0..1.0f64, 0.0..2.5f64],
        ) {
            let pose = Pose { position: Vec3::new(x, y, 1.0), yaw_rad: yaw, pitch_rad: pitch, roll_rad: roll };
            let sensor = carried(&actor(pose, Vec3::ZERO), at, [0.3, -0.1, 0.05], None);
            let expected = pose.world_from_object().transform_point3(DVec3::from_array(at).as_vec3()).as_dvec3();
            prop_assert!((sensor.position - expected).length() < 1e-4);
            let turned = Pose { position: Vec3::ZERO, yaw_rad: 0.3, pitch_rad: -0.1, roll_rad: 0.05 };
            let ahead = pose.world_from_object().transform_vector3(turned.world_from_object().transform_vector3(Vec3::X));
            prop_assert!((sensor.world_from_sensor * DVec3::X - ahead.as_dvec3()).length() < 1e-5);
        }
    }

    #[test]
    fn what_turns_carries_its_front_sideways() {
        // Half a radian a second to the left: the front bumper, 2 m ahead, goes 1 m/s to the left.
        let now = actor(Pose::level(Vec3::ZERO, 0.0), Vec3::new(5.0, 0.0, 0.0));
        let before = actor(Pose::level(Vec3::new(-0.5, 0.0, 0.0), -0.05), Vec3::new(5.0, 0.0, 0.0));
        let front = carried(&now, [2.0, 0.0, 0.5], [0.0; 3], Some((&before, -0.1)));
        assert!((front.angular_velocity_radps - DVec3::new(0.0, 0.0, 0.5)).length() < 1e-6);
        assert!((front.velocity_mps - DVec3::new(5.0, 1.0, 0.0)).length() < 1e-6);
        let was = carried(&before, [2.0, 0.0, 0.5], [0.0; 3], None);
        let moving = moving_to(&was, &front, 0.1);
        assert!((was.position + 0.1 * moving.velocity_mps - front.position).length() < 1e-12);
        assert!((moving.angular_velocity_radps - front.angular_velocity_radps).length() < 1e-6);
    }
}
