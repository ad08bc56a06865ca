//! The rays from samples between the centres of pixels to the first part of the sun's disc.

use super::sparse_centre::{FIRST, ROWS};
use super::sun_rays::sun_origins8;
use crate::accel::{RayStream, Tlas, lane_mask};
use crate::light::Sun;
use crate::vec3x8::{Vec3x8, dot, side_by_side};
use wide::f32x8;

/// Of [`ROWS`] times eight samples.
pub(super) struct SampleSun<'a> {
    sun: &'a Sun,
    rays: RayStream<ROWS>,
    /// Those that ask, a bit each.
    asked: u32,
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

impl<'a> SampleSun<'a> {
    /// Nobody asks yet.
    pub(super) fn new(sun: &'a Sun) -> Self {
        Self { sun, rays: RayStream::NONE, asked: 0 }
    }

    /// Which of eight normals face it, a bit each.
    pub(super) fn faces(&self, normals: &Vec3x8) -> u32 {
        dot(normals, &self.sun.direction.to_array().map(f32x8::splat)).simd_gt(f32x8::ZERO).to_bitmask()
    }

    /// Some of eight samples, a bit each, ask if the sun can light them: from the front, or through a leaf.
    pub(super) fn ask(&mut self, row: usize, some: u32, samples: [usize; 8], places: &LitPlaces) {
        let LitPlaces { positions, normals, distances, is_leaf } = places;
        let to_sun = self.sun.direction.to_array().map(f32x8::splat);
        let asking = some & (self.faces(normals) | is_leaf);
        if asking == 0 {
            return;
        }
        self.asked |= asking << (8 * row);
        let mask = lane_mask(asking);
        let origins = sun_origins8(positions, normals, *distances, &to_sun);
        let directions = side_by_side(samples.map(|sample| self.sun.disc[sample][FIRST]));
        for k in 0..3 {
            self.rays.origin[k][row] = mask & origins[k];
            self.rays.direction[k][row] = mask & directions[k];
        }
        self.rays.tmax[row] = mask & f32x8::splat(f32::MAX);
    }

    /// Those that asked and see it, a bit each.
    pub(super) fn lit(&self, accel: &Tlas) -> u32 {
        if self.asked == 0 { 0 } else { self.asked & !accel.occluded32(&self.rays, self.asked) }
    }
}
