//! Copies of the still picture that frames hand on to one another: each puts back the little that it changed, which
//! costs less than a fresh copy.

use glam::Vec3A;
use std::sync::{Mutex, PoisonError};

/// Pictures not in use; at most as many as frames are made at once.
#[derive(Debug, Default)]
pub(super) struct Spare(Mutex<Vec<Vec<Vec3A>>>);

impl Spare {
    /// A copy of the still picture.
    pub(super) fn take(&self, still: &[Vec3A]) -> Vec<Vec3A> {
        let spare = self.0.lock().unwrap_or_else(PoisonError::into_inner).pop();
        spare.unwrap_or_else(|| still.to_vec())
    }

    /// Takes a copy back, which must be as it was.
    pub(super) fn give(&self, picture: Vec<Vec3A>) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(picture);
    }
}
