//! Names of files that are being written.

use std::path::Path;

const SUFFIX: &str = ".tmp";

/// The name that a file has until it is whole.
pub(crate) fn temporary_name(name: &str) -> String {
    format!(".{name}{SUFFIX}")
}

/// Whether this is the name of a file that is being written.
pub(crate) fn is_temporary(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    name.starts_with('.') && name.ends_with(SUFFIX)
}
