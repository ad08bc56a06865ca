//! Datasets in object storage: S3, Google Cloud Storage, Azure.
//!
//! A [`DatasetAddress`] is a folder or a place in a bucket. `RemoteDataset` keeps the dataset of
//! `endless_pipeline::generate_into` there: each video is recorded in a folder of work and moves to the
//! bucket when it is complete, while the next one is recorded. `RemoteReader` brings a dataset back, a video at a time.
//! Without the feature `cloud` there are addresses alone.

mod address;
#[cfg(feature = "cloud")]
mod bucket;
#[cfg(feature = "cloud")]
mod connect;
#[cfg(feature = "cloud")]
mod dataset;
#[cfg(feature = "cloud")]
mod download;
#[cfg(feature = "cloud")]
mod error;
#[cfg(all(test, feature = "cloud"))]
mod tests;
#[cfg(feature = "cloud")]
mod upload;
#[cfg(feature = "cloud")]
mod work_folder;

pub use address::{AddressError, DatasetAddress, Provider, StorageAddress};
#[cfg(feature = "cloud")]
pub use {
    dataset::{RemoteDataset, RemoteSettings},
    download::RemoteReader,
    error::{Problem, StorageError},
};
