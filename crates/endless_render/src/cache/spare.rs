//! Large buffers that frames hand on to one another: fresh memory costs more to map than to fill.

use glam::Vec3A;
use std::sync::{Mutex, PoisonError};

/// Pictures not in use; at most as many as frames are made at once.
#[derive(Debug, Default)]
pub(super) struct Spare(Mutex<Vec<Vec<Vec3A>>>);

impl Spare {
    /// A copy of a picture.
    pub(super) fn copy(&self, of: &[Vec3A]) -> Vec<Vec3A> {
        let spare = self.0.lock().unwrap_or_else(PoisonError::into_inner).pop();
        let mut picture = spare.unwrap_or_default();
        picture.clear();
        picture.extend_from_slice(of);
        picture
    }

    /// Takes a picture back.
    pub(super) fn give(&self, picture: Vec<Vec3A>) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(picture);
    }
}
