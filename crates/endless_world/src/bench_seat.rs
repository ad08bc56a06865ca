//! Seats of benches.

use glam::Vec3;

/// A place on a bench for one person.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BenchSeat {
    /// On the ground below who sits there, metres.
    pub position: Vec3,
    /// Where they look, counter-clockwise from east, radians.
    pub yaw_rad: f32,
}

impl BenchSeat {
    /// Of a bench's seat above the ground, metres.
    pub const HEIGHT_M: f32 = 0.465;
    /// Feet of who sits are so far ahead of them, over their stature.
    pub const FEET_AHEAD: f32 = 0.235;
}
