//! Tiles of pixels, and larger areas above them, which are tested for changes first.

use super::gbuffer::GBuffer;
use super::tile::{TILE, TileBounds, TileRayBounds};
use super::tile_bounds::bounds_of;
use endless_world::PinholeCamera;
use glam::Vec3A;
use rayon::prelude::*;

/// Areas along the edge of one of the level above.
pub(super) const FACTOR: u32 = 4;

/// Bounds of the tiles of a fixed camera's picture, and of ever larger areas of it.
pub(super) struct TileHierarchy {
    /// Tiles first; at last the whole picture.
    pub(super) levels: Vec<TileLevel>,
    /// Height of the lowest surface in view.
    pub(super) lowest: f32,
}

/// Areas of the picture, row by row.
pub(super) struct TileLevel {
    pub(super) bounds: Vec<TileBounds>,
    /// The rays that leave each in every frame.
    pub(super) rays: Vec<TileRayBounds>,
    pub(super) columns: u32,
    pub(super) rows: u32,
}

impl TileLevel {
    fn new(bounds: Vec<TileBounds>, columns: u32, rows: u32, sun: Option<Vec3A>) -> Self {
        let rays = bounds.iter().map(|b| b.ray_bounds(sun)).collect();
        Self { bounds, rays, columns, rows }
    }

    /// The level above.
    fn joined(&self, sun: Option<Vec3A>) -> Self {
        let (columns, rows) = (self.columns.div_ceil(FACTOR), self.rows.div_ceil(FACTOR));
        let mut bounds = vec![TileBounds::EMPTY; (columns * rows) as usize];
        for (i, area) in self.bounds.iter().enumerate() {
            let (x, y) = (i as u32 % self.columns / FACTOR, i as u32 / self.columns / FACTOR);
            bounds[(y * columns + x) as usize].join(area);
        }
        Self::new(bounds, columns, rows, sun)
    }
}

impl TileHierarchy {
    /// Over these samples; `sun` is the direction to it, where it shines.
    pub(super) fn new(camera: &PinholeCamera, gbuffer: &GBuffer, sun: Option<Vec3A>) -> Self {
        let (columns, rows) = (camera.size.width.div_ceil(TILE), camera.size.height.div_ceil(TILE));
        let of_tile = |tile: u32| bounds_of(camera, gbuffer, (tile % columns * TILE, tile / columns * TILE));
        let tiles: Vec<TileBounds> = (0..columns * rows).into_par_iter().map(of_tile).collect();
        let lowest = tiles.iter().map(|b| b.points.low.z).fold(f32::INFINITY, f32::min);
        let mut levels = vec![TileLevel::new(tiles, columns, rows, sun)];
        while let Some(level) = levels.last().filter(|level| level.bounds.len() > 1) {
            levels.push(level.joined(sun));
        }
        Self { levels, lowest }
    }

    /// The tiles themselves.
    pub(super) fn tiles(&self) -> &TileLevel {
        &self.levels[0]
    }
}
