//! Lines of JSON, one after the other.

use crate::{folder::StampedFile, refusal::Refusal};
use serde::Deserialize;
use std::{
    fs::File,
    io::{BufRead, BufReader, Read},
    path::{Path, PathBuf},
};

/// Longest line that is read.
const MOST_BYTES: u64 = 64 << 20;

/// Reads a file of JSON lines in the order of its lines.
#[derive(Debug)]
pub(crate) struct LineReader {
    path: PathBuf,
    reader: BufReader<File>,
    line: Vec<u8>,
    number: usize,
}

impl LineReader {
    pub(crate) fn new(path: &Path, file: StampedFile) -> Self {
        let reader = BufReader::with_capacity(1 << 18, file.file);
        Self { path: path.to_owned(), reader, line: Vec::new(), number: 0 }
    }

    /// The next line, nothing at the end of the file.
    pub(crate) fn next<'l, T: Deserialize<'l>>(&'l mut self) -> Result<Option<T>, Refusal> {
        self.line.clear();
        self.number += 1;
        let damaged = |reason: String| Refusal::damaged(&self.path, format!("line {}: {reason}", self.number));
        let mut bounded = (&mut self.reader).take(MOST_BYTES);
        if bounded.read_until(b'\n', &mut self.line).map_err(|cause| damaged(cause.to_string()))? == 0 {
            return Ok(None);
        }
        serde_json::from_slice(&self.line).map(Some).map_err(|cause| damaged(cause.to_string()))
    }
}
