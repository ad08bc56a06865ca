//! Why a server cannot run.

use endless_interchange::MapError;
use std::io;
use std::net::SocketAddr;

/// Why a server cannot run.
#[derive(Debug, thiserror::Error)]
pub enum ServerError {
    /// A port is taken, or forbidden.
    #[error("cannot listen at {address}: {source}; choose another port with --port")]
    Listen {
        /// Where.
        address: SocketAddr,
        /// Why.
        source: io::Error,
    },
    /// There is no such map, or it is damaged.
    #[error(transparent)]
    Map(#[from] MapError),
    /// It has more parts than can be told apart.
    #[error("map '{map}' cannot be shown: {reason}")]
    Scene {
        /// The map.
        map: String,
        /// Why.
        reason: String,
    },
    /// The system gives no thread.
    #[error("cannot start a thread: {0}")]
    Thread(io::Error),
}
