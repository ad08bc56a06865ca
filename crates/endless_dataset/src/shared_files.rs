//! Files that several processes write, each the same or a newer one.

use crate::{AtomicFile, DatasetError, listing::list, scene_record::json_text, temporary::is_temporary};
use serde::Serialize;
use std::{fs, path::Path};

/// Writes files which other processes may be writing at the same time: its temporary files bear the writer's name, so
/// that nobody writes into or removes those of another.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct SharedFiles {
    /// None of who is alone.
    writer: Option<String>,
}

impl SharedFiles {
    /// Of the only process that writes there.
    pub const fn alone() -> Self {
        Self { writer: None }
    }

    /// Of one of several writers, by a name which no other has at the same time.
    pub fn of(writer: impl Into<String>) -> Self {
        Self { writer: Some(writer.into()) }
    }

    /// Writes a value as readable JSON.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn write_json<T: Serialize>(&self, path: &Path, value: &T) -> Result<(), DatasetError> {
        self.write(path, value)?.finish()
    }

    /// Writes a text.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn write_text(&self, path: &Path, text: &str) -> Result<(), DatasetError> {
        let mut file = self.create(path)?;
        file.write(text.as_bytes())?;
        file.finish()
    }

    /// Writes a value as readable JSON, which is there after a power failure, too.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn write_json_durable<T: Serialize>(&self, path: &Path, value: &T) -> Result<(), DatasetError> {
        self.write(path, value)?.finish_durable()
    }

    fn write<T: Serialize>(&self, path: &Path, value: &T) -> Result<AtomicFile, DatasetError> {
        let mut file = self.create(path)?;
        file.write(&json_text(path, value)?)?;
        Ok(file)
    }

    fn create(&self, path: &Path) -> Result<AtomicFile, DatasetError> {
        match &self.writer {
            Some(writer) => AtomicFile::create_by(path, writer),
            None => AtomicFile::create(path),
        }
    }

    /// Removes what a killed process left half-written in this folder: what bears the writer's name, and what bears no name
    /// of those that may be at work, as `others` tells. Who is alone removes all.
    ///
    /// # Errors
    /// When the folder cannot be read or a file not be removed.
    pub fn remove_temporaries(&self, folder: &Path, others: impl Fn(&str) -> bool) -> Result<(), DatasetError> {
        for path in list(folder)? {
            let writer = writer_of(&path);
            let of_another = self.writer.is_some() && writer != self.writer && writer.as_deref().is_some_and(&others);
            if is_temporary(&path) && !of_another && path.is_file() {
                fs::remove_file(&path).map_err(|e| DatasetError::io("cannot remove", &path, e))?;
            }
        }
        Ok(())
    }
}

/// The writer's name in that of a temporary file.
fn writer_of(path: &Path) -> Option<String> {
    let name = path.file_name()?.to_str()?;
    let (_, writer) = name.strip_suffix(".tmp")?.rsplit_once('@')?;
    Some(writer.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn temporaries_of_others_at_work_stay() {
        let folder = tempfile::tempdir().expect("temp");
        let path = |name: &str| folder.path().join(name);
        let [own, other, gone, unnamed] =
            [".dataset.json@1of2.tmp", ".dataset.json@2of2.tmp", ".0001.json@1of3.tmp", ".dataset.json.tmp"].map(path);
        let make = || [&own, &other, &gone, &unnamed].map(|path| fs::write(path, "half").expect("writable"));
        make();
        let files = SharedFiles::of("1of2");
        files.remove_temporaries(folder.path(), |writer| writer.ends_with("of2")).expect("removable");
        assert_eq!(list(folder.path()).expect("readable"), std::slice::from_ref(&other));
        files.write_json(&path("dataset.json"), &[1]).expect("writable");
        make();
        SharedFiles::alone().remove_temporaries(folder.path(), |_| true).expect("removable");
        assert_eq!(list(folder.path()).expect("readable"), [path("dataset.json")]);
    }
}
