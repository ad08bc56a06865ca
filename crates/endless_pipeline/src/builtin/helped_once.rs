//! A value made once, by a thread that the others of its pool help.

use rayon::Yield;
use std::{
    sync::{
        OnceLock,
        atomic::{AtomicBool, Ordering},
    },
    thread,
    time::Duration,
};

/// A cell that is written once. Who waits for it does the parallel work of the pool meanwhile, where `OnceLock` would
/// make all threads but one stand still. What makes the value must not ask for it.
#[derive(Debug)]
pub(super) struct HelpedOnce<T> {
    value: OnceLock<T>,
    /// Whether a thread is making it.
    claimed: AtomicBool,
}

impl<T> HelpedOnce<T> {
    /// The value, if it is made.
    pub(super) fn get(&self) -> Option<&T> {
        self.value.get()
    }

    /// The value, made now if nobody makes it.
    pub(super) fn get_or_make(&self, make: impl FnOnce() -> T) -> &T {
        loop {
            if let Some(value) = self.value.get() {
                return value;
            }
            if !self.claimed.swap(true, Ordering::AcqRel) {
                let _given_up_on_panic = Claim(&self.claimed);
                return self.value.get_or_init(make);
            }
            if rayon::yield_now() != Some(Yield::Executed) {
                thread::sleep(Duration::from_millis(1));
            }
        }
    }
}

impl<T> Default for HelpedOnce<T> {
    fn default() -> Self {
        Self { value: OnceLock::new(), claimed: AtomicBool::new(false) }
    }
}

/// Another thread may try when this one is done, or has panicked.
struct Claim<'a>(&'a AtomicBool);

impl Drop for Claim<'_> {
    fn drop(&mut self) {
        self.0.store(false, Ordering::Release);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rayon::prelude::*;
    use std::sync::atomic::AtomicU32;

    #[test]
    fn it_is_made_once_and_all_threads_work_on_it() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(4).build().expect("threads");
        let (cell, made) = (HelpedOnce::default(), AtomicU32::new(0));
        let helpers = pool.broadcast(|_| {
            let threads: &Vec<usize> = cell.get_or_make(|| {
                made.fetch_add(1, Ordering::SeqCst);
                let at_work = |_| {
                    thread::sleep(Duration::from_millis(2));
                    rayon::current_thread_index().expect("in the pool")
                };
                (0..200).into_par_iter().map(at_work).collect()
            });
            (0..4).filter(|t| threads.contains(t)).count()
        });
        assert_eq!(made.into_inner(), 1);
        assert!(helpers[0] > 1, "only the thread that makes it works");
    }

    #[test]
    fn a_panic_leaves_it_to_the_next() {
        let cell = HelpedOnce::default();
        let broken = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            cell.get_or_make(|| -> u32 { panic!("as wanted") });
        }));
        assert!(broken.is_err() && cell.get().is_none());
        assert_eq!(*cell.get_or_make(|| 7), 7);
    }
}
