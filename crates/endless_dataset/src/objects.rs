//! `objects.jsonl`: one line a frame.

use crate::{DatasetError, LinesWriter, read_lines};
use endless_annotate::FrameObjects;
use std::path::Path;

/// Writes lines in the order of frames.
pub type ObjectsWriter = LinesWriter<FrameObjects>;

/// All lines of a file.
///
/// # Errors
/// As [`read_lines`].
pub fn read_objects(path: &Path) -> Result<Vec<FrameObjects>, DatasetError> {
    read_lines(path)
}
