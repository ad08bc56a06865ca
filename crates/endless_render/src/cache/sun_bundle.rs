//! Rays from samples to the sun that go together.

use super::sparse_centre::ROWS;
use super::sun_rays::LitPlaces;
use crate::accel::{RayStream, Tlas, lane_mask};
use crate::light::Sun;
use crate::vec3x8::Vec3x8;
use wide::f32x8;

/// Of [`ROWS`] times eight samples.
pub(super) struct SunBundle<'a> {
    sun: &'a Sun,
    rays: RayStream<ROWS>,
    /// Those that ask, a bit each.
    pub(super) asked: u32,
}

impl<'a> SunBundle<'a> {
    /// Nobody asks yet.
    pub(super) fn new(sun: &'a Sun) -> Self {
        Self { sun, rays: RayStream::NONE, asked: 0 }
    }

    /// Some of a row's samples, a bit each, ask along these directions if the sun can light them.
    pub(super) fn ask(&mut self, row: usize, some: u32, places: &LitPlaces, directions: &Vec3x8) {
        let asking = some & places.can_be_lit_by(self.sun);
        if asking == 0 {
            return;
        }
        self.asked |= asking << (8 * row);
        let mask = lane_mask(asking);
        let origins = places.ray_origins(self.sun);
        for k in 0..3 {
            self.rays.origin[k][row] = mask.select(origins[k], self.rays.origin[k][row]);
            self.rays.direction[k][row] = mask.select(directions[k], self.rays.direction[k][row]);
        }
        self.rays.tmax[row] = mask.select(f32x8::splat(f32::MAX), self.rays.tmax[row]);
    }

    /// Those that asked and see it, a bit each.
    pub(super) fn lit(&self, accel: &Tlas) -> u32 {
        if self.asked == 0 { 0 } else { self.asked & !accel.occluded32(&self.rays, self.asked) }
    }
}
