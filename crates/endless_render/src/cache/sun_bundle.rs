//! Rays from samples to the sun that go together.

use super::sparse_centre::ROWS;
use super::sun_rays::sun_origins8;
use crate::accel::{RayStream, Tlas, lane_mask};
use crate::light::Sun;
use crate::vec3x8::{Vec3x8, dot, splat};
use wide::f32x8;

/// Of [`ROWS`] times eight samples.
pub(super) struct SunBundle<'a> {
    pub(super) sun: &'a Sun,
    /// To its middle.
    to_sun: Vec3x8,
    rays: RayStream<ROWS>,
    /// Those that ask, a bit each.
    pub(super) asked: u32,
}

/// Where eight samples lie.
pub(super) struct LitPlaces {
    pub(super) positions: Vec3x8,
    /// Of their triangles.
    pub(super) normals: Vec3x8,
    /// From where they are seen.
    pub(super) distances: f32x8,
    /// On leaves, a bit each.
    pub(super) is_leaf: u32,
}

impl<'a> SunBundle<'a> {
    /// Nobody asks yet.
    pub(super) fn new(sun: &'a Sun) -> Self {
        Self { sun, to_sun: splat(sun.direction), rays: RayStream::NONE, asked: 0 }
    }

    /// Which of eight normals face it, a bit each.
    pub(super) fn faces(&self, normals: &Vec3x8) -> u32 {
        dot(normals, &self.to_sun).simd_gt(f32x8::ZERO).to_bitmask()
    }

    /// Some of a row's samples, a bit each, ask along these directions if the sun can light them: from the front, or through a
    /// leaf.
    pub(super) fn ask(&mut self, row: usize, some: u32, places: &LitPlaces, directions: &Vec3x8) {
        let LitPlaces { positions, normals, distances, is_leaf } = places;
        let asking = some & (self.faces(normals) | is_leaf);
        if asking == 0 {
            return;
        }
        self.asked |= asking << (8 * row);
        let mask = lane_mask(asking);
        let origins = sun_origins8(positions, normals, *distances, &self.to_sun);
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
