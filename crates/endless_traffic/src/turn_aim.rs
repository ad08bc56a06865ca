//! Where a driver wants to go at the next junction.

use endless_road::{JunctionId, Turn};

/// A turn to take at a junction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Aim {
    pub(crate) junction: JunctionId,
    pub(crate) turn: Turn,
}
