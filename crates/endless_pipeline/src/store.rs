//! Where a dataset is kept, which need not be the folder in which its videos are recorded.

use endless_dataset::{DatasetError, DatasetLayout, VideoLayout};
use std::{collections::BTreeSet, error::Error, fmt, fs, io, path::Path};

/// Keeps a dataset.
///
/// A run records each video in a folder, the layout that all calls get. A store that is elsewhere takes each video from there
/// when it is complete, and leaves `builds.json` and `scene.json` of what it keeps, so that the folder tells of the whole
/// dataset, as if it lay there.
pub trait DatasetStore: Sync + fmt::Debug {
    /// Before a run: puts there what a killed run was about to put, and brings to the folder what there is of
    /// `dataset.json`, of `scenes` and of each video's `builds.json` and `scene.json`. What is not there any more goes from the folder, too.
    ///
    /// # Errors
    /// When the store or the disk refuses.
    fn open(&self, layout: &DatasetLayout) -> Result<(), StoreError>;

    /// Brings `builds.json` and `scene.json` of videos that have come since.
    ///
    /// # Errors
    /// When the store or the disk refuses.
    fn refresh(&self, layout: &DatasetLayout) -> Result<(), StoreError>;

    /// The files of a video that are kept.
    ///
    /// # Errors
    /// When the store or the disk refuses.
    fn files(&self, video: &VideoLayout) -> Result<StoredFiles, StoreError>;

    /// Takes over the settings of scenes.
    ///
    /// # Errors
    /// When the store refuses.
    fn put_scenes(&self, layout: &DatasetLayout) -> Result<(), StoreError>;

    /// A video that is said to be complete has lost files: takes back what says so.
    ///
    /// # Errors
    /// When the store refuses.
    fn reopen_video(&self, video: &VideoLayout) -> Result<(), StoreError>;

    /// Takes over a video that is complete, perhaps while others are recorded. `scene.json` comes last.
    ///
    /// # Errors
    /// When the store refuses this video or one before it. Nothing is lost then: [`Self::open`] goes on with it.
    fn put_video(&self, video: &VideoLayout) -> Result<(), StoreError>;

    /// Waits until all videos that were taken over are there.
    ///
    /// # Errors
    /// When the store refuses one.
    fn wait(&self) -> Result<(), StoreError>;

    /// Takes over `dataset.json` and what else lies beside it.
    ///
    /// # Errors
    /// When the store refuses.
    fn put_index(&self, layout: &DatasetLayout) -> Result<(), StoreError>;

    /// After a run that did all it should: removes what was for work alone.
    ///
    /// # Errors
    /// When the disk refuses.
    fn close(&self, layout: &DatasetLayout) -> Result<(), StoreError>;

    /// How many videos may lie in the folder at a time; all where there is no bound.
    fn videos_at_a_time(&self) -> Option<usize>;
}

/// A store that refuses. Messages are one line that says what to do.
#[derive(Debug, thiserror::Error)]
pub enum StoreError {
    /// A file in the folder of work.
    #[error(transparent)]
    Dataset(#[from] DatasetError),
    /// The store itself.
    #[error(transparent)]
    Store(Box<dyn Error + Send + Sync>),
}

/// Files of a video, by their path below its folder, with `/` between its parts.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct StoredFiles {
    names: BTreeSet<String>,
}

impl StoredFiles {
    /// Those that lie in a folder.
    ///
    /// # Errors
    /// When it cannot be read.
    pub fn in_folder(folder: &Path) -> Result<Self, DatasetError> {
        let mut names = BTreeSet::new();
        collect(folder, "", &mut names)?;
        Ok(Self { names })
    }

    /// Whether a file is there, by its path.
    pub(crate) fn has(&self, video: &VideoLayout, path: &Path) -> bool {
        let below = path.strip_prefix(video.folder()).ok();
        let parts = below.map(|below| below.iter().map(|part| part.to_string_lossy()).collect::<Vec<_>>().join("/"));
        parts.is_some_and(|name| self.names.contains(&name))
    }
}

impl FromIterator<String> for StoredFiles {
    fn from_iter<I: IntoIterator<Item = String>>(names: I) -> Self {
        Self { names: names.into_iter().collect() }
    }
}

fn collect(folder: &Path, above: &str, names: &mut BTreeSet<String>) -> Result<(), DatasetError> {
    let failed = |e| DatasetError::io("cannot read the folder", folder, e);
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(()),
        Err(e) => return Err(failed(e)),
    };
    for entry in entries {
        let entry = entry.map_err(failed)?;
        let name = format!("{above}{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            collect(&entry.path(), &format!("{name}/"), names)?;
        } else {
            names.insert(name);
        }
    }
    Ok(())
}

/// The folder itself keeps the dataset.
#[derive(Debug, Clone, Copy, Default)]
pub struct FolderStore;

impl DatasetStore for FolderStore {
    fn open(&self, _layout: &DatasetLayout) -> Result<(), StoreError> {
        Ok(())
    }

    fn refresh(&self, _layout: &DatasetLayout) -> Result<(), StoreError> {
        Ok(())
    }

    fn files(&self, video: &VideoLayout) -> Result<StoredFiles, StoreError> {
        Ok(StoredFiles::in_folder(video.folder())?)
    }

    fn put_scenes(&self, _layout: &DatasetLayout) -> Result<(), StoreError> {
        Ok(())
    }

    fn reopen_video(&self, _video: &VideoLayout) -> Result<(), StoreError> {
        Ok(())
    }

    fn put_video(&self, _video: &VideoLayout) -> Result<(), StoreError> {
        Ok(())
    }

    fn wait(&self) -> Result<(), StoreError> {
        Ok(())
    }

    fn put_index(&self, _layout: &DatasetLayout) -> Result<(), StoreError> {
        Ok(())
    }

    fn close(&self, _layout: &DatasetLayout) -> Result<(), StoreError> {
        Ok(())
    }

    fn videos_at_a_time(&self) -> Option<usize> {
        None
    }
}
