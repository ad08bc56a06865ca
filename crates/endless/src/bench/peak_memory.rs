//! The most memory that the program held at once. Linux counts it; elsewhere nobody says.

use std::fs;

/// Since the program began, or since [`forget`]; megabytes (of 2²⁰ bytes).
pub(super) fn megabytes() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"))?;
    line.split_whitespace().next()?.parse::<f64>().ok().map(|kb| kb / 1024.0)
}

/// Begins again with what is held now. Where the system does not allow that, the peak goes on.
pub(super) fn forget() {
    let _ = fs::write("/proc/self/clear_refs", "5");
}
