//! Progress of a check.

use std::sync::atomic::{AtomicU64, Ordering};

/// Counts frames that are done.
pub(super) struct CheckProgress<'a> {
    done: AtomicU64,
    total: u64,
    listener: Option<&'a (dyn Fn(u64, u64) + Sync)>,
}

impl<'a> CheckProgress<'a> {
    pub(super) fn new(total: u64, listener: Option<&'a (dyn Fn(u64, u64) + Sync)>) -> Self {
        Self { done: AtomicU64::new(0), total, listener }
    }

    /// So many more are done.
    pub(super) fn add(&self, frames: u64) {
        let done = self.done.fetch_add(frames, Ordering::Relaxed) + frames;
        if let Some(listener) = self.listener {
            listener(done, self.total);
        }
    }
}
