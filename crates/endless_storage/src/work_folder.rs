//! The folder on this machine in which videos are recorded before they are uploaded.
//!
//! ```text
//! WORK/s3-bucket-prefix-0123456789abcdef/
//!   dataset/           what the pipeline takes for the dataset: videos in work, and of those that are uploaded
//!                      builds.json and scene.json
//!   outgoing/NAME/     a video that is complete here: what is not uploaded yet of it
//!   outgoing/NAME.json sizes of all its files, written before the first of them goes
//! ```

use crate::{address::StorageAddress, bucket::Objects};
use endless_dataset::{DatasetError, DatasetLayout, read_json, write_json_durable};
use etcetera::BaseStrategy;
use std::{
    env, fs, io,
    path::{Path, PathBuf},
};

/// What of a video stays here when it is uploaded, by which the pipeline knows it.
pub(crate) const BUILDS: &str = "builds.json";
/// The last of its files.
pub(crate) const SCENE: &str = "scene.json";

/// The folder of one dataset and one process.
#[derive(Debug, Clone)]
pub(crate) struct WorkFolder {
    root: PathBuf,
}

impl WorkFolder {
    /// Below `parent`, or below the platform's folder of caches; `None` where the platform has no such place. Each part of a dataset has its own,
    /// by the name that tells it from other parts.
    pub(crate) fn of(address: &StorageAddress, part: Option<&str>, parent: Option<&Path>) -> Option<Self> {
        let parent = match parent {
            Some(parent) => parent.to_owned(),
            None => etcetera::choose_base_strategy().ok()?.cache_dir().join("endless").join("work"),
        };
        let endpoint = env::var("AWS_ENDPOINT_URL").unwrap_or_default();
        let digest = blake3::hash(format!("{address}\n{endpoint}").as_bytes()).to_hex();
        let readable: String =
            address.to_string().chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).take(80).collect();
        let part = part.map(|part| format!("-{part}")).unwrap_or_default();
        Some(Self { root: parent.join(format!("{}-{}{part}", readable.replace("---", "-"), &digest[..16])) })
    }

    #[cfg(test)]
    pub(crate) fn at(root: &Path) -> Self {
        Self { root: root.to_owned() }
    }

    pub(crate) fn dataset(&self) -> DatasetLayout {
        DatasetLayout::new(self.root.join("dataset"))
    }

    /// Where the files of a video lie that is being uploaded.
    pub(crate) fn outgoing(&self, name: &str) -> PathBuf {
        self.root.join("outgoing").join(name)
    }

    fn contents_path(&self, name: &str) -> PathBuf {
        self.root.join("outgoing").join(format!("{name}.json"))
    }

    /// Takes a complete video from where it was recorded.
    pub(crate) fn take(&self, name: &str) -> Result<(), DatasetError> {
        let (from, to) = (self.dataset().video_named(name).folder().to_owned(), self.outgoing(name));
        self.forget(name)?;
        fs::create_dir_all(self.root.join("outgoing"))
            .map_err(|e| DatasetError::io("cannot make the folder", &to, e))?;
        fs::rename(&from, &to).map_err(|e| DatasetError::io("cannot move the folder", &from, e))
    }

    /// Videos that a killed run was uploading.
    pub(crate) fn left(&self) -> Result<Vec<String>, DatasetError> {
        let mut left = Vec::new();
        for path in list(&self.root.join("outgoing"))? {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            if path.join(SCENE).is_file() {
                left.push(name);
            } else if path.is_dir() {
                // All of it is uploaded.
                self.forget(&name)?;
            }
        }
        Ok(left)
    }

    /// Sizes of all files of a video that is going. Noted while all are here.
    pub(crate) fn contents(&self, name: &str) -> Result<Objects, DatasetError> {
        let path = self.contents_path(name);
        if path.is_file() {
            return read_json(&path);
        }
        let contents = self.here(name)?;
        write_json_durable(&path, &contents)?;
        Ok(contents)
    }

    /// Those of its files that are not gone yet.
    pub(crate) fn here(&self, name: &str) -> Result<Objects, DatasetError> {
        let mut files = Objects::new();
        collect(&self.outgoing(name), "", &mut files)?;
        Ok(files)
    }

    /// A video is uploaded: what tells of it goes back to where it was recorded, and nothing else is left.
    pub(crate) fn uploaded(&self, name: &str) -> Result<(), DatasetError> {
        let (going, video) = (self.outgoing(name), self.dataset().video_named(name));
        fs::create_dir_all(video.folder())
            .map_err(|e| DatasetError::io("cannot make the folder", video.folder(), e))?;
        for file in [BUILDS, SCENE] {
            let from = going.join(file);
            if from.is_file() {
                let to = video.folder().join(file);
                fs::rename(&from, &to).map_err(|e| DatasetError::io("cannot move the file", &from, e))?;
            }
        }
        self.forget(name)
    }

    /// Removes what is left of a video that was going.
    pub(crate) fn forget(&self, name: &str) -> Result<(), DatasetError> {
        remove(&self.outgoing(name))?;
        remove(&self.contents_path(name))
    }

    /// Removes everything but the lock.
    pub(crate) fn clear(&self) -> Result<(), DatasetError> {
        let layout = self.dataset();
        let is_lock = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().starts_with(".lock");
        for path in list(layout.root())?.into_iter().filter(|path| !is_lock(path)) {
            remove(&path)?;
        }
        remove(&self.root.join("outgoing"))
    }

    /// Removes its folders if nothing lies in them.
    pub(crate) fn remove_if_empty(&self) {
        let _ = fs::remove_dir(self.dataset().root());
        let _ = fs::remove_dir(&self.root);
    }
}

/// Removes a file or a folder, if it is there.
pub(crate) fn remove(path: &Path) -> Result<(), DatasetError> {
    let removed = if path.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
    match removed {
        Err(e) if e.kind() != io::ErrorKind::NotFound => Err(DatasetError::io("cannot remove", path, e)),
        _ => Ok(()),
    }
}

/// What lies in a folder; nothing if it does not exist.
pub(crate) fn list(folder: &Path) -> Result<Vec<PathBuf>, DatasetError> {
    let failed = |e| DatasetError::io("cannot read the folder", folder, e);
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(e) => return Err(failed(e)),
    };
    let mut paths = entries.map(|entry| Ok(entry.map_err(failed)?.path())).collect::<Result<Vec<_>, _>>()?;
    paths.sort();
    Ok(paths)
}

fn collect(folder: &Path, above: &str, files: &mut Objects) -> Result<(), DatasetError> {
    for path in list(folder)? {
        let name = format!("{above}{}", path.file_name().unwrap_or_default().to_string_lossy());
        let data = fs::metadata(&path).map_err(|e| DatasetError::io("cannot read", &path, e))?;
        if data.is_dir() {
            collect(&path, &format!("{name}/"), files)?;
        } else {
            files.insert(name, data.len());
        }
    }
    Ok(())
}
