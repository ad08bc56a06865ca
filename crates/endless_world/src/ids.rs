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

/// Gives out the ids of a video's objects: 1, 2, 3 and so on.
///
/// ```
/// use endless_world::{InstanceId, InstanceIdAllocator};
///
/// let mut ids = InstanceIdAllocator::default();
/// assert_eq!(ids.allocate(), Ok(InstanceId(1)));
/// assert_eq!(ids.allocate_many(2), Ok(vec![InstanceId(2), InstanceId(3)]));
/// assert!(ids.allocate_many(70_000).is_err());
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct InstanceIdAllocator {
    last: u16,
}

impl InstanceIdAllocator {
    /// The next id.
    ///
    /// # Errors
    /// When all 65535 are given out.
    pub fn allocate(&mut self) -> Result<InstanceId, TooManyInstances> {
        self.last = self.last.checked_add(1).ok_or(TooManyInstances)?;
        Ok(InstanceId(self.last))
    }

    /// So many ids, ascending.
    ///
    /// # Errors
    /// When so many are not left.
    pub fn allocate_many(&mut self, count: usize) -> Result<Vec<InstanceId>, TooManyInstances> {
        (0..count).map(|_| self.allocate()).collect()
    }
}

/// A scene would hold more objects than instance images can tell apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TooManyInstances;

impl fmt::Display for TooManyInstances {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let most = u16::MAX;
        write!(f, "a scene holds at most {most} vehicles, riders and people, parked vehicles included: ask for fewer")
    }
}

impl std::error::Error for TooManyInstances {}

/// One signal group of a map: all heads that always show the same aspect. Index into [`crate::WorldState::signals`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct SignalId(pub u16);
