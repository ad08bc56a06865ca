//! A file that the system locks for a process, until it ends, however it ends.

use std::{
    fs::{self, File, OpenOptions, TryLockError},
    io,
    path::{Path, PathBuf},
};

/// A locked file.
#[derive(Debug)]
pub(super) struct LockFile {
    file: File,
    path: PathBuf,
}

/// Why a file could not be locked.
#[derive(Debug)]
pub(super) enum LockFailure {
    /// Another process has it.
    Held,
    /// The file system knows no locks.
    Unknown,
    /// It cannot be.
    Io(io::Error),
}

/// Who else may have the lock at the same time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sharing {
    /// Nobody.
    Exclusive,
    /// Others who share it.
    Shared,
}

impl LockFile {
    /// Takes the lock of a file, which is made if there is none.
    pub(super) fn take(path: &Path, sharing: Sharing) -> Result<Self, LockFailure> {
        Self::take_with(path, |file| match sharing {
            Sharing::Exclusive => file.try_lock(),
            Sharing::Shared => file.try_lock_shared(),
        })
    }

    /// The same, waiting until nobody else has it.
    pub(super) fn wait(path: &Path) -> Result<Self, LockFailure> {
        Self::take_with(path, |file| file.lock().map_err(TryLockError::Error))
    }

    fn take_with(path: &Path, lock: impl Fn(&File) -> Result<(), TryLockError>) -> Result<Self, LockFailure> {
        loop {
            let mut options = OpenOptions::new();
            let file =
                options.read(true).write(true).create(true).truncate(false).open(path).map_err(LockFailure::Io)?;
            match lock(&file) {
                Ok(()) if is_file_at(&file, path) => return Ok(Self { file, path: path.to_owned() }),
                // Who held the lock removed its file after it was opened here: that file keeps nobody out.
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => return Err(LockFailure::Held),
                Err(TryLockError::Error(e)) if knows_no_locks(&e) => return Err(LockFailure::Unknown),
                Err(TryLockError::Error(e)) => return Err(LockFailure::Io(e)),
            }
        }
    }

    /// Removes the file while it is locked: whoever has opened it finds that it is not at its path any more.
    pub(super) fn remove(self) {
        // Nothing can be done about a file that stays: it is not locked any more.
        let _ = fs::remove_file(&self.path);
        drop(self.file);
    }
}

/// Whether this is how a file system says that it has no locks.
fn knows_no_locks(error: &io::Error) -> bool {
    /// `ENOLCK`, as Linux and macOS number it: a network's file system without its lock service.
    const NO_LOCKS: i32 = if cfg!(target_os = "linux") { 37 } else { 77 };
    error.kind() == io::ErrorKind::Unsupported || (cfg!(unix) && error.raw_os_error() == Some(NO_LOCKS))
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

    #[test]
    fn a_file_system_without_locks_is_told_from_a_failure() {
        let unknown = |e: io::Error| {
            let folder = tempfile::tempdir().expect("temp");
            let number = e.raw_os_error().expect("a number");
            let locked = LockFile::take_with(&folder.path().join("lock"), |_| {
                Err(TryLockError::Error(io::Error::from_raw_os_error(number)))
            });
            matches!(locked, Err(LockFailure::Unknown))
        };
        #[cfg(target_os = "linux")]
        for number in [37, 38, 95] {
            assert!(unknown(io::Error::from_raw_os_error(number)), "{number}");
        }
        assert!(!unknown(io::Error::from_raw_os_error(5)));
    }

    #[test]
    fn those_who_share_keep_out_who_does_not() {
        let folder = tempfile::tempdir().expect("temp");
        let path = folder.path().join("lock");
        let first = LockFile::take(&path, Sharing::Shared).expect("free");
        let second = LockFile::take(&path, Sharing::Shared).expect("shared");
        assert!(matches!(LockFile::take(&path, Sharing::Exclusive), Err(LockFailure::Held)));
        drop((first, second));
        LockFile::take(&path, Sharing::Exclusive).expect("free").remove();
        assert!(!path.exists());
    }
}
