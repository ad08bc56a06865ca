//! Errors of an export.

use endless_dataset::{DatasetError, Layer};
use std::path::PathBuf;

/// An export cannot be made, or failed.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// A file cannot be read or written.
    #[error(transparent)]
    Dataset(#[from] DatasetError),
    /// No video is complete yet.
    #[error("no video is complete yet: finish the dataset with the command that began it: {}", root.display())]
    NothingComplete {
        /// The dataset.
        root: PathBuf,
    },
    /// The format needs images that the dataset does not have.
    #[error(
        "{format} needs the layer {layer}, which {sequence} does not have: generate the dataset with --layers {wanted}"
    )]
    MissingLayer {
        /// The format's name.
        format: &'static str,
        /// The layer.
        layer: Layer,
        /// A camera without it.
        sequence: String,
        /// What to generate with.
        wanted: String,
    },
    /// The videos are not such that the format can tell of them.
    #[error("{format} cannot tell of {sequence}: {reason}")]
    Unfit {
        /// The format's name.
        format: &'static str,
        /// The camera.
        sequence: String,
        /// What is in the way.
        reason: String,
    },
    /// The parts cannot be had.
    #[error("{0}")]
    Split(String),
    /// The mapping of classes is not one.
    #[error("{reason}: {}", path.display())]
    Classes {
        /// What is wrong.
        reason: String,
        /// The file.
        path: PathBuf,
    },
    /// The folder to write to is taken.
    #[error("{reason}: {}", path.display())]
    Target {
        /// Why.
        reason: &'static str,
        /// The folder.
        path: PathBuf,
    },
}
