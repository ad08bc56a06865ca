//! Stops of buses.

use crate::Side;
use glam::Vec3;

/// A stop of buses: its sign, or its shelter where there is no sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BusStop {
    /// Where it stands, metres.
    pub position: Vec3,
    /// The side of the lane on which it stands, as the driver sees it: right, where traffic keeps to the right.
    pub side: Side,
}
