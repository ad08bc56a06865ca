//! Boxes around runs of neighbouring faces: most regions that are drawn on a body are far from most of it.

use super::face::Face;
use glam::Vec3;

/// Faces in a run.
pub(super) const RUN: usize = 32;
/// Boxes must lie this far beyond a plane: no rounding puts a face on the other side, metres.
const MARGIN_M: f32 = 1e-3;

/// A box around each run of a list of faces, or a larger one.
#[derive(Debug, Clone, Default)]
pub(super) struct Runs {
    boxes: Vec<(Vec3, Vec3)>,
    /// Faces that lie in the boxes; those behind them are not known yet.
    known: usize,
}

impl Runs {
    /// After faces have moved.
    pub(super) fn forget(&mut self) {
        self.boxes.clear();
        self.known = 0;
    }

    /// After faces have been added behind the others.
    pub(super) fn learn(&mut self, faces: &[Face]) {
        self.boxes.resize(faces.len().div_ceil(RUN), (Vec3::INFINITY, Vec3::NEG_INFINITY));
        for (i, face) in faces.iter().enumerate().skip(self.known) {
            self.widen(i, face);
        }
        self.known = faces.len();
    }

    /// After a face has been removed and the last has taken its place.
    pub(super) fn removed(&mut self, i: usize, faces: &[Face]) {
        if let Some(face) = faces.get(i) {
            self.widen(i, face);
        }
        self.known = faces.len();
    }

    fn widen(&mut self, i: usize, face: &Face) {
        let (low, high) = &mut self.boxes[i / RUN];
        for p in face.corners {
            (*low, *high) = (low.min(p), high.max(p));
        }
    }

    /// Whether the run that begins with a face lies beyond a plane, where `normal · p` is larger than `offset`.
    pub(super) fn is_beyond(&self, first: usize, (normal, offset): (Vec3, f32)) -> bool {
        let (low, high) = self.boxes[first / RUN];
        let nearest = Vec3::select(normal.cmpge(Vec3::ZERO), low, high);
        normal.dot(nearest) >= offset + MARGIN_M
    }
}
