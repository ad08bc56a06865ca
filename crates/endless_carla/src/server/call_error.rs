//! Why methods fail.

use crate::blueprint::AttributeError;
use crate::wire::WireError;

/// Why a method fails: the client is told.
#[derive(Debug, thiserror::Error)]
pub(super) enum CallError {
    /// An argument is none.
    #[error(transparent)]
    Argument(#[from] WireError),
    /// It cannot be done.
    #[error("{0}")]
    Refused(String),
}

impl CallError {
    pub(super) fn refused(text: impl Into<String>) -> Self {
        Self::Refused(text.into())
    }

    /// There is no such actor.
    pub(super) fn no_actor(id: u32) -> Self {
        Self::Refused(format!("actor {id} not found"))
    }
}

impl From<AttributeError> for CallError {
    fn from(error: AttributeError) -> Self {
        Self::refused(error.to_string())
    }
}
