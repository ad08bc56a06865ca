//! What can go wrong.

use endless_dataset::DatasetError;
use std::path::PathBuf;

/// Statistics cannot be had. Messages end with the path and say what to do.
#[derive(Debug, thiserror::Error)]
pub enum StatisticsError {
    /// The folder holds no dataset.
    #[error("there is no dataset: give the folder that endless generate wrote: {}", path.display())]
    NoDataset {
        /// The folder.
        path: PathBuf,
    },
    /// No video of the dataset is complete.
    #[error("no video of it is complete: run endless generate on it again first: {}", path.display())]
    NoVideo {
        /// Its folder.
        path: PathBuf,
    },
    /// A file of the dataset is not what it should be.
    #[error("{0}")]
    Dataset(#[from] DatasetError),
    /// A file is no detection dataset in COCO form.
    #[error(
        "{reason}: give a file of detection labels in COCO form, with images, annotations and categories: {}",
        path.display()
    )]
    Coco {
        /// What is wrong with it.
        reason: String,
        /// The file.
        path: PathBuf,
    },
    /// A mapping of categories to classes cannot be used.
    #[error("{reason}: {}", path.display())]
    Classes {
        /// What is wrong with it, and what to write.
        reason: String,
        /// The file.
        path: PathBuf,
    },
}
