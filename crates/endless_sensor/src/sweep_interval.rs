//! The interval in which a sensor sweeps over its surroundings.

use endless_world::SensorPose;
use glam::{DQuat, DVec3};

/// The interval that ends at a frame's instant, and how the sensor moves in it. The scene stands as it does at the end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepInterval {
    /// Where the sensor is as it begins.
    pub before: SensorPose,
    /// Where it is as it ends.
    pub now: SensorPose,
    /// How long it is, seconds; above 0.
    pub sweep_s: f64,
    /// Number of the frame: noise differs by it, and a head that does not come round in a sweep goes on from where it was.
    pub frame: u32,
}

impl SweepInterval {
    /// Of a sensor that stands.
    pub fn standing(pose: SensorPose, sweep_s: f64, frame: u32) -> Self {
        Self { before: pose, now: pose, sweep_s, frame }
    }

    /// Position and rotation (`world_from_sensor`) at a share of it, 0 to 1, at constant speed. The rotation is a normalised
    /// mean: off by less than 0.002 degrees if the sensor turns by ten.
    pub(crate) fn place_at(&self, share: f64) -> (DVec3, DQuat) {
        let (from, to) = (self.before.world_from_sensor, self.now.world_from_sensor);
        // Both signs are the same rotation: take the nearer.
        let to = if from.dot(to) < 0.0 { -to } else { to };
        let turn = (from * (1.0 - share) + to * share).normalize();
        (self.before.position + (self.now.position - self.before.position) * share, turn)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_lead_evenly_from_one_to_the_other() {
        let before = SensorPose::still(DVec3::new(1.0, 2.0, 3.0), DQuat::from_rotation_z(3.1));
        let now = SensorPose::still(DVec3::new(2.0, 2.0, 3.0), DQuat::from_rotation_z(3.1 + 10f64.to_radians()));
        let interval = SweepInterval { before, now, sweep_s: 0.1, frame: 0 };
        for share in [0.0, 0.2, 0.5, 0.9, 1.0] {
            let (position, turn) = interval.place_at(share);
            assert!((position - DVec3::new(1.0 + share, 2.0, 3.0)).length() < 1e-12);
            let expected = DQuat::from_rotation_z(3.1 + 10f64.to_radians() * share);
            assert!(turn.angle_between(expected).to_degrees() < 0.002, "{share}");
        }
    }
}
