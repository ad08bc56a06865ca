//! Traversal by eight rays.

use super::ray::{Hit, Ray};
use super::tlas::Accel;

impl Accel {
    /// [`Accel::closest`] for those of eight rays whose bit is set in `active`; faster when they run side by side.
    pub fn closest8(&self, rays: &[Ray; 8], active: u8) -> [Option<Hit>; 8] {
        std::array::from_fn(|lane| if active >> lane & 1 != 0 { self.closest(&rays[lane]) } else { None })
    }

    /// [`Accel::occluded`] for those of eight rays whose bit is set in `active`, one bit each.
    pub fn occluded8(&self, rays: &[Ray; 8], active: u8) -> u8 {
        (0..8).filter(|lane| active >> lane & 1 != 0 && self.occluded(&rays[*lane])).fold(0, |m, lane| m | 1 << lane)
    }
}
