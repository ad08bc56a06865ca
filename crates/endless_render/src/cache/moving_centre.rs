//! Pixels whose centre shows something that moves.

use crate::accel::{Hit, Ray};

/// A pixel whose centre shows something that moves.
pub(super) struct MovingCentre {
    /// Its place in the picture.
    pub(super) pixel: u32,
    /// Where its ray met that.
    pub(super) hit: Hit,
    /// From there to the sun, if shadows are wanted and it does not face away.
    pub(super) to_sun: Option<Ray>,
}
