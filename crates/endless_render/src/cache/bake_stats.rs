//! Counters.

use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

/// Rays traced, for reports.
#[derive(Debug, Default)]
pub struct BakeStats {
    rays: AtomicU64,
}

impl BakeStats {
    /// Rays traced since the bake began, indirect ones counted with their shadow rays; an estimate from the counts of samples.
    pub fn rays(&self) -> u64 {
        self.rays.load(Ordering::Relaxed)
    }

    pub(super) fn add(&self, rays: u64) {
        self.rays.fetch_add(rays, Ordering::Relaxed);
    }
}

/// Does a stage of a bake and tells `-v` how long it took.
pub(super) fn timed<R>(stage: &'static str, work: impl FnOnce() -> R) -> R {
    let start = Instant::now();
    let result = work();
    tracing::debug!(bake = stage, seconds = start.elapsed().as_secs_f64());
    result
}
