//! The side of the road on which traffic drives.

use serde::{Deserialize, Serialize};

/// The side of the road on which traffic drives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum DrivingSide {
    /// As in Britain, India, Japan.
    Left,
    /// As in most countries.
    Right,
}

impl DrivingSide {
    /// `left` or `right`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }
}
