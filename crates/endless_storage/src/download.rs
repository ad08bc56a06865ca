//! A dataset in a bucket comes to a folder, a video at a time.

use crate::{
    address::StorageAddress,
    bucket::{Bucket, for_all},
    dataset::{fetch, runtime},
    error::{Problem, StorageError},
};
use std::{fs, path::Path, time::Duration};
use tokio::runtime::Runtime;

/// Reads a dataset in a bucket.
#[derive(Debug)]
pub struct RemoteReader {
    bucket: Bucket,
    runtime: Runtime,
}

impl RemoteReader {
    /// Asks whether the server answers. A request that fails because of server or network is repeated for so long.
    ///
    /// # Errors
    /// When the settings in the environment cannot be, or the server refuses.
    pub fn open(address: &StorageAddress, patience: Duration) -> Result<Self, StorageError> {
        let bucket = Bucket::open(address, patience)?;
        let runtime = runtime().map_err(|e| bucket.error("cannot begin", Problem::Disk(e), ""))?;
        runtime.block_on(bucket.knock())?;
        Ok(Self { bucket, runtime })
    }

    /// Brings `dataset.json` and the settings of scenes to a folder, and makes an empty folder for each video.
    ///
    /// # Errors
    /// When there is no dataset, or the server or the disk refuses.
    pub fn index(&self, root: &Path) -> Result<(), StorageError> {
        self.runtime.block_on(async {
            fetch(&self.bucket, "dataset.json", &root.join("dataset.json")).await?;
            if !root.join("dataset.json").is_file() {
                return Err(self.bucket.error("cannot read", Problem::NoObject, "dataset.json"));
            }
            self.folder(root, "scenes").await?;
            for name in self.bucket.folders("videos").await? {
                let made = fs::create_dir_all(root.join("videos").join(&name));
                made.map_err(|e| self.bucket.error("cannot download", Problem::Disk(e.to_string()), &name))?;
            }
            Ok(())
        })
    }

    /// Brings all files of a video.
    ///
    /// # Errors
    /// When the server or the disk refuses.
    pub fn video(&self, root: &Path, name: &str) -> Result<(), StorageError> {
        self.runtime.block_on(self.folder(root, &format!("videos/{name}")))
    }

    async fn folder(&self, root: &Path, folder: &str) -> Result<(), StorageError> {
        let there = self.bucket.list(folder).await?;
        for_all(there.into_keys(), |name| async move {
            let name = format!("{folder}/{name}");
            fetch(&self.bucket, &name, &root.join(&name)).await
        })
        .await
    }
}
