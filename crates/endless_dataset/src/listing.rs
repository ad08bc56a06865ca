//! Lists folders.

use crate::DatasetError;
use std::{
    fs,
    path::{Path, PathBuf},
};

/// What lies in a folder, sorted; nothing if it does not exist.
pub(crate) fn list(folder: &Path) -> Result<Vec<PathBuf>, DatasetError> {
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(e) => return Err(DatasetError::io("cannot read the folder", folder, e)),
    };
    let mut paths = Vec::new();
    for entry in entries {
        paths.push(entry.map_err(|e| DatasetError::io("cannot read the folder", folder, e))?.path());
    }
    paths.sort();
    Ok(paths)
}
