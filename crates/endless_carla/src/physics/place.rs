//! Where a body is.

use super::sane::{vector, within};
use endless_world::math::f64::wrap_angle;
use glam::DVec3;

/// Nothing is farther from the origin, metres.
const FARTHEST_M: f64 = 1e6;

/// Where a body's origin (on the ground under its middle) is, and how it is turned: as [`endless_world::Pose`], in double
/// precision.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Place {
    /// In the world, metres.
    pub position: DVec3,
    /// Counter-clockwise from east, radians.
    pub yaw_rad: f64,
    /// Nose up is positive, radians.
    pub pitch_rad: f64,
    /// Left side up is positive, radians.
    pub roll_rad: f64,
}

impl Place {
    /// On level ground.
    pub fn level(position: DVec3, yaw_rad: f64) -> Self {
        Self { position, yaw_rad, ..Self::default() }
    }

    /// Without anything that is not finite, and not out of this world.
    pub(super) fn sane(self) -> Self {
        let angle = |angle: f64| wrap_angle(within(angle, -1e6, 1e6, 0.0));
        Self {
            position: vector(self.position, FARTHEST_M),
            yaw_rad: angle(self.yaw_rad),
            pitch_rad: angle(self.pitch_rad),
            roll_rad: angle(self.roll_rad),
        }
    }
}
