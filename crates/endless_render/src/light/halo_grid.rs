//! Halos of lamps in the air between camera and moving objects, on a coarse grid over picture and distance.

use endless_world::math::UnfusedVec3A;
use glam::Vec3A;
use rayon::prelude::*;
use wide::f32x8;

/// Pixels between grid points.
const STEP: u32 = 8;
/// Distances of the slices from the camera, metres.
const SLICES_M: [f32; 16] =
    [3.0, 6.0, 10.0, 15.0, 21.0, 28.0, 37.0, 48.0, 58.0, 68.0, 80.0, 92.0, 105.0, 118.0, 133.0, 150.0];

/// Light scattered into view rays up to each slice.
pub(crate) struct HaloGrid {
    columns: usize,
    light: Vec<[Vec3A; SLICES_M.len()]>,
}

impl HaloGrid {
    /// Fills the grid: `halo(x, y, distances)` is the light of the ray through a place of the picture.
    pub(crate) fn bake(width: u32, height: u32, halo: impl Fn(f32, f32, f32x8) -> [Vec3A; 8] + Sync) -> Self {
        let (columns, rows) = ((width.div_ceil(STEP) + 1) as usize, (height.div_ceil(STEP) + 1) as usize);
        let light = (0..columns * rows)
            .into_par_iter()
            .map(|i| {
                let (x, y) = ((i % columns) as f32 * STEP as f32, (i / columns) as f32 * STEP as f32);
                let eights = SLICES_M.as_chunks().0;
                let light = [0, 1].map(|half: usize| halo(x, y, f32x8::new(eights[half])));
                std::array::from_fn(|slice| light[slice / 8][slice % 8])
            })
            .collect();
        Self { columns, light }
    }

    /// Light scattered into the ray through a pixel's centre, up to a distance.
    pub(crate) fn at(&self, x: u32, y: u32, distance: f32) -> Vec3A {
        let place = |i: u32| ((i / STEP) as usize, ((i % STEP) as f32 + 0.5) / STEP as f32);
        let ((column, u), (row, v)) = (place(x), place(y));
        let far = SLICES_M.partition_point(|&d| d < distance).min(SLICES_M.len() - 1);
        let near_m = if far == 0 { 0.0 } else { SLICES_M[far - 1] };
        let w = ((distance - near_m) / (SLICES_M[far] - near_m)).min(1.0);
        let point = |dx: usize, dy: usize| {
            let slices = &self.light[(row + dy) * self.columns + column + dx];
            let near = if far == 0 { Vec3A::ZERO } else { slices[far - 1] };
            near.lerp_unfused(slices[far], w)
        };
        point(0, 0).lerp_unfused(point(1, 0), u).lerp_unfused(point(0, 1).lerp_unfused(point(1, 1), u), v)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_linear_between_grid_points_comes_back() {
        let light = |x: f32, y: f32, d: f32| Vec3A::new(x, y, d);
        let grid = HaloGrid::bake(61, 47, |x, y, distances| distances.to_array().map(|d| light(x, y, d)));
        for (x, y, d) in [(0, 0, 1.0), (60, 46, 20.0), (13, 29, 100.0), (8, 8, 150.0)] {
            let expected = light(x as f32 + 0.5, y as f32 + 0.5, d);
            // Up to the first slice, light grows from nothing.
            let share = (d / SLICES_M[0]).min(1.0);
            let expected = Vec3A::new(expected.x * share, expected.y * share, expected.z);
            assert!(grid.at(x, y, d).distance(expected) < 1e-3, "{x} {y} {d}");
        }
        assert_eq!(grid.at(3, 3, 1000.0), grid.at(3, 3, 150.0));
    }
}
