//! Where a sensor is at an instant, and how it moves.

use super::rotation_from_vector;
use glam::{DQuat, DVec3};

/// Where a sensor is at an instant, and how it moves: its body frame (x forward, y left, z up) in the world, in double
/// precision, because accelerations are differences of differences.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SensorPose {
    /// Of the sensor's origin in the world, metres.
    pub position: DVec3,
    /// Turns directions of the sensor's body frame into the world; a unit quaternion.
    pub world_from_sensor: DQuat,
    /// Of the sensor's origin in the world, m/s.
    pub velocity_mps: DVec3,
    /// World frame, radians a second.
    pub angular_velocity_radps: DVec3,
}

impl SensorPose {
    /// At rest.
    pub fn still(position: DVec3, world_from_sensor: DQuat) -> Self {
        Self { position, world_from_sensor, velocity_mps: DVec3::ZERO, angular_velocity_radps: DVec3::ZERO }
    }

    /// Where it was so many seconds ago, had it moved as it does now all the time.
    #[must_use]
    pub fn earlier(&self, seconds: f64) -> Self {
        let turned = rotation_from_vector(self.angular_velocity_radps * -seconds);
        Self {
            position: self.position - self.velocity_mps * seconds,
            world_from_sensor: turned * self.world_from_sensor,
            ..*self
        }
    }

    /// A point of the sensor's body frame in the world, metres.
    pub fn world_from_sensor_point(&self, point: DVec3) -> DVec3 {
        self.position + self.world_from_sensor * point
    }

    /// A point of the world in the sensor's body frame, metres.
    pub fn sensor_from_world_point(&self, point: DVec3) -> DVec3 {
        self.world_from_sensor.conjugate() * (point - self.position)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_go_there_and_back() {
        let pose =
            SensorPose::still(DVec3::new(120.0, -4.0, 1.7), DQuat::from_rotation_z(0.7) * DQuat::from_rotation_y(0.2));
        let point = DVec3::new(3.0, -8.0, 0.5);
        let back = pose.sensor_from_world_point(pose.world_from_sensor_point(point));
        assert!((back - point).length() < 1e-12);
        // Nose down: what is ahead lies below.
        assert!(pose.world_from_sensor_point(DVec3::X).z < pose.position.z);
    }
}
