//! Findings of a check.

use crate::DatasetError;
use std::{fmt, path::PathBuf};

/// Something that is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// Where.
    pub path: PathBuf,
    /// What.
    pub problem: String,
}

impl Finding {
    pub(super) fn new(path: impl Into<PathBuf>, problem: impl Into<String>) -> Self {
        Self { path: path.into(), problem: problem.into() }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.path.display(), self.problem)
    }
}

impl From<DatasetError> for Finding {
    fn from(error: DatasetError) -> Self {
        match error {
            DatasetError::Io { action, path, cause } => Self::new(path, format!("{action} ({cause})")),
            DatasetError::Malformed { reason, path } => Self::new(path, reason),
            DatasetError::DiskFull { path } => Self::new(path, "the disk is full"),
            DatasetError::OtherFormat { found, oldest, expected, path } => {
                Self::new(path, format!("has format {found} instead of {oldest} to {expected}"))
            }
            DatasetError::Video { reason } => Self::new("", reason),
        }
    }
}

/// What was looked at, and what is wrong.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct CheckReport {
    /// Videos looked at.
    pub videos: usize,
    /// Images decoded.
    pub images: u64,
    /// Boxes compared with the instance images.
    pub boxes: u64,
    /// Everything that is wrong, by path.
    pub findings: Vec<Finding>,
}

impl CheckReport {
    /// Adds what was found in other videos.
    pub fn merge(&mut self, other: Self) {
        self.images += other.images;
        self.boxes += other.boxes;
        self.findings.extend(other.findings);
    }
}
