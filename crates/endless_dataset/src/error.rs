//! Errors of reading and writing files.

use std::{fmt::Display, io, path::PathBuf};

/// Reading or writing a file failed. Messages end with the path.
#[derive(Debug, thiserror::Error)]
pub enum DatasetError {
    /// The disk is full.
    #[error("the disk is full: make room and run the same command again, which resumes it: {}", path.display())]
    DiskFull {
        /// What was being written.
        path: PathBuf,
    },
    /// The operating system refused.
    #[error("{action}: {cause}: {}", path.display())]
    Io {
        /// What was tried, e.g. "cannot write".
        action: &'static str,
        /// Where.
        path: PathBuf,
        /// Why not.
        cause: io::Error,
    },
    /// The file is there but is not what it should be.
    #[error("{reason}: {}", path.display())]
    Malformed {
        /// What is wrong with it.
        reason: String,
        /// Which file.
        path: PathBuf,
    },
    /// A dataset of another format.
    #[error(
        "the dataset has format {found}, this program reads {oldest} to {expected}: use the program that made it: {}",
        path.display()
    )]
    OtherFormat {
        /// Its format.
        found: u32,
        /// The oldest that this program reads.
        oldest: u32,
        /// That of this program.
        expected: u32,
        /// Its `dataset.json`.
        path: PathBuf,
    },
    /// The video encoder refused a picture.
    #[error("cannot encode the video: {reason}")]
    Video {
        /// What it said.
        reason: String,
    },
}

impl DatasetError {
    /// A failure of the operating system.
    pub fn io(action: &'static str, path: impl Into<PathBuf>, cause: io::Error) -> Self {
        let path = path.into();
        if matches!(cause.kind(), io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded) {
            return Self::DiskFull { path };
        }
        Self::Io { action, path, cause }
    }

    /// A file that is not what it should be.
    pub fn malformed(path: impl Into<PathBuf>, reason: impl Display) -> Self {
        Self::Malformed { reason: reason.to_string(), path: path.into() }
    }
}
