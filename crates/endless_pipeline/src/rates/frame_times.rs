//! When frames are done.

use crate::{Progress, ProgressEvent};
use std::{
    sync::{Mutex, PoisonError},
    time::Instant,
};

/// Passes progress on, and notes when each frame is done.
pub(super) struct FrameTimes<'a> {
    told: &'a dyn Progress,
    done: Mutex<Vec<Instant>>,
}

impl<'a> FrameTimes<'a> {
    pub(super) fn new(told: &'a dyn Progress) -> Self {
        Self { told, done: Mutex::new(Vec::new()) }
    }

    /// Seconds of a frame once all threads are at work; none if there were too few. The first frames make what later ones
    /// find made.
    pub(super) fn steady(&self, threads: usize) -> Option<f64> {
        let mut done = self.done.lock().unwrap_or_else(PoisonError::into_inner).clone();
        done.sort_unstable();
        steady(&done, threads)
    }
}

fn steady(done: &[Instant], threads: usize) -> Option<f64> {
    let first = 2 * threads.max(1) - 1;
    let (begin, end) = (done.get(first)?, done.last()?);
    let frames = done.len() - 1 - first;
    (frames >= threads.max(1)).then(|| (*end - *begin).as_secs_f64() / frames as f64)
}

impl Progress for FrameTimes<'_> {
    fn event(&self, event: &ProgressEvent<'_>) {
        if matches!(event, ProgressEvent::Frame { .. }) {
            self.done.lock().unwrap_or_else(PoisonError::into_inner).push(Instant::now());
        }
        self.told.event(event);
    }

    fn is_stopped(&self) -> bool {
        self.told.is_stopped()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn the_first_frames_do_not_count() {
        let begin = Instant::now();
        let at = |seconds: &[f64]| seconds.iter().map(|s| begin + Duration::from_secs_f64(*s)).collect::<Vec<_>>();
        let done = at(&[5.0, 5.0, 6.0, 6.0, 6.5, 7.0, 7.5, 8.0]);
        assert!((steady(&done, 2).expect("enough") - 0.5).abs() < 1e-9);
        assert_eq!(steady(&done[..5], 2), None, "one frame is too few for two threads");
        assert_eq!(steady(&[], 1), None);
    }
}
