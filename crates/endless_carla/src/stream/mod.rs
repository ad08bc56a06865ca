//! CARLA's streams: what sensors measure, and snapshots of the world. A client connects once a stream, sends its number, and
//! is sent messages, each after its length.

mod hub;
mod image;
mod listener;
mod message;
mod read_snapshot;
mod session;
mod snapshot;
mod token;

pub use hub::{Delivery, StreamHub};
pub use image::{image_header, image_message};
pub use listener::listen_for_sessions;
pub use message::{SensorHeader, WORLD_OBSERVER};
pub use read_snapshot::{RecordKind, read_snapshot};
pub use snapshot::{ActorRecord, ActorRecordState, EpisodeHeader, LightRecord, VehicleRecord, WalkerRecord, snapshot};
pub use token::Token;
