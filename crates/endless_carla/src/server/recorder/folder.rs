//! Names of recordings: files of one folder, whatever a peer calls them.

use crate::recording::is_recording;
use crate::server::call_error::CallError;
use std::fs::{self, File};
use std::io::Read as _;
use std::path::{Component, Path, PathBuf};

/// Begins files that may be written over.
const HEAD_BYTES: u64 = 32;

/// The folder of all recordings.
pub(super) struct RecordingFolder {
    folder: PathBuf,
}

impl RecordingFolder {
    /// It need not exist.
    pub(super) fn new(folder: PathBuf) -> Self {
        Self { folder }
    }

    /// Opens a file to be written: a new one, or in place of another recording. Gives its path, too.
    ///
    /// # Errors
    /// When the name is none, or the file cannot be made.
    pub(super) fn create(&self, name: &str) -> Result<(File, PathBuf), CallError> {
        let failed = |error: std::io::Error| CallError::refused(format!("cannot record to '{name}': {error}"));
        fs::create_dir_all(&self.folder).map_err(failed)?;
        let path = self.path(name)?;
        if path.exists() {
            let mut head = Vec::new();
            File::open(&path).and_then(|file| file.take(HEAD_BYTES).read_to_end(&mut head)).map_err(failed)?;
            if !head.is_empty() && !is_recording(&head) {
                return Err(CallError::refused(format!("'{name}' is no recording: it is not written over")));
            }
        }
        Ok((File::create(&path).map_err(failed)?, path))
    }

    /// The path of a recording, which may not exist.
    ///
    /// # Errors
    /// When the name leads out of the folder.
    pub(super) fn path(&self, name: &str) -> Result<PathBuf, CallError> {
        let folder = self.folder.canonicalize().unwrap_or_else(|_missing| self.folder.clone());
        let elsewhere = || {
            let folder = self.folder.display();
            CallError::refused(format!(
                "'{name}' is not in the folder of recordings, {folder}: name a file in it, or start the server with \
                 --recordings DIR"
            ))
        };
        let own = Path::new(name);
        let own = match own.is_absolute() {
            true => {
                own.strip_prefix(&self.folder).or_else(|_| own.strip_prefix(&folder)).map_err(|_out| elsewhere())?
            }
            false => own,
        };
        let mut path = folder.clone();
        for component in own.components() {
            match component {
                Component::CurDir => {}
                Component::Normal(part) => path.push(part),
                _ => return Err(elsewhere()),
            }
        }
        // Links that were put there lead nowhere else, either.
        let parent = path.parent().filter(|parent| parent.starts_with(&folder)).ok_or_else(elsewhere)?;
        let leads_out = parent.canonicalize().is_ok_and(|real| !real.starts_with(&folder));
        let is_link = path.symlink_metadata().is_ok_and(|about| about.file_type().is_symlink());
        if name.contains('\0') || leads_out || is_link || path.is_dir() {
            return Err(elsewhere());
        }
        Ok(path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lead_nowhere_else() {
        let base = tempfile::tempdir().expect("a folder");
        let base = base.path();
        let folder = RecordingFolder::new(base.join("recordings"));
        let inside = base.join("recordings/a.log");
        for name in ["a.log", "./a.log", ".//a.log", inside.to_str().unwrap()] {
            let path = folder.create(name).expect(name).1;
            assert_eq!(path, inside.canonicalize().unwrap());
        }
        let outside = base.join("b.log");
        let sneaking = base.join("recordings/../b.log");
        for name in ["../b.log", "x/../../b.log", "/etc/passwd", "", ".", "..", "a\0.log"] {
            assert!(folder.create(name).is_err(), "{name}");
        }
        assert!(
            folder.create(outside.to_str().unwrap()).is_err() && folder.create(sneaking.to_str().unwrap()).is_err()
        );
        // What is no recording stays what it is.
        fs::write(&inside, "import carla  # a script").unwrap();
        assert!(folder.create("a.log").err().unwrap().to_string().contains("no recording"));
        #[cfg(unix)]
        {
            fs::write(&outside, "").unwrap();
            std::os::unix::fs::symlink(&outside, base.join("recordings/link.log")).unwrap();
            std::os::unix::fs::symlink(base, base.join("recordings/up")).unwrap();
            assert!(folder.create("link.log").is_err() && folder.create("up/b.log").is_err());
        }
    }
}
