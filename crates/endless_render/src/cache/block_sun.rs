//! The rays from what a block of pixels shows to the sun.

use super::sparse_centre::{FIRST, ROWS};
use super::sun_rays::sun_origins8;
use crate::accel::{RayStream, lane_mask};
use crate::light::Sun;
use crate::vec3x8::{Vec3x8, dot};
use wide::f32x8;

/// Of [`ROWS`] rows of eight pixels.
pub(super) struct BlockSun {
    /// To the sun's middle.
    direction: Vec3x8,
    /// To the first part of its disc.
    pub(super) rays: RayStream<ROWS>,
    /// The pixels that ask, a bit each.
    pub(super) asked: u32,
}

impl BlockSun {
    /// Nobody asks yet.
    pub(super) fn new(sun: &Sun) -> Self {
        let mut rays = RayStream::NONE;
        rays.direction = sun.disc[0][FIRST].to_array().map(|axis| [f32x8::splat(axis); ROWS]);
        rays.tmax = [f32x8::splat(f32::MAX); ROWS];
        Self { direction: sun.direction.to_array().map(f32x8::splat), rays, asked: 0 }
    }

    /// Some places of a row, a bit each, ask, if the sun can light them: from the front, or through a leaf.
    pub(super) fn ask(&mut self, row: usize, own: u8, surface: &Surface8) {
        let Surface8 { positions, normals, distances, is_leaf } = surface;
        let faces = dot(normals, &self.direction).simd_gt(f32x8::ZERO).to_bitmask();
        let asking = if *is_leaf { own.into() } else { faces & u32::from(own) };
        if asking == 0 {
            return;
        }
        self.asked |= asking << (8 * row);
        let mask = lane_mask(asking);
        let origins = sun_origins8(positions, normals, *distances, &self.direction);
        for (all, own) in self.rays.origin.iter_mut().zip(origins) {
            all[row] = mask.select(own, all[row]);
        }
    }
}

/// Eight places of one kind of surface.
pub(super) struct Surface8 {
    pub(super) positions: Vec3x8,
    /// Of their triangles.
    pub(super) normals: Vec3x8,
    /// From where they are seen.
    pub(super) distances: f32x8,
    pub(super) is_leaf: bool,
}
