//! What a run tells of itself, kept until the interpreter asks for it, and the wish to end it.

use endless::line_of;
use endless_carla::client::StopFlag;
use endless_pipeline::{Progress, ProgressEvent};
use std::sync::{
    Mutex, PoisonError,
    atomic::{AtomicU64, Ordering},
};

/// Watches a run.
#[derive(Debug, Default)]
pub(crate) struct Watch {
    stop: StopFlag,
    lines: Mutex<Vec<String>>,
    total: AtomicU64,
    done: AtomicU64,
}

impl Watch {
    /// The flag that ends the run.
    pub(crate) fn stop(&self) -> &StopFlag {
        &self.stop
    }

    /// What was said since somebody asked last, camera frames that are made, and how many there will be.
    pub(crate) fn news(&self) -> (Vec<String>, u64, u64) {
        let lines = std::mem::take(&mut *self.lines.lock().unwrap_or_else(PoisonError::into_inner));
        (lines, self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed))
    }
}

impl Progress for Watch {
    fn event(&self, event: &ProgressEvent<'_>) {
        match event {
            ProgressEvent::Start { estimate, .. } => self.total.store(estimate.camera_frames, Ordering::Relaxed),
            ProgressEvent::Frame { cameras, .. } => {
                self.done.fetch_add(u64::from(*cameras), Ordering::Relaxed);
            }
            _ => {}
        }
        if let Some(line) = line_of(event) {
            self.lines.lock().unwrap_or_else(PoisonError::into_inner).push(line);
        }
    }

    fn is_stopped(&self) -> bool {
        self.stop.is_set()
    }
}
