//! Counters.

use std::sync::atomic::{AtomicU64, Ordering};

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
