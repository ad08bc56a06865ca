//! Who does what next: hands out frames in order, and ordered work when its turn has come.

use crate::Traffic;
use endless_world::WorldState;
use std::{
    collections::BTreeMap,
    sync::{Condvar, Mutex, MutexGuard, PoisonError},
};

/// Something to do.
pub(super) enum Job<T: Split> {
    /// Make this frame.
    Frame(WorldState),
    /// Feed a lane with the item whose turn it is.
    Lane {
        /// Which.
        lane: usize,
        /// With what.
        item: T::Part,
    },
}

/// What a frame delivers: one part a lane.
pub(super) trait Split {
    /// What one lane takes.
    type Part;

    /// One part a lane.
    fn split(self) -> [Self::Part; 2];
}

impl<P> Split for [P; 2] {
    type Part = P;

    fn split(self) -> [P; 2] {
        self
    }
}

/// The board that all workers look at.
pub(super) struct Board<'a, T: Split> {
    state: Mutex<State<'a, T>>,
    changed: Condvar,
    frames: u32,
    window: u32,
}

struct State<'a, T: Split> {
    traffic: Box<dyn Traffic + 'a>,
    /// Frames handed out.
    ticked: u32,
    lanes: [LaneState<T>; 2],
    stopped: bool,
}

struct LaneState<T: Split> {
    /// The frame whose turn it is.
    next: u32,
    busy: bool,
    waiting: BTreeMap<u32, T::Part>,
}

impl<'a, T: Split> Board<'a, T> {
    /// A board of so many frames, of which at most `window` are under way.
    pub(super) fn new(traffic: Box<dyn Traffic + 'a>, frames: u32, window: u32) -> Self {
        let lane = || LaneState { next: 0, busy: false, waiting: BTreeMap::new() };
        let state = State { traffic, ticked: 0, lanes: [lane(), lane()], stopped: false };
        Self { state: Mutex::new(state), changed: Condvar::new(), frames, window }
    }

    /// The next thing to do; waits for it. `None` when everything is done or somebody failed.
    pub(super) fn next(&self, time_tick: &dyn Fn(&mut dyn FnMut())) -> Option<Job<T>> {
        let mut state = self.lock();
        loop {
            if state.stopped {
                return None;
            }
            // Ordered work first: it frees memory.
            for (lane, l) in state.lanes.iter_mut().enumerate() {
                if !l.busy
                    && let Some(item) = l.waiting.remove(&l.next)
                {
                    l.busy = true;
                    return Some(Job::Lane { lane, item });
                }
            }
            let slowest = state.lanes.iter().map(|l| l.next).min().unwrap_or(0);
            if state.ticked < self.frames && state.ticked < slowest + self.window {
                state.ticked += 1;
                let mut world = None;
                time_tick(&mut || world = Some(state.traffic.tick()));
                return world.map(Job::Frame);
            }
            if slowest == self.frames {
                return None;
            }
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// A frame is made.
    pub(super) fn deliver(&self, frame: u32, item: T) {
        let mut state = self.lock();
        for (lane, part) in state.lanes.iter_mut().zip(item.split()) {
            lane.waiting.insert(frame, part);
        }
        drop(state);
        self.changed.notify_all();
    }

    /// A lane took its item.
    pub(super) fn lane_done(&self, lane: usize) {
        let mut state = self.lock();
        state.lanes[lane].busy = false;
        state.lanes[lane].next += 1;
        drop(state);
        self.changed.notify_all();
    }

    /// Nobody shall begin anything more.
    pub(super) fn stop(&self) {
        self.lock().stopped = true;
        self.changed.notify_all();
    }

    /// Stops the others when this thread panics, so that they do not wait for ever.
    pub(super) fn stop_on_panic(&self) -> StopOnPanic<'_, 'a, T> {
        StopOnPanic(self)
    }

    fn lock(&self) -> MutexGuard<'_, State<'a, T>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// See [`Board::stop_on_panic`].
pub(super) struct StopOnPanic<'b, 'a, T: Split>(&'b Board<'a, T>);

impl<T: Split> Drop for StopOnPanic<'_, '_, T> {
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

    struct Count(u32);

    impl Traffic for Count {
        fn tick(&mut self) -> WorldState {
            self.0 += 1;
            WorldState { frame: self.0 - 1, time_s: 0.0, actors: Vec::new(), signals: Vec::new() }
        }
    }

    #[test]
    fn lanes_see_all_frames_in_order_and_few_wait() {
        for threads in [1, 2, 7] {
            let board: Board<'_, [u32; 2]> = Board::new(Box::new(Count(0)), 200, 4);
            let seen = [Mutex::new(Vec::new()), Mutex::new(Vec::new())];
            let (under_way, most) = (AtomicU32::new(0), AtomicU32::new(0));
            std::thread::scope(|scope| {
                for _ in 0..threads {
                    scope.spawn(|| {
                        while let Some(job) = board.next(&|tick| tick()) {
                            match job {
                                Job::Frame(world) => {
                                    let now = under_way.fetch_add(1, Ordering::SeqCst) + 1;
                                    most.fetch_max(now, Ordering::SeqCst);
                                    board.deliver(world.frame, [world.frame; 2]);
                                }
                                Job::Lane { lane, item } => {
                                    seen[lane].lock().expect("unpoisoned").push(item);
                                    if lane == 1 {
                                        under_way.fetch_sub(1, Ordering::SeqCst);
                                    }
                                    board.lane_done(lane);
                                }
                            }
                        }
                    });
                }
            });
            for lane in seen {
                assert_eq!(lane.into_inner().expect("unpoisoned"), (0..200).collect::<Vec<_>>());
            }
            assert!(most.into_inner() <= 5, "at most the window is under way");
        }
    }
}
