//! Newtyped ids.

use serde::{Deserialize, Serialize};
use std::fmt;

/// One annotated object within one video: the same in all cameras and all frames. `0` is "stuff" (no object).
///
/// 16 bits, because CARLA's instance image has two channels for it: `id = G + 256 B`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
#[serde(transparent)]
pub struct InstanceId(pub u16);

impl InstanceId {
    /// The id of everything that is not an annotated object: road, buildings, sky.
    pub const STUFF: Self = Self(0);
}

impl fmt::Display for InstanceId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

/// One signal group of a map: all heads that always show the same aspect. Index into [`crate::WorldState::signals`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct SignalId(pub u16);
