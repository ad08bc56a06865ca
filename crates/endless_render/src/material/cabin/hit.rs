//! What a ray through a pane meets.

use glam::Vec3A;

/// Share of outdoor light that falls on what is inside.
pub(super) const INDOORS: f32 = 0.6;

/// The nearest hit so far.
pub(super) struct CabinHit {
    pub(super) t: f32,
    pub(super) color: Vec3A,
    /// Whether it is a lamp under the roof.
    pub(super) lamp: bool,
    /// Whether it lies beyond the windows across.
    pub(super) outside: bool,
}

impl CabinHit {
    pub(super) fn offer(&mut self, t: f32, color: Vec3A) {
        if t > 0.02 && t < self.t {
            *self = Self { t, color, lamp: false, outside: false };
        }
    }
}
