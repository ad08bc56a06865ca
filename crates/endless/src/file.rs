//! Writes the output files of commands.

use anyhow::{Context, Result};
use std::{fs, path::Path};

/// Writes a whole file or nothing, and the folders that it lies in.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    make_folder_of(path)?;
    endless_dataset::write_durable(path, bytes)?;
    Ok(())
}

/// Makes the folders that a file lies in.
pub(crate) fn make_folder_of(path: &Path) -> Result<()> {
    if let Some(folder) = path.parent().filter(|p| !p.as_os_str().is_empty()) {
        fs::create_dir_all(folder).with_context(|| format!("cannot make the folder {}", folder.display()))?;
    }
    Ok(())
}
