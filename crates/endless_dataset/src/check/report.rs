//! What a check finds.

use crate::{DatasetError, atomic::is_temporary, listing::list};
use std::{
    fmt,
    path::{Path, PathBuf},
};

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
            DatasetError::OtherFormat { found, expected, path } => {
                Self::new(path, format!("has format {found} instead of {expected}"))
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
    /// Adds what was looked at elsewhere.
    pub(super) fn merge(&mut self, other: Self) {
        self.images += other.images;
        self.boxes += other.boxes;
        self.findings.extend(other.findings);
    }
}

/// What lies in a folder and should not.
pub(super) fn strangers(folder: &Path, expected: &[String]) -> Vec<Finding> {
    let Ok(found) = list(folder) else {
        return vec![Finding::new(folder, "cannot be read")];
    };
    let stranger = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        !expected.iter().any(|e| *e == name)
    };
    let describe = |path: PathBuf| {
        let half = is_temporary(&path);
        let problem =
            if half { "is left from a killed run: run the same command again" } else { "does not belong here" };
        Finding::new(path, problem)
    };
    found.into_iter().filter(stranger).map(describe).collect()
}
