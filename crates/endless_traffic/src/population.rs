//! Numbers of actors.

/// Numbers of actors, requested and spawned.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Population {
    /// Moving vehicles requested.
    pub vehicles_asked: u32,
    /// Moving vehicles spawned.
    pub vehicles_spawned: u32,
    /// Moving vehicles for which this map has room.
    pub vehicle_capacity: u32,
    /// Pedestrians requested.
    pub pedestrians_asked: u32,
    /// Pedestrians spawned.
    pub pedestrians_spawned: u32,
}
