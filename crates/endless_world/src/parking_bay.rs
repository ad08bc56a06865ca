//! Bays at the kerb.

use glam::Vec3;

/// A place beside a lane for one vehicle that stands along the kerb, taken or free.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParkingBay {
    /// Its middle, on the ground, metres.
    pub position: Vec3,
    /// Heading of who parks there, as traffic beside it drives, counter-clockwise from east, radians.
    pub yaw_rad: f32,
    /// Along the kerb, metres.
    pub length_m: f32,
    /// Across, metres.
    pub width_m: f32,
}
