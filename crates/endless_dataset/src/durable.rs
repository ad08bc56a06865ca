//! Files that survive a power failure.
//!
//! A renamed file may be empty then: its name can reach the disk before its bytes do. Waiting for the disk file by file
//! would make every frame as slow as the disk; so a video's files are written as the system likes it, and all of them
//! are waited for at its end, before anything says that it is complete.

use crate::{DatasetError, listing::list, temporary::is_temporary};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::{fs::File, io, path::Path};

/// Waits until all files and folders below a folder, and their names, are on the disk. Many files at a time: the disk
/// takes them in fewer strokes. Files that others are still writing are theirs to wait for.
///
/// # Errors
/// When one of them cannot be read, or the disk refuses.
pub fn sync_tree(folder: &Path) -> Result<(), DatasetError> {
    list(folder)?
        .into_par_iter()
        .filter(|path| !is_temporary(path))
        .try_for_each(|path| if path.is_dir() { sync_tree(&path) } else { sync_file(&path) })?;
    sync_folder(folder)
}

fn sync_file(path: &Path) -> Result<(), DatasetError> {
    // Some systems want a file that may be written.
    let synced = File::options().write(true).open(path).and_then(|file| file.sync_all());
    synced.map_err(|e| DatasetError::io("cannot write", path, e))
}

/// Waits until the names in a folder are on the disk. Where folders cannot be opened (Windows), the system sees to that.
pub(crate) fn sync_folder(folder: &Path) -> Result<(), DatasetError> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let synced = match File::open(folder) {
        Ok(opened) => opened.sync_all(),
        Err(_) if cfg!(windows) => Ok(()),
        Err(e) => Err(e),
    };
    match synced {
        // File systems that cannot do that to folders say so.
        Err(e) if matches!(e.kind(), io::ErrorKind::InvalidInput | io::ErrorKind::Unsupported) => Ok(()),
        done => done.map_err(|e| DatasetError::io("cannot write", folder, e)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn a_tree_is_synced_and_a_missing_file_is_named() {
        let folder = tempfile::tempdir().expect("temp");
        fs::create_dir_all(folder.path().join("camera_a/rgb")).expect("writable");
        fs::write(folder.path().join("camera_a/rgb/000000.png"), "x").expect("writable");
        sync_tree(folder.path()).expect("all is there");
        // Another process is about to rename it: here, a link to what is there no more.
        #[cfg(unix)]
        std::os::unix::fs::symlink("gone", folder.path().join(".0001.json@2-of-8.tmp")).expect("writable");
        sync_tree(folder.path()).expect("it is not ours");
        let missing = sync_file(&folder.path().join("000001.png")).expect_err("not there");
        assert!(missing.to_string().ends_with("000001.png"), "{missing}");
        assert!(sync_folder(&folder.path().join("camera_b")).is_err());
    }
}
