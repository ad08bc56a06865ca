//! Write to a temporary name, then rename: what bears its final name is whole, whenever the process is killed. What must
//! outlive a power failure, too, is made durable: see [`crate::sync_tree`].

use crate::{
    DatasetError,
    durable::sync_folder,
    listing::list,
    temporary::{is_temporary, temporary_name},
};
use std::{
    fs::{self, File},
    io::{BufWriter, Write},
    path::{Path, PathBuf},
};

/// A file that gets its name when it is finished, and vanishes when it is dropped before.
#[derive(Debug)]
pub struct AtomicFile {
    final_path: PathBuf,
    temporary: PathBuf,
    writer: Option<BufWriter<File>>,
}

impl AtomicFile {
    /// Opens the temporary file beside `final_path`.
    ///
    /// # Errors
    /// When it cannot be created.
    pub fn create(final_path: &Path) -> Result<Self, DatasetError> {
        Self::create_named(final_path, "")
    }

    /// The same of one of several processes that write this file: the temporary one bears the writer's name.
    pub(crate) fn create_by(final_path: &Path, writer: &str) -> Result<Self, DatasetError> {
        Self::create_named(final_path, &format!("@{writer}"))
    }

    fn create_named(final_path: &Path, addition: &str) -> Result<Self, DatasetError> {
        let name = final_path.file_name().unwrap_or_default().to_string_lossy();
        let temporary = final_path.with_file_name(temporary_name(&format!("{name}{addition}")));
        let file = File::create(&temporary).map_err(|e| DatasetError::io("cannot write", final_path, e))?;
        let writer = Some(BufWriter::with_capacity(1 << 16, file));
        Ok(Self { final_path: final_path.to_owned(), temporary, writer })
    }

    /// Appends.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn write(&mut self, bytes: &[u8]) -> Result<(), DatasetError> {
        let writer = self.writer.as_mut().expect("open until finished");
        writer.write_all(bytes).map_err(|e| DatasetError::io("cannot write", &self.final_path, e))
    }

    /// Gives the file its name.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn finish(mut self) -> Result<(), DatasetError> {
        drop(self.flushed()?);
        self.rename()
    }

    /// Gives the file its name once its bytes are on the disk, and waits until its name is, too.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn finish_durable(mut self) -> Result<(), DatasetError> {
        let file = self.flushed()?;
        file.sync_all().map_err(|e| DatasetError::io("cannot write", &self.final_path, e))?;
        drop(file);
        self.rename()?;
        sync_folder(self.final_path.parent().unwrap_or(Path::new(".")))
    }

    fn flushed(&mut self) -> Result<File, DatasetError> {
        let writer = self.writer.take().expect("open until finished");
        writer.into_inner().map_err(|e| DatasetError::io("cannot write", &self.final_path, e.into_error()))
    }

    fn rename(&self) -> Result<(), DatasetError> {
        let failed = |e| DatasetError::io("cannot write", &self.final_path, e);
        fs::rename(&self.temporary, &self.final_path).map_err(failed)
    }
}

impl Drop for AtomicFile {
    fn drop(&mut self) {
        if let Some(writer) = self.writer.take() {
            // What is buffered is thrown away: this file is not wanted.
            drop(writer.into_parts());
        }
        // After a rename there is nothing to remove, and then this fails, as it should.
        let _ = fs::remove_file(&self.temporary);
    }
}

/// Writes a whole file.
///
/// # Errors
/// When the disk refuses; nothing is left behind then.
pub fn write_atomic(path: &Path, bytes: &[u8]) -> Result<(), DatasetError> {
    let mut file = AtomicFile::create(path)?;
    file.write(bytes)?;
    file.finish()
}

/// Writes a whole file, which is there after a power failure, too.
///
/// # Errors
/// When the disk refuses; nothing is left behind then.
pub fn write_durable(path: &Path, bytes: &[u8]) -> Result<(), DatasetError> {
    let mut file = AtomicFile::create(path)?;
    file.write(bytes)?;
    file.finish_durable()
}

/// Removes what a killed run left half-written, in this folder and all below it.
///
/// # Errors
/// When a folder cannot be read or a file not be removed.
pub fn remove_temporaries(folder: &Path) -> Result<(), DatasetError> {
    for path in list(folder)? {
        if path.is_dir() {
            remove_temporaries(&path)?;
        } else if is_temporary(&path) {
            fs::remove_file(&path).map_err(|e| DatasetError::io("cannot remove", &path, e))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dropped_file_leaves_nothing() {
        let folder = tempfile::tempdir().expect("temp");
        let path = folder.path().join("a.png");
        let mut file = AtomicFile::create(&path).expect("writable");
        file.write(b"half").expect("writable");
        drop(file);
        assert_eq!(list(folder.path()).expect("readable"), Vec::<PathBuf>::new());
        write_atomic(&path, b"whole").expect("writable");
        assert_eq!(fs::read(&path).expect("there"), b"whole");
        write_durable(&path, b"anew").expect("writable");
        assert_eq!(fs::read(&path).expect("there"), b"anew");
        assert_eq!(list(folder.path()).expect("readable"), [path]);
    }

    #[test]
    fn temporaries_of_a_killed_run_go() {
        let folder = tempfile::tempdir().expect("temp");
        fs::create_dir_all(folder.path().join("camera_a/rgb")).expect("writable");
        let half = folder.path().join("camera_a/rgb/.000001.png.tmp");
        let whole = folder.path().join("camera_a/rgb/000000.png");
        fs::write(&half, "x").expect("writable");
        fs::write(&whole, "x").expect("writable");
        remove_temporaries(folder.path()).expect("removable");
        assert!(!half.exists() && whole.exists());
    }
}
