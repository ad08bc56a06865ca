//! Large things that frames hand on to one another: each puts back the little that it changed, which costs less than
//! fresh ones.

use std::sync::{Mutex, PoisonError};

/// Those not in use; at most as many as frames are made at once.
#[derive(Debug)]
pub(super) struct ScratchPool<T>(Mutex<Vec<T>>);

impl<T> Default for ScratchPool<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<T> ScratchPool<T> {
    /// One that is left over, or a fresh one.
    pub(super) fn take(&self, fresh: impl FnOnce() -> T) -> T {
        let spare = self.0.lock().unwrap_or_else(PoisonError::into_inner).pop();
        spare.unwrap_or_else(fresh)
    }

    /// Takes one back, which must be as it was.
    pub(super) fn give(&self, it: T) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(it);
    }
}
