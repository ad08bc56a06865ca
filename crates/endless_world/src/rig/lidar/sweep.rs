//! What a LiDAR delivers.

use crate::{ClassTag, InstanceId};
use glam::Vec3;

/// A point that a LiDAR measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LidarPoint {
    /// In the sensor's frame (x forward, y left, z up) at the instant at which the point was measured, metres.
    pub position: Vec3,
    /// Strength of the echo, without its fall with the square of the distance, 0 to 1: a white surface that faces the sensor
    /// in clear air has 1, and so has what reflects more, such as traffic signs.
    pub intensity: f32,
    /// The beam that measured it, from 0, the lowest.
    pub channel: u16,
    /// Since the sweep began, seconds.
    pub time_s: f32,
    /// Class of what was hit; [`ClassTag::Unlabeled`] is a drop of rain or fog, and nothing else.
    pub tag: ClassTag,
    /// Object that was hit.
    pub id: InstanceId,
    /// Whether what was hit moves.
    pub moving: bool,
}

impl LidarPoint {
    /// Slower than this is standing, m/s.
    pub const MOVING_MPS: f32 = 0.1;

    /// Whether it is a drop of rain or fog.
    pub fn is_false_return(&self) -> bool {
        self.tag == ClassTag::Unlabeled
    }
}

/// The points of one sweep, in the order in which they were measured.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LidarSweep {
    /// Its points.
    pub points: Vec<LidarPoint>,
}
