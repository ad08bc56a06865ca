//! Puts images of the dataset where a format wants them.

use crate::ExportError;
use endless_dataset::DatasetError;
use serde::{Deserialize, Serialize};
use std::{fs, io, path::Path};

/// How files that are the same in the export get there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Placing {
    /// Hard links, which take no disk and stay when the dataset goes; symbolic ones where the target is on another disk.
    Link,
    /// Copies.
    Copy,
}

impl Placing {
    /// Puts a file there; one that is there already, of an export that was interrupted, is replaced.
    ///
    /// # Errors
    /// When the disk refuses.
    pub(crate) fn place(self, source: &Path, target: &Path) -> Result<(), ExportError> {
        let failed = |e| DatasetError::io("cannot write", target, e);
        match fs::remove_file(target) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(failed(error).into()),
            _ => {}
        }
        match self {
            Self::Copy => fs::copy(source, target).map(|_bytes| ()).map_err(failed)?,
            Self::Link => {
                fs::hard_link(source, target).or_else(|_other_disk| symbolic_link(source, target)).map_err(failed)?;
            }
        }
        Ok(())
    }
}

#[cfg(unix)]
fn symbolic_link(source: &Path, target: &Path) -> io::Result<()> {
    std::os::unix::fs::symlink(source.canonicalize()?, target)
}

/// Symbolic links need rights there that few have.
#[cfg(not(unix))]
fn symbolic_link(source: &Path, target: &Path) -> io::Result<()> {
    fs::copy(source, target).map(|_bytes| ())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_get_there_and_replace_others() {
        let folder = tempfile::tempdir().expect("temp");
        let [source, target] = ["a", "b"].map(|name| folder.path().join(name));
        fs::write(&source, "one").expect("writable");
        for placing in [Placing::Link, Placing::Copy, Placing::Link] {
            placing.place(&source, &target).expect("there is room");
            assert_eq!(fs::read(&target).expect("there"), b"one");
        }
        Placing::Copy.place(&source, &target).expect("there is room");
        fs::write(&target, "two").expect("writable");
        assert_eq!(fs::read(&source).expect("there"), b"one", "a copy is its own");
        assert!(Placing::Link.place(&folder.path().join("missing"), &target).is_err());
    }
}
