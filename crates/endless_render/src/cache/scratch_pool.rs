//! Large things that frames hand on to one another, which costs less than fresh ones: each frame puts back the little that it
//! changed, or writes all of it anew. Of very large pictures none are kept: each camera's would wait while another's are in use.

use std::sync::{Mutex, PoisonError};

/// Pixels of pictures that are very large.
const VERY_LARGE: usize = 4_000_000;

/// Those not in use; at most as many as frames are made at once.
#[derive(Debug)]
pub(crate) struct ScratchPool<T> {
    spare: Mutex<Vec<T>>,
    keeps: bool,
}

impl<T> ScratchPool<T> {
    /// For pictures of so many pixels.
    pub(crate) fn for_pixels(pixels: usize) -> Self {
        Self { spare: Mutex::default(), keeps: pixels < VERY_LARGE }
    }

    /// One that is left over, or a fresh one.
    pub(crate) fn take(&self, fresh: impl FnOnce() -> T) -> T {
        let spare = self.spare.lock().unwrap_or_else(PoisonError::into_inner).pop();
        spare.unwrap_or_else(fresh)
    }

    /// Takes one back: as it was, if whoever takes it next relies on that.
    pub(crate) fn give(&self, it: T) {
        if self.keeps {
            self.spare.lock().unwrap_or_else(PoisonError::into_inner).push(it);
        }
    }
}
