//! From this workspace's frames to CARLA's and back.
//!
//! Here: right-handed, x east, y north, z up, metres, radians, angles counter-clockwise. There: left-handed, y south, metres,
//! degrees, yaw clockwise. Pitch and roll have the same signs.

use crate::physics::Place;
use crate::wire::{Rotation, Transform, Vector3D};
use endless_world::math::f64::{asin, atan2};
use endless_world::{Pose, SensorPose, rotation_from_angles};
use glam::{DQuat, DVec3, Vec3};

/// A place or a direction of CARLA's in our frame.
pub(crate) fn from_carla(vector: &Vector3D) -> Vec3 {
    Vec3::new(vector.x, -vector.y, vector.z)
}

/// A place or a direction of ours in CARLA's frame.
pub(crate) fn to_carla(vector: Vec3) -> Vector3D {
    Vector3D { x: vector.x, y: -vector.y, z: vector.z }
}

/// An actor's pose.
pub(crate) fn pose(transform: &Transform) -> Pose {
    let Rotation { pitch, yaw, roll } = transform.rotation;
    Pose {
        position: from_carla(&transform.location),
        yaw_rad: -yaw.to_radians(),
        pitch_rad: pitch.to_radians(),
        roll_rad: roll.to_radians(),
    }
}

/// The transform of a pose.
pub(crate) fn transform(pose: &Pose) -> Transform {
    let rotation = Rotation {
        pitch: pose.pitch_rad.to_degrees(),
        yaw: above_minus_180(-pose.yaw_rad.to_degrees()),
        roll: pose.roll_rad.to_degrees(),
    };
    Transform { location: to_carla(pose.position), rotation }
}

/// A yaw, degrees: to the west it is 180, never -180.
fn above_minus_180(yaw: f32) -> f32 {
    if yaw > -180.0 { yaw } else { 180.0 }
}

/// An actor's place.
pub(crate) fn place(transform: &Transform) -> Place {
    let radians = |degrees: f32| f64::from(degrees).to_radians();
    let Rotation { pitch, yaw, roll } = transform.rotation;
    Place {
        position: from_carla(&transform.location).as_dvec3(),
        yaw_rad: -radians(yaw),
        pitch_rad: radians(pitch),
        roll_rad: radians(roll),
    }
}

/// The transform of a place.
pub(crate) fn transform_of(place: &Place) -> Transform {
    let degrees = |radians: f64| radians.to_degrees() as f32;
    let yaw = above_minus_180(-degrees(place.yaw_rad));
    let rotation = Rotation { pitch: degrees(place.pitch_rad), yaw, roll: degrees(place.roll_rad) };
    Transform { location: to_carla(place.position.as_vec3()), rotation }
}

/// An axis and a speed of turning (degrees a second there, radians here): to the left about it there, to the right here.
pub(crate) fn turn_from_carla(turn: &Vector3D) -> DVec3 {
    axis_from_carla(turn).map(f64::to_radians)
}

/// An axis of turning of any unit: what turns to the left about it there, turns to the right here.
pub(crate) fn axis_from_carla(axis: &Vector3D) -> DVec3 {
    DVec3::new(-f64::from(axis.x), f64::from(axis.y), -f64::from(axis.z))
}

/// The same the other way.
pub(crate) fn turn_to_carla(turn: DVec3) -> Vector3D {
    let degrees = |radians: f64| radians.to_degrees() as f32;
    Vector3D { x: -degrees(turn.x), y: degrees(turn.y), z: -degrees(turn.z) }
}

/// A sensor's pose: it stands still.
pub(crate) fn sensor_pose(transform: &Transform) -> SensorPose {
    SensorPose::still(from_carla(&transform.location).as_dvec3(), orientation(&transform.rotation))
}

/// The turn of a body in our frame.
pub(crate) fn orientation(rotation: &Rotation) -> DQuat {
    let radians = |degrees: f32| f64::from(degrees).to_radians();
    rotation_from_angles(-radians(rotation.yaw), radians(rotation.pitch), radians(rotation.roll))
}

/// Where something attached is, that has a place in the frame of whom it is attached to.
pub(crate) fn attached(parent: &Transform, own: &Transform) -> Transform {
    let world_from_parent = orientation(&parent.rotation);
    let offset = world_from_parent * from_carla(&own.location).as_dvec3();
    let place = from_carla(&parent.location).as_dvec3() + offset;
    Transform {
        location: to_carla(place.as_vec3()),
        rotation: rotation(world_from_parent * orientation(&own.rotation)),
    }
}

/// The other way: where something is in the frame of another, both of which have a place in the world.
pub(crate) fn detached(parent: &Transform, own: &Transform) -> Transform {
    let parent_from_world = orientation(&parent.rotation).inverse();
    let offset = from_carla(&own.location).as_dvec3() - from_carla(&parent.location).as_dvec3();
    Transform {
        location: to_carla((parent_from_world * offset).as_vec3()),
        rotation: rotation(parent_from_world * orientation(&own.rotation)),
    }
}

/// CARLA's angles of a turn.
pub(crate) fn rotation(turn: DQuat) -> Rotation {
    let (forward, left, up) = (turn * DVec3::X, turn * DVec3::Y, turn * DVec3::Z);
    let degrees = |radians: f64| radians.to_degrees() as f32;
    Rotation {
        pitch: degrees(asin(forward.z.clamp(-1.0, 1.0))),
        yaw: -degrees(atan2(forward.y, forward.x)),
        roll: degrees(atan2(left.z, up.z)),
    }
}

/// A pose that looks along a heading, nose up by a grade (rise over run).
pub(crate) fn heading(place: DVec3, heading_rad: f64, grade: f64) -> Transform {
    let rotation = Rotation {
        pitch: atan2(grade, 1.0).to_degrees() as f32,
        yaw: above_minus_180(yaw_deg(heading_rad) as f32),
        roll: 0.0,
    };
    Transform { location: to_carla(place.as_vec3()), rotation }
}

/// From -180 (not included) to 180 degrees.
fn yaw_deg(heading_rad: f64) -> f64 {
    let turned = (-heading_rad.to_degrees()).rem_euclid(360.0);
    if turned > 180.0 { turned - 360.0 } else { turned }
}

/// Whether all its numbers are numbers.
pub(crate) fn is_finite(transform: &Transform) -> bool {
    let Transform { location: l, rotation: r } = transform;
    [l.x, l.y, l.z, r.pitch, r.yaw, r.roll].iter().all(|number| number.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::Location;
    use proptest::prelude::*;
    use std::f64::consts::FRAC_PI_2;

    fn any_transform() -> impl Strategy<Value = Transform> {
        (prop::array::uniform3(-500.0f32..500.0), -80.0f32..80.0, -170.0f32..170.0, -80.0f32..80.0).prop_map(
            |([x, y, z], pitch, yaw, roll)| Transform {
                location: Location { x, y, z },
                rotation: Rotation { pitch, yaw, roll },
            },
        )
    }

    fn close(a: &Transform, b: &Transform) -> bool {
        let near = |a: f32, b: f32| (a - b).abs() < 2e-3;
        let (l, m, r, s) = (&a.location, &b.location, &a.rotation, &b.rotation);
        near(l.x, m.x)
            && near(l.y, m.y)
            && near(l.z, m.z)
            && near(r.pitch, s.pitch)
            && near(r.yaw, s.yaw)
            && near(r.roll, s.roll)
    }

    proptest! {
        #[test]
        fn there_and_back(there in any_transform(), other in any_transform()) {
            prop_assert!(close(&transform(&pose(&there)), &there));
            let turned = Transform { rotation: rotation(orientation(&there.rotation)), ..there.clone() };
            prop_assert!(close(&turned, &there));
            prop_assert!(close(&attached(&there, &Transform::default()), &there));
            prop_assert!(close(&attached(&Transform::default(), &there), &there));
            prop_assert!(close(&detached(&there, &attached(&there, &other)), &other));
        }
    }

    #[test]
    fn poses_and_orientations_agree() {
        let there =
            Transform { location: Location::default(), rotation: Rotation { pitch: 10.0, yaw: 35.0, roll: -20.0 } };
        let body = pose(&there).world_from_object();
        for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
            let other = orientation(&there.rotation).as_quat() * axis;
            assert!(body.transform_vector3(axis).distance(other) < 1e-5);
        }
        // Yaw is to the right, roll puts the right side down.
        let forward = orientation(&Rotation { pitch: 0.0, yaw: 90.0, roll: 0.0 }) * DVec3::X;
        assert!(forward.distance(DVec3::NEG_Y) < 1e-9);
        let right = orientation(&Rotation { pitch: 0.0, yaw: 0.0, roll: 30.0 }) * DVec3::NEG_Y;
        assert!(right.z < -0.4);
    }

    #[test]
    fn north_is_minus_y_and_up_a_hill_is_nose_up() {
        let pose = heading(DVec3::new(1.0, 2.0, 3.0), FRAC_PI_2, 0.1);
        assert_eq!(pose.location, Location { x: 1.0, y: -2.0, z: 3.0 });
        assert!((pose.rotation.yaw + 90.0).abs() < 1e-4 && (pose.rotation.pitch - 5.71).abs() < 0.01);
        assert_eq!(from_carla(&pose.location).as_dvec3(), DVec3::new(1.0, 2.0, 3.0));
        assert!((yaw_deg(-std::f64::consts::PI) - 180.0).abs() < 1e-9);
    }
}
