//! The velocity of a rigid body at an instant.

use endless_world::math::UnfusedVec3A;
use glam::Vec3A;

/// A rigid motion at one instant: a velocity, and a turn about a point. World frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidVelocity {
    /// Velocity of the point `about`, m/s.
    pub linear_mps: Vec3A,
    /// About each axis, radians a second.
    pub angular_radps: Vec3A,
    /// A point of the piece, or one that moves with it, metres.
    pub about: Vec3A,
}

impl RigidVelocity {
    /// Standing still.
    pub const ZERO: Self = Self { linear_mps: Vec3A::ZERO, angular_radps: Vec3A::ZERO, about: Vec3A::ZERO };

    /// Velocity of a point of the body, m/s.
    pub fn at(&self, point: Vec3A) -> Vec3A {
        self.linear_mps + self.angular_radps.cross_unfused(point - self.about)
    }
}
