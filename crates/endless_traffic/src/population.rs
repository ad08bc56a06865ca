//! Numbers of actors.

/// Numbers of actors, requested and spawned.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Population {
    /// Moving vehicles requested.
    pub vehicles_asked: u32,
    /// Moving vehicles spawned.
    pub vehicles_spawned: u32,
    /// Moving vehicles with which traffic on this map still flows, at most.
    pub vehicle_capacity: u32,
    /// Pedestrians requested.
    pub pedestrians_asked: u32,
    /// Pedestrians spawned.
    pub pedestrians_spawned: u32,
}
