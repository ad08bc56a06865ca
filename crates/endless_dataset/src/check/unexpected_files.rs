//! Files that do not belong to a dataset.

use super::report::Finding;
use crate::{listing::list, temporary::is_temporary};
use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
};

/// The unexpected files of a folder.
pub(super) fn unexpected_files(folder: &Path, expected: &BTreeSet<String>) -> Vec<Finding> {
    let Ok(found) = list(folder) else {
        return vec![Finding::new(folder, "cannot be read")];
    };
    let stranger = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        !expected.contains(name.as_ref())
    };
    let describe = |path: PathBuf| {
        let half = is_temporary(&path);
        let problem =
            if half { "is left from a killed run: run the same command again" } else { "does not belong here" };
        Finding::new(path, problem)
    };
    found.into_iter().filter(stranger).map(describe).collect()
}
