//! The lock on an output folder.

use crate::GenerateError;
use endless_dataset::{DatasetError, DatasetLayout};
use std::{
    fs::{self, File, TryLockError},
    path::{Path, PathBuf},
};

/// Keeps a second process out of a dataset. Released when the process ends, however it ends; leaves no trace when it is
/// dropped.
#[derive(Debug)]
pub(super) struct DatasetLock {
    _file: File,
    path: PathBuf,
}

impl DatasetLock {
    /// Locks a dataset, and makes its folder if there is none.
    pub(super) fn take(layout: &DatasetLayout) -> Result<Self, GenerateError> {
        let root = layout.root();
        fs::create_dir_all(root).map_err(|e| DatasetError::io("cannot make the folder", root, e))?;
        let path = layout.lock();
        loop {
            let file = File::create(&path).map_err(|e| DatasetError::io("cannot write", root, e))?;
            match file.try_lock() {
                Ok(()) if is_file_at(&file, &path) => return Ok(Self { _file: file, path }),
                // Who held the lock removed its file after it was opened here: that file keeps nobody out.
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => return Err(GenerateError::Locked { path: root.to_owned() }),
                Err(TryLockError::Error(e)) => return Err(DatasetError::io("cannot lock", root, e).into()),
            }
        }
    }
}

impl Drop for DatasetLock {
    fn drop(&mut self) {
        // While it is locked: whoever opens it before now finds that it is not at its path any more.
        let _ = fs::remove_file(&self.path);
    }
}

/// Whether an open file is still the one at a path.
#[cfg(unix)]
fn is_file_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let place = |data: fs::Metadata| (data.dev(), data.ino());
    match (file.metadata(), fs::metadata(path)) {
        (Ok(opened), Ok(there)) => place(opened) == place(there),
        _ => false,
    }
}

/// Where an open file cannot be removed, it lies where it was opened.
#[cfg(not(unix))]
fn is_file_at(_file: &File, path: &Path) -> bool {
    path.exists()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicU32, Ordering};

    #[test]
    fn never_two_hold_the_lock_and_it_leaves_no_trace() {
        let folder = tempfile::tempdir().expect("temp");
        let layout = DatasetLayout::new(folder.path());
        let (holders, taken) = (AtomicU32::new(0), AtomicU32::new(0));
        std::thread::scope(|scope| {
            for _ in 0..6 {
                scope.spawn(|| {
                    for _ in 0..1000 {
                        let Ok(lock) = DatasetLock::take(&layout) else { continue };
                        assert_eq!(holders.fetch_add(1, Ordering::SeqCst), 0, "a second one holds it");
                        taken.fetch_add(1, Ordering::SeqCst);
                        std::thread::yield_now();
                        holders.fetch_sub(1, Ordering::SeqCst);
                        drop(lock);
                    }
                });
            }
        });
        assert!(taken.into_inner() > 0 && !layout.lock().exists());
    }
}
