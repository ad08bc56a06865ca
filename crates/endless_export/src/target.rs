//! The folder that is written to: taken or free, begun or finished, and what of it is done already.
//!
//! While an export is at work, the folder `.endless_export` holds what it was asked for, which videos are done, and the
//! parts of files that come of several videos. At its end all of that becomes `endless_export.json`.

use crate::ExportError;
use endless_dataset::{AtomicFile, DatasetError, read_json, remove_temporaries, write_atomic, write_json};
use serde_json::Value;
use std::{
    collections::BTreeSet,
    fs::{self, File},
    io::{self, BufRead, BufReader},
    path::{Path, PathBuf},
    sync::{Mutex, PoisonError},
};

const WORK: &str = ".endless_export";
const RECORD: &str = "endless_export.json";

/// A folder that an export writes to.
#[derive(Debug)]
pub(crate) struct Target {
    root: PathBuf,
    /// Folders that are there.
    folders: Mutex<BTreeSet<PathBuf>>,
    /// Keeps others out while it is open.
    _lock: File,
}

/// What is in the folder.
#[derive(Debug)]
pub(crate) enum Opened {
    /// Something is to be done.
    Open(Target),
    /// The same export, finished.
    Complete,
}

impl Target {
    /// Takes a folder for what is asked for, or goes on with it.
    pub(crate) fn open(root: &Path, asked: &Value) -> Result<Opened, ExportError> {
        let taken = |reason| ExportError::Target { reason, path: root.to_owned() };
        let (record, work) = (root.join(RECORD), root.join(WORK));
        if record.is_file() {
            let same = read_json::<Value>(&record).is_ok_and(|made| made == *asked);
            if !same {
                return Err(taken("holds an export of something else: remove it, or choose another folder with --to"));
            }
            // A run that was killed at its very end leaves its work behind.
            remove(&work)?;
            return Ok(Opened::Complete);
        }
        let request = work.join("request.json");
        if request.is_file() {
            if read_json::<Value>(&request)? != *asked {
                return Err(taken(
                    "holds an unfinished export of something else: remove it, or choose another folder with --to",
                ));
            }
        } else if root.exists() {
            let mut entries = fs::read_dir(root).map_err(|e| DatasetError::io("cannot read", root, e))?;
            // A folder of our own without a request was begun by a run that was killed at once.
            if entries.any(|entry| entry.is_ok_and(|entry| entry.file_name() != WORK)) {
                return Err(taken("is there already and is not empty: choose another folder with --to"));
            }
        }
        for folder in ["done", "parts"] {
            let folder = work.join(folder);
            fs::create_dir_all(&folder).map_err(|e| DatasetError::io("cannot make the folder", &folder, e))?;
        }
        let path = work.join("lock");
        let lock = File::create(&path).map_err(|e| DatasetError::io("cannot write", &path, e))?;
        lock.try_lock().map_err(|_held| taken("is being written by another run: wait for it"))?;
        remove_temporaries(&work)?;
        write_json(&request, asked)?;
        Ok(Opened::Open(Self { root: root.to_owned(), folders: Mutex::default(), _lock: lock }))
    }

    /// The folder.
    pub(crate) fn root(&self) -> &Path {
        &self.root
    }

    /// A path below it, whose folder is there.
    pub(crate) fn path(&self, below: impl AsRef<Path>) -> Result<PathBuf, ExportError> {
        let path = self.root.join(below);
        if let Some(folder) = path.parent() {
            let mut folders = self.folders.lock().unwrap_or_else(PoisonError::into_inner);
            if !folders.contains(folder) {
                fs::create_dir_all(folder).map_err(|e| DatasetError::io("cannot make the folder", folder, e))?;
                folders.insert(folder.to_owned());
            }
        }
        Ok(path)
    }

    /// Writes a whole file.
    pub(crate) fn write(&self, below: impl AsRef<Path>, bytes: &[u8]) -> Result<(), ExportError> {
        Ok(write_atomic(&self.path(below)?, bytes)?)
    }

    /// Begins a file that gets its name when it is finished.
    pub(crate) fn create(&self, below: impl AsRef<Path>) -> Result<AtomicFile, ExportError> {
        Ok(AtomicFile::create(&self.path(below)?)?)
    }

    /// Begins what a video has to say in a file that comes of several.
    pub(crate) fn create_part(&self, name: &str, video: usize) -> Result<AtomicFile, ExportError> {
        self.create(Self::part(name, video))
    }

    /// The lines of such a part; none where the video has none.
    pub(crate) fn part_lines(
        &self,
        name: &str,
        video: usize,
    ) -> Result<impl Iterator<Item = Result<String, ExportError>> + use<>, ExportError> {
        let path = self.root.join(Self::part(name, video));
        let lines = if path.is_file() {
            let file = File::open(&path).map_err(|e| DatasetError::io("cannot read", &path, e))?;
            Some(BufReader::with_capacity(1 << 16, file).lines())
        } else {
            None
        };
        Ok(lines
            .into_iter()
            .flatten()
            .map(move |line| line.map_err(|e| DatasetError::io("cannot read", &path, e).into())))
    }

    fn part(name: &str, video: usize) -> PathBuf {
        Path::new(WORK).join("parts").join(name).join(format!("{video:06}"))
    }

    fn done_mark(&self, video: usize) -> PathBuf {
        self.root.join(WORK).join("done").join(format!("{video:06}"))
    }

    /// Whether all of a video is there.
    pub(crate) fn is_done(&self, video: usize) -> bool {
        self.done_mark(video).is_file()
    }

    /// All of a video is there.
    pub(crate) fn set_done(&self, video: usize) -> Result<(), ExportError> {
        Ok(write_atomic(&self.done_mark(video), b"")?)
    }

    /// All is there.
    pub(crate) fn finish(self, asked: &Value) -> Result<(), ExportError> {
        write_json(&self.root.join(RECORD), asked)?;
        remove(&self.root.join(WORK))
    }
}

/// Removes a folder, if it is there.
fn remove(folder: &Path) -> Result<(), ExportError> {
    match fs::remove_dir_all(folder) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => {
            Err(DatasetError::io("cannot remove", folder, error).into())
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn open(root: &Path, asked: &Value) -> Result<Target, String> {
        match Target::open(root, asked) {
            Ok(Opened::Open(target)) => Ok(target),
            Ok(Opened::Complete) => Err("complete".into()),
            Err(error) => Err(error.to_string()),
        }
    }

    #[test]
    fn a_target_is_begun_resumed_and_complete() {
        let folder = tempfile::tempdir().expect("temp");
        let root = folder.path().join("a/b");
        let (asked, other) = (json!({"format": "coco"}), json!({"format": "yolo"}));
        let target = open(&root, &asked).expect("free");
        assert!(open(&root, &asked).expect_err("taken").contains("another run"));
        let mut part = target.create_part("images", 3).expect("writable");
        part.write(b"one\ntwo\n").expect("writable");
        part.finish().expect("writable");
        target.set_done(3).expect("writable");
        drop(target);
        assert!(open(&root, &other).expect_err("other").contains("unfinished export of something else"));
        let target = open(&root, &asked).expect("the same");
        assert!(target.is_done(3) && !target.is_done(2));
        let lines: Vec<String> =
            target.part_lines("images", 3).expect("readable").collect::<Result<_, _>>().expect("readable");
        assert_eq!(lines, ["one", "two"]);
        assert_eq!(target.part_lines("images", 2).expect("readable").count(), 0);
        target.finish(&asked).expect("writable");
        assert_eq!(open(&root, &asked).expect_err("done"), "complete");
        // Killed after the record was written and before the work was gone.
        fs::create_dir_all(root.join(WORK).join("parts")).expect("writable");
        assert_eq!(open(&root, &asked).expect_err("done"), "complete");
        assert!(!root.join(WORK).exists());
        assert!(open(&root, &other).expect_err("other").contains("holds an export of something else"));
    }

    #[test]
    fn a_folder_of_others_is_left_alone() {
        let folder = tempfile::tempdir().expect("temp");
        fs::write(folder.path().join("thesis.tex"), "x").expect("writable");
        assert!(open(folder.path(), &json!({})).expect_err("taken").contains("not empty"));
        assert_eq!(fs::read_dir(folder.path()).expect("readable").count(), 1);
    }
}
