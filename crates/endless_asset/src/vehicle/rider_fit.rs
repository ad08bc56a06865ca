//! How somebody sits on a two-wheeler.

use glam::Vec3;

/// Where a rider touches a two-wheeler: left side, object frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RiderFit {
    /// Top of the seat; of the deck for who stands.
    pub(crate) seat: Vec3,
    /// Middle of the left grip.
    pub(crate) grip: Vec3,
    /// Sole of the left foot, under the ball.
    pub(crate) foot: Vec3,
    /// How much higher the right foot is (pedals) and further ahead.
    pub(crate) right_foot: Vec3,
    /// Forward lean of the trunk, radians.
    pub(crate) lean_rad: f32,
    /// How likely a helmet is worn.
    pub(crate) helmet: f64,
    /// Whether one stands on it.
    pub(crate) standing: bool,
}
