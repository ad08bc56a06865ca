//! A dataset in a bucket, made by way of a folder of work.

use crate::{
    address::StorageAddress,
    bucket::{Bucket, for_all},
    error::{Problem, StorageError},
    upload::upload,
    work_folder::{BUILDS, SCENE, WorkFolder, list, remove},
};
use endless_dataset::{Card, DatasetError, DatasetLayout, VideoLayout, write_atomic};
use endless_pipeline::{DatasetStore, StoreError, StoredFiles};
use std::{
    collections::BTreeSet,
    path::Path,
    sync::{Mutex, PoisonError},
    time::Duration,
};
use tokio::{
    runtime::{Builder, Runtime},
    task::JoinHandle,
};

/// One that runs.
type Upload = JoinHandle<Result<(), StoreError>>;

/// A dataset in a bucket.
#[derive(Debug)]
pub struct RemoteDataset {
    bucket: Bucket,
    work: WorkFolder,
    runtime: Runtime,
    /// The video that is being uploaded.
    uploading: Mutex<Option<(String, Upload)>>,
}

/// How a dataset in a bucket is made.
#[derive(Debug, Clone, Copy)]
pub struct RemoteSettings<'a> {
    /// The part of the dataset that this process makes, by a name that others do not have.
    pub part: Option<&'a str>,
    /// The folder of folders of work, instead of the platform's one for caches.
    pub work: Option<&'a Path>,
    /// How long a request is repeated that fails because of the server or the network.
    pub patience: Duration,
}

impl RemoteDataset {
    /// Nothing is asked of the server yet.
    ///
    /// # Errors
    /// When the settings in the environment cannot be, or there is no place for the work.
    pub fn new(address: &StorageAddress, settings: &RemoteSettings<'_>) -> Result<Self, StorageError> {
        let bucket = Bucket::open(address, settings.patience)?;
        let no_place = || Problem::Disk("this machine has no folder for caches: name one with --work-dir".to_owned());
        let work = WorkFolder::of(address, settings.part, settings.work);
        let work = work.ok_or_else(|| bucket.error("cannot begin", no_place(), ""))?;
        Self::of(bucket, work)
    }

    pub(crate) fn of(bucket: Bucket, work: WorkFolder) -> Result<Self, StorageError> {
        let runtime = runtime().map_err(|e| bucket.error("cannot begin", Problem::Disk(e), ""))?;
        Ok(Self { bucket, work, runtime, uploading: Mutex::new(None) })
    }

    /// The folder that the pipeline takes for the dataset.
    pub fn folder(&self) -> DatasetLayout {
        self.work.dataset()
    }

    /// Brings what there is of the plan.
    async fn fetch_plan(&self, layout: &DatasetLayout) -> Result<(), StoreError> {
        fetch(&self.bucket, "dataset.json", &layout.manifest()).await?;
        // The owner of a dataset may have taken over its cards.
        for name in Card::NAMES {
            fetch(&self.bucket, name, &layout.root().join(name)).await?;
        }
        let scenes = self.bucket.list("scenes").await?;
        for path in list(&layout.scenes())? {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            if !scenes.contains_key(&name) {
                remove(&path)?;
            }
        }
        for_all(scenes.into_keys(), |name| async move {
            fetch(&self.bucket, &format!("scenes/{name}"), &layout.scenes().join(&name)).await
        })
        .await?;
        Ok(())
    }

    /// Brings what tells of the videos that are there and unknown here.
    async fn fetch_videos(&self, layout: &DatasetLayout, there: BTreeSet<String>) -> Result<(), StoreError> {
        let unknown = there.into_iter().filter(|name| !layout.video_named(name).scene().is_file());
        for_all(unknown, |name| async move {
            let video = layout.video_named(&name);
            let Some(scene) = self.bucket.get(&format!("videos/{name}/{SCENE}")).await? else { return Ok(()) };
            fetch(&self.bucket, &format!("videos/{name}/{BUILDS}"), &video.folder().join(BUILDS)).await?;
            self.on_disk(write_atomic(&video.scene(), &scene))
        })
        .await?;
        Ok(())
    }

    fn on_disk(&self, done: Result<(), DatasetError>) -> Result<(), StorageError> {
        done.map_err(|e| self.bucket.error("cannot download", Problem::Disk(e.to_string()), ""))
    }

    /// Waits for the upload on its way. What failed is tried once more: it may have failed long ago.
    fn wait_for_upload(
        &self,
        uploading: &mut Option<(String, JoinHandle<Result<(), StoreError>>)>,
    ) -> Result<(), StoreError> {
        let Some((name, task)) = uploading.take() else { return Ok(()) };
        match self.runtime.block_on(task) {
            Ok(Ok(())) => Ok(()),
            Ok(Err(error)) => {
                if !self.work.outgoing(&name).exists() {
                    return Err(error);
                }
                tracing::warn!("an upload is tried once more: {error}");
                self.runtime.block_on(upload(&self.bucket, &self.work, &name))
            }
            Err(panic) => Err(StoreError::Store(panic.to_string().into())),
        }
    }
}

/// Two threads do: they wait for answers.
pub(crate) fn runtime() -> Result<Runtime, String> {
    Builder::new_multi_thread()
        .worker_threads(2)
        .enable_all()
        .build()
        .map_err(|e| format!("cannot start threads ({e})"))
}

/// Brings an object to a file; the file goes if there is no such object.
pub(crate) async fn fetch(bucket: &Bucket, name: &str, path: &Path) -> Result<(), StorageError> {
    let found = bucket.get(name).await?;
    let done = match found {
        Some(bytes) => path
            .parent()
            .map_or(Ok(()), std::fs::create_dir_all)
            .map_err(|e| DatasetError::io("cannot make the folder", path, e))
            .and_then(|()| write_atomic(path, &bytes)),
        None => remove(path),
    };
    done.map_err(|e| bucket.error("cannot download", Problem::Disk(e.to_string()), name))
}

impl DatasetStore for RemoteDataset {
    fn open(&self, layout: &DatasetLayout) -> Result<(), StoreError> {
        self.runtime.block_on(async {
            self.bucket.knock().await?;
            for name in self.work.left()? {
                upload(&self.bucket, &self.work, &name).await?;
            }
            self.fetch_plan(layout).await?;
            let there = self.bucket.folders("videos").await?;
            // Here all is asked anew: the bucket may have been changed by others.
            for folder in list(&layout.videos())? {
                let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
                let video = layout.video_named(&name);
                let in_work = list(&folder)?.iter().any(|path| !path.ends_with(BUILDS) && !path.ends_with(SCENE));
                if in_work { remove(&video.scene())? } else { remove(&folder)? }
            }
            self.fetch_videos(layout, there).await
        })
    }

    fn refresh(&self, layout: &DatasetLayout) -> Result<(), StoreError> {
        self.runtime.block_on(async {
            let there = self.bucket.folders("videos").await?;
            self.fetch_videos(layout, there).await
        })
    }

    fn files(&self, video: &VideoLayout) -> Result<StoredFiles, StoreError> {
        let name = video.folder().file_name().unwrap_or_default().to_string_lossy();
        Ok(self.runtime.block_on(self.bucket.list(&format!("videos/{name}")))?.into_keys().collect())
    }

    fn put_scenes(&self, layout: &DatasetLayout) -> Result<(), StoreError> {
        self.runtime.block_on(async {
            let there = self.bucket.list("scenes").await?;
            let here = list(&layout.scenes())?.into_iter();
            let named = here.filter_map(|path| Some((path.file_name()?.to_str()?.to_owned(), path)));
            let missing = named.filter(|(name, _)| !name.starts_with('.') && !there.contains_key(name));
            for_all(
                missing,
                |(name, path)| async move { self.bucket.put_file(&format!("scenes/{name}"), &path).await },
            )
            .await?;
            Ok(())
        })
    }

    fn reopen_video(&self, video: &VideoLayout) -> Result<(), StoreError> {
        let name = video.folder().file_name().unwrap_or_default().to_string_lossy();
        Ok(self.runtime.block_on(self.bucket.remove(&format!("videos/{name}/{SCENE}")))?)
    }

    fn put_video(&self, video: &VideoLayout) -> Result<(), StoreError> {
        let name = video.folder().file_name().unwrap_or_default().to_string_lossy().into_owned();
        let mut uploading = self.uploading.lock().unwrap_or_else(PoisonError::into_inner);
        // First of all: if the one before fails, this one is not lost.
        self.work.take(&name)?;
        self.wait_for_upload(&mut uploading)?;
        let (bucket, work) = (self.bucket.clone(), self.work.clone());
        let task = {
            let name = name.clone();
            self.runtime.spawn(async move { upload(&bucket, &work, &name).await })
        };
        *uploading = Some((name, task));
        Ok(())
    }

    fn wait(&self) -> Result<(), StoreError> {
        self.wait_for_upload(&mut self.uploading.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn put_index(&self, layout: &DatasetLayout) -> Result<(), StoreError> {
        let paths = list(layout.root())?;
        let named = paths.iter().filter_map(|path| Some((path.file_name()?.to_str()?, path)));
        let mut files: Vec<_> = named.filter(|(name, path)| !name.starts_with('.') && path.is_file()).collect();
        files.sort_by_key(|(name, _)| *name == "dataset.json");
        self.runtime.block_on(async {
            for (name, path) in files {
                self.bucket.put_file(name, path).await?;
            }
            Ok(())
        })
    }

    fn close(&self, _layout: &DatasetLayout) -> Result<(), StoreError> {
        Ok(self.work.clear()?)
    }

    fn videos_at_a_time(&self) -> Option<usize> {
        // One is uploaded while the next is recorded.
        Some(2)
    }
}

impl Drop for RemoteDataset {
    fn drop(&mut self) {
        self.work.remove_if_empty();
    }
}
