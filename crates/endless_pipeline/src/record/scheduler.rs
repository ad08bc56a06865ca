//! Schedules the workers: hands out the session that makes the next frame, and ordered work in its order.

use std::{
    collections::BTreeMap,
    sync::{Condvar, Mutex, MutexGuard, PoisonError},
};

/// A job of a worker.
pub(super) enum WorkerJob<S, T> {
    /// Make this frame.
    Frame {
        /// Its number.
        frame: u32,
        /// The session, returned by [`FrameScheduler::return_session`] as soon as the next frame may be begun.
        session: S,
    },
    /// Feed a camera's sink with the item whose turn it is.
    Sink {
        /// Which camera.
        camera: usize,
        /// With what.
        item: T,
    },
}

/// Hands out frames and ordered work to all workers. One worker at a time has the session; a frame brings an item for
/// each camera's sink.
pub(super) struct FrameScheduler<S, T> {
    state: Mutex<SchedulerState<S, T>>,
    changed: Condvar,
    frames: u32,
    window: u32,
}

struct SchedulerState<S, T> {
    /// `None` while a worker has it.
    session: Option<S>,
    /// Frames handed out.
    begun: u32,
    sinks: Vec<SinkQueue<T>>,
    stopped: bool,
}

struct SinkQueue<T> {
    /// The frame whose turn it is.
    next: u32,
    busy: bool,
    waiting: BTreeMap<u32, T>,
}

impl<S, T> FrameScheduler<S, T> {
    /// A schedule of so many frames for so many cameras; at most `window` frames are under way.
    pub(super) fn new(session: S, cameras: usize, frames: u32, window: u32) -> Self {
        let sinks = (0..cameras).map(|_| SinkQueue { next: 0, busy: false, waiting: BTreeMap::new() }).collect();
        let state = SchedulerState { session: Some(session), begun: 0, sinks, stopped: false };
        Self { state: Mutex::new(state), changed: Condvar::new(), frames, window }
    }

    /// The next job; waits for it. `None` when a worker failed, or the last frames are under way and nothing waits: their
    /// workers do what they bring, and who has no job may help them.
    pub(super) fn next(&self) -> Option<WorkerJob<S, T>> {
        let mut state = self.lock();
        loop {
            if state.stopped {
                return None;
            }
            // Ordered work first: it frees memory.
            for (camera, sink) in state.sinks.iter_mut().enumerate() {
                if !sink.busy
                    && let Some(item) = sink.waiting.remove(&sink.next)
                {
                    sink.busy = true;
                    return Some(WorkerJob::Sink { camera, item });
                }
            }
            let frame = state.begun;
            if frame == self.frames {
                return None;
            }
            let slowest = state.sinks.iter().map(|s| s.next).min().unwrap_or(0);
            if frame < slowest.saturating_add(self.window)
                && let Some(session) = state.session.take()
            {
                state.begun += 1;
                return Some(WorkerJob::Frame { frame, session });
            }
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// The next frame may be begun.
    pub(super) fn return_session(&self, session: S) {
        self.lock().session = Some(session);
        self.changed.notify_all();
    }

    /// A frame is made: one item a camera.
    pub(super) fn deliver(&self, frame: u32, items: Vec<T>) {
        let mut state = self.lock();
        for (sink, item) in state.sinks.iter_mut().zip(items) {
            sink.waiting.insert(frame, item);
        }
        drop(state);
        self.changed.notify_all();
    }

    /// A camera's sink took its item.
    pub(super) fn sink_done(&self, camera: usize) {
        let mut state = self.lock();
        state.sinks[camera].busy = false;
        state.sinks[camera].next += 1;
        drop(state);
        self.changed.notify_all();
    }

    /// Nobody shall begin anything more.
    pub(super) fn stop(&self) {
        self.lock().stopped = true;
        self.changed.notify_all();
    }

    /// Stops the others when this thread panics, so that they do not wait for ever.
    pub(super) fn stop_on_panic(&self) -> StopOnPanic<'_, S, T> {
        StopOnPanic(self)
    }

    /// The session, when all workers are done; `None` where one of them failed with it.
    pub(super) fn into_session(self) -> Option<S> {
        self.state.into_inner().unwrap_or_else(PoisonError::into_inner).session
    }

    fn lock(&self) -> MutexGuard<'_, SchedulerState<S, T>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// See [`FrameScheduler::stop_on_panic`].
pub(super) struct StopOnPanic<'s, S, T>(&'s FrameScheduler<S, T>);

impl<S, T> Drop for StopOnPanic<'_, S, T> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.stop();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicU32, Ordering};

    #[test]
    fn sinks_take_all_frames_in_order_and_few_wait() {
        for (threads, cameras) in [(1, 2), (2, 1), (7, 2), (7, 5)] {
            // The session counts the frames itself.
            let scheduler = FrameScheduler::new(0u32, cameras, 200, 4);
            let taken: Vec<Mutex<Vec<u32>>> = (0..cameras).map(|_| Mutex::default()).collect();
            let (under_way, most) = (AtomicU32::new(0), AtomicU32::new(0));
            std::thread::scope(|scope| {
                for _ in 0..threads {
                    scope.spawn(|| {
                        while let Some(job) = scheduler.next() {
                            match job {
                                WorkerJob::Frame { frame, session } => {
                                    assert_eq!(session, frame, "one worker at a time has the session");
                                    let now = under_way.fetch_add(1, Ordering::SeqCst) + 1;
                                    most.fetch_max(now, Ordering::SeqCst);
                                    scheduler.return_session(session + 1);
                                    scheduler.deliver(frame, vec![frame; cameras]);
                                }
                                WorkerJob::Sink { camera, item } => {
                                    taken[camera].lock().expect("unpoisoned").push(item);
                                    if camera == cameras - 1 {
                                        under_way.fetch_sub(1, Ordering::SeqCst);
                                    }
                                    scheduler.sink_done(camera);
                                }
                            }
                        }
                    });
                }
            });
            for frames in taken {
                assert_eq!(frames.into_inner().expect("unpoisoned"), (0..200).collect::<Vec<_>>());
            }
            assert!(most.into_inner() <= 5, "at most the window is under way");
            assert_eq!(scheduler.into_session(), Some(200));
        }
    }
}
