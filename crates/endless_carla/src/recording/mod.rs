//! CARLA's recordings: the binary file format of its recorder, and what CARLA tells of such a file.
//!
//! A file is little-endian: version (u16), `CARLA_RECORDER` and the map as strings with the time (i64, seconds of Unix) between
//! them, then packets, each of a number (u8), a size (u32) and that many bytes. Strings have their length (u16) before them.
//! Lengths are centimetres, angles degrees (roll, pitch, yaw) and axes CARLA's, but velocities, which are metres a second. Packets
//! of other numbers than ours are passed over.

mod blocked;
mod bytes;
mod collisions;
mod date;
mod file_info;
mod log_reader;
mod number;
mod packet;
mod physics_record;
mod record;

pub use blocked::blocked_actors;
pub use bytes::RecordingError;
pub use collisions::collisions;
pub use file_info::file_info;
pub use log_reader::{LogHeader, LogReader, is_recording};
pub use packet::Packet;
pub use physics_record::RecordedPhysics;
pub use record::{
    FrameStart, RecordedActor, RecordedActorType, RecordedAttribute, RecordedBox, RecordedCollision,
    RecordedKinematics, RecordedLightState, RecordedLightTimes, RecordedParent, RecordedPosition, RecordedSceneLight,
    RecordedVehicle, RecordedVehicleLights, RecordedWalker,
};

#[cfg(test)]
mod tests;
