//! How a vehicle moves that has collided.

use glam::DVec2;

/// Below these a body rests, m/s and rad/s.
const RESTS: [f64; 2] = [0.03, 0.02];

/// How a body moves that follows no lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SlidingBody {
    /// m/s.
    pub(crate) velocity: DVec2,
    /// rad/s, to the left.
    pub(crate) yaw_rate: f64,
}

impl SlidingBody {
    pub(crate) fn rests(&self) -> bool {
        self.velocity.length() < RESTS[0] && self.yaw_rate.abs() < RESTS[1]
    }
}
