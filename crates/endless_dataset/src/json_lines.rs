//! Files of one JSON object a line: `objects.jsonl`, `frames.jsonl`.

use crate::{AtomicFile, DatasetError};
use serde::{Serialize, de::DeserializeOwned};
use std::{fs, marker::PhantomData, path::Path};

/// Writes lines in the order of frames.
#[derive(Debug)]
pub struct LinesWriter<T> {
    file: AtomicFile,
    line: PhantomData<fn(&T)>,
}

impl<T: Serialize> LinesWriter<T> {
    /// Opens the file.
    ///
    /// # Errors
    /// When it cannot be created.
    pub fn create(path: &Path) -> Result<Self, DatasetError> {
        Ok(Self { file: AtomicFile::create(path)?, line: PhantomData })
    }

    /// Appends one frame.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn write(&mut self, line: &T) -> Result<(), DatasetError> {
        let mut text = serde_json::to_vec(line).expect("plain numbers and words");
        text.push(b'\n');
        self.file.write(&text)
    }

    /// Gives the file its name.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn finish(self) -> Result<(), DatasetError> {
        self.file.finish()
    }
}

/// All lines of a file.
///
/// # Errors
/// When it is missing or a line is not what it should be; the message has the line's number.
pub fn read_lines<T: DeserializeOwned>(path: &Path) -> Result<Vec<T>, DatasetError> {
    let text = fs::read_to_string(path).map_err(|e| DatasetError::io("cannot read", path, e))?;
    text.lines()
        .enumerate()
        .map(|(i, line)| {
            serde_json::from_str(line).map_err(|e| DatasetError::malformed(path, format!("line {}: {e}", i + 1)))
        })
        .collect()
}
