//! Actors in pictures.

use endless_world::InstanceId;

/// An actor's number in pictures and point clouds: the last 16 bits of its own.
pub(crate) fn instance_id(actor: u32) -> InstanceId {
    InstanceId((actor & 0xffff) as u16)
}
