//! From this workspace's frame (x east, y north, z up; angles counter-clockwise, radians) to CARLA's (x east, y south, z up;
//! yaw clockwise, degrees) and back.

use crate::wire::{Location, Rotation, Transform};
use endless_world::math::f64::atan2;
use glam::DVec3;

/// A place.
pub(super) fn location(world: DVec3) -> Location {
    Location { x: world.x as f32, y: -world.y as f32, z: world.z as f32 }
}

/// A place on the wire, in the world.
pub(super) fn world(location: &Location) -> DVec3 {
    DVec3::new(f64::from(location.x), -f64::from(location.y), f64::from(location.z))
}

/// A pose that looks along a heading, nose up by a grade (rise over run).
pub(super) fn transform(place: DVec3, heading_rad: f64, grade: f64) -> Transform {
    let rotation =
        Rotation { pitch: atan2(grade, 1.0).to_degrees() as f32, yaw: yaw_deg(heading_rad) as f32, roll: 0.0 };
    Transform { location: location(place), rotation }
}

/// From -180 (not included) to 180 degrees.
fn yaw_deg(heading_rad: f64) -> f64 {
    let turned = (-heading_rad.to_degrees()).rem_euclid(360.0);
    if turned > 180.0 { turned - 360.0 } else { turned }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn north_is_minus_y_and_up_a_hill_is_nose_up() {
        let pose = transform(DVec3::new(1.0, 2.0, 3.0), FRAC_PI_2, 0.1);
        assert_eq!(pose.location, Location { x: 1.0, y: -2.0, z: 3.0 });
        assert!((pose.rotation.yaw + 90.0).abs() < 1e-4 && (pose.rotation.pitch - 5.71).abs() < 0.01);
        assert_eq!(world(&pose.location), DVec3::new(1.0, 2.0, 3.0));
        assert!((yaw_deg(-std::f64::consts::PI) - 180.0).abs() < 1e-9);
    }
}
