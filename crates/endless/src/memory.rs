//! The memory that the program holds. Linux counts it; elsewhere nobody says.

use std::fs;

/// The most since the program began, or since [`forget_peak`]; megabytes (of 2²⁰ bytes).
pub(crate) fn peak_megabytes() -> Option<f64> {
    status("VmHWM:")
}

/// At this instant, megabytes.
pub(crate) fn megabytes() -> Option<f64> {
    status("VmRSS:")
}

fn status(field: &str) -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(field))?;
    line.split_whitespace().next()?.parse::<f64>().ok().map(|kb| kb / 1024.0)
}

/// Begins again with what is held now. Where the system does not allow that, the peak goes on.
pub(crate) fn forget_peak() {
    let _ = fs::write("/proc/self/clear_refs", "5");
}
