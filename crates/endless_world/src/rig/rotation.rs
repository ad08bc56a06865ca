//! Rotations in double precision: angles, rotation vectors and unit quaternions.

use crate::math::f64::{atan2, sin_cos};
use glam::{DQuat, DVec3};

/// The turn by yaw, then pitch, then roll, as [`crate::Pose`] has them (yaw to the left, nose up, left side up; radians):
/// directions of the body in the frame in which the angles are told.
pub fn rotation_from_angles(yaw_rad: f64, pitch_rad: f64, roll_rad: f64) -> DQuat {
    let about = |axis: DVec3, angle_rad: f64| {
        let (sin, cos) = sin_cos(0.5 * angle_rad);
        let v = axis * sin;
        DQuat::from_xyzw(v.x, v.y, v.z, cos)
    };
    about(DVec3::Z, yaw_rad) * about(DVec3::Y, -pitch_rad) * about(DVec3::X, roll_rad)
}

/// The rotation vector of a unit quaternion: along its axis, as long as its angle, which is at most π.
pub fn rotation_vector(rotation: DQuat) -> DVec3 {
    let rotation = if rotation.w < 0.0 { -rotation } else { rotation };
    let v = DVec3::new(rotation.x, rotation.y, rotation.z);
    let sin = v.length();
    // Of tiny angles the ratio of the angle to the sine is 2, to rounding.
    if sin < 1e-9 { 2.0 * v } else { v * (2.0 * atan2(sin, rotation.w) / sin) }
}

/// The unit quaternion of a rotation vector: the exponential map.
pub fn rotation_from_vector(vector: DVec3) -> DQuat {
    let angle_rad = vector.length();
    let (sin, cos) = sin_cos(0.5 * angle_rad);
    let v = vector * if angle_rad < 1e-9 { 0.5 } else { sin / angle_rad };
    DQuat::from_xyzw(v.x, v.y, v.z, cos)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Pose;
    use glam::Vec3;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn angles_are_those_of_poses(yaw in -3.1..3.1f32, pitch in -0.6..0.6f32, roll in -0.6..0.6f32) {
            let pose = Pose { position: Vec3::ZERO, yaw_rad: yaw, pitch_rad: pitch, roll_rad: roll };
            let rotation = rotation_from_angles(yaw.into(), pitch.into(), roll.into());
            prop_assert!((rotation.length() - 1.0).abs() < 1e-12);
            for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
                let there = pose.world_from_object().transform_vector3(axis.as_vec3()).as_dvec3();
                prop_assert!((rotation * axis - there).length() < 1e-6);
            }
        }

        #[test]
        fn vectors_and_quaternions_are_the_same_turns(x in -1.7..1.7f64, y in -1.7..1.7f64, z in -1.7..1.7f64, scale in 0..3) {
            let vector = DVec3::new(x, y, z) * [1.0, 1e-5, 1e-12][scale as usize];
            let rotation = rotation_from_vector(vector);
            prop_assert!((rotation_vector(rotation) - vector).length() < 1e-12 + 1e-12 * vector.length());
            prop_assert!((rotation_vector(-rotation) - vector).length() < 1e-12 + 1e-12 * vector.length());
        }
    }
}
