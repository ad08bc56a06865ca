//! What the rays of a block of pixels met, side by side.

use super::sparse_centre::ROWS;
use crate::accel::{StreamHits, lanes};
use wide::f32x8;

/// Hits of [`ROWS`] rows of eight pixels.
pub(super) struct BlockHits {
    /// Which rays met anything, a bit each.
    pub(super) met: u32,
    /// Instance and triangle, in one number.
    triangles: [u64; 8 * ROWS],
    /// By row.
    pub(super) distances: [f32x8; ROWS],
    /// Of each triangle's second and third vertex, by row.
    pub(super) weights: [[f32x8; 2]; ROWS],
}

impl BlockHits {
    /// Of those rays that were asked.
    pub(super) fn new(found: &StreamHits<ROWS>, asked: u32) -> Self {
        let (mut met, mut triangles) = (0, [u64::MAX; 8 * ROWS]);
        let [mut t, mut u, mut v] = [[[0.0; 8]; ROWS]; 3];
        for lane in lanes(asked) {
            let Some(hit) = found.get(lane) else { continue };
            met |= 1 << lane;
            triangles[lane] = u64::from(hit.instance) << 32 | u64::from(hit.triangle);
            let (row, column) = (lane / 8, lane % 8);
            (t[row][column], u[row][column], v[row][column]) = (hit.t, hit.u, hit.v);
        }
        let weights = std::array::from_fn(|row| [f32x8::new(u[row]), f32x8::new(v[row])]);
        Self { met, triangles, distances: t.map(f32x8::new), weights }
    }

    /// The instance and the triangle that a ray met.
    pub(super) fn triangle(&self, lane: usize) -> (u32, u32) {
        ((self.triangles[lane] >> 32) as u32, self.triangles[lane] as u32)
    }

    /// Those of some rays, a bit each, that met the same triangle as the first of them.
    pub(super) fn on_triangle_of_first(&self, some: u32) -> u32 {
        let first = self.triangles[some.trailing_zeros() as usize % self.triangles.len()];
        let alike = |bits: u32, (lane, own): (usize, &u64)| bits | u32::from(*own == first) << lane;
        some & self.triangles.iter().enumerate().fold(0, alike)
    }
}
