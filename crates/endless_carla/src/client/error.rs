//! What goes wrong between a client and its server.

use crate::rpc::DecodeError;
use crate::wire::WireError;
use endless_pipeline::SimulatorError;
use std::io;
use std::time::Duration;

/// Why a server did not do what it was asked.
#[derive(Debug, thiserror::Error)]
pub(super) enum ClientError {
    /// Nobody listens.
    #[error("nothing listens there ({0}): start CARLA, or `endless serve`, and run the same command")]
    Refused(io::Error),
    /// The connection broke.
    #[error("the connection broke: {0}")]
    Lost(io::Error),
    /// Nothing came in time.
    #[error("it did not {action} within {} s", limit.as_secs_f64())]
    Late {
        /// As in "load the map".
        action: &'static str,
        /// How long it was waited for.
        limit: Duration,
    },
    /// The server's own words.
    #[error("{method}: {text}")]
    Failed {
        /// What was called.
        method: &'static str,
        /// What it answered.
        text: String,
    },
    /// What came is not CARLA's protocol.
    #[error("it does not speak CARLA's protocol: {0}")]
    Protocol(String),
    /// Pictures and world do not fit each other.
    #[error("{0}")]
    Unfit(String),
    /// It is of another version, or lacks what is needed.
    #[error("{0}")]
    Unusable(String),
    /// The user wants to stop.
    #[error("stopped")]
    Interrupted,
}

impl ClientError {
    /// As all simulators say it.
    pub(super) fn at(self, address: &str) -> SimulatorError {
        let address = address.to_owned();
        match self {
            Self::Lost(source) => SimulatorError::ConnectionLost { address, source },
            Self::Late { action, limit } => SimulatorError::Timeout { action, limit },
            Self::Interrupted => SimulatorError::Interrupted,
            Self::Refused(_) | Self::Unfit(_) | Self::Protocol(_) => {
                SimulatorError::Remote { address, reason: self.to_string(), passing: true }
            }
            Self::Failed { .. } | Self::Unusable(_) => {
                SimulatorError::Remote { address, reason: self.to_string(), passing: false }
            }
        }
    }
}

impl From<WireError> for ClientError {
    fn from(error: WireError) -> Self {
        Self::Protocol(error.to_string())
    }
}

impl From<DecodeError> for ClientError {
    fn from(error: DecodeError) -> Self {
        match error {
            DecodeError::Io(error) => Self::Lost(error),
            other => Self::Protocol(other.to_string()),
        }
    }
}
