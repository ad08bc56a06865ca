//! The pixels in whose centre what moves hides what stands still.

use super::bake::CameraBake;
use super::tile::TILE;
use super::visible_tiles::each_visible_tile;
use crate::accel::{RayStream, lanes};
use crate::camera_rays::{aims8, set_row};
use crate::scene::FrameScene;
use std::{ops::Range, sync::OnceLock};
use wide::f32x8;

/// In whose centres a camera sees what moves at one instant: found when it is first needed, and kept for the frames before
/// and after it, both of which need to know.
#[derive(Debug, Default)]
pub struct CoveredCentres(OnceLock<CoveredRows>);

/// A bit for each pixel, by row and by column of tiles.
#[derive(Debug)]
pub(super) struct CoveredRows {
    columns: usize,
    eights: Vec<u8>,
}

/// Rows of a tile whose rays are traced together.
const ROWS: u32 = 4;

impl CoveredCentres {
    pub(super) fn rows(&self, bake: &CameraBake, frame: &FrameScene) -> &CoveredRows {
        self.0.get_or_init(|| CoveredRows::new(bake, frame))
    }
}

impl CoveredRows {
    fn new(bake: &CameraBake, frame: &FrameScene) -> Self {
        let tiles = bake.tiles.tiles();
        let columns = tiles.columns as usize;
        let mut eights = vec![0; columns * bake.camera.size.height as usize];
        let mut visible = vec![false; tiles.bounds.len()];
        each_visible_tile(bake, frame, |tile| visible[tile] = true);
        for tile in (0..visible.len() as u32).filter(|&tile| visible[tile as usize]) {
            let (x0, y0) = (tile % tiles.columns * TILE, tile / tiles.columns * TILE);
            let (x1, y1) = bake.tile_end(x0, y0);
            for y in (y0..y1).step_by(ROWS as usize) {
                let rows = y..y1.min(y + ROWS);
                let active = rows.clone().fold(0, |active, _| active << TILE | ((1u32 << (x1 - x0)) - 1));
                let covered = frame.accel.occluded32(&centre_rays(bake, x0..x1, rows.clone()), active);
                for (y, eight) in rows.zip(covered.to_le_bytes()) {
                    eights[y as usize * columns + (x0 / TILE) as usize] = eight;
                }
            }
        }
        Self { columns, eights }
    }

    /// The pixels, of a picture this wide.
    pub(super) fn pixels(&self, width: usize) -> impl Iterator<Item = usize> {
        let some = self.eights.iter().enumerate().filter(|(_, eight)| **eight != 0);
        some.flat_map(move |(place, &eight)| {
            let first = place / self.columns * width + place % self.columns * TILE as usize;
            lanes(eight.into()).map(move |x| first + x)
        })
    }
}

/// Rays through the centres of pixels, up to where they meet what stands still.
fn centre_rays(bake: &CameraBake, columns: Range<u32>, rows: Range<u32>) -> RayStream<{ ROWS as usize }> {
    let CameraBake { camera, gbuffer, .. } = bake;
    let mut rays = RayStream::NONE;
    for (row, y) in rows.enumerate() {
        set_row(camera, &mut rays, row, aims8(camera, columns.start, columns.end, y, 0));
        let distance = |i: usize| {
            let x = (columns.start + i as u32).min(columns.end - 1);
            // What is no nearer hides nothing.
            gbuffer.distances[(y * camera.size.width + x) as usize][0].next_down()
        };
        rays.tmax[row] = f32x8::new(std::array::from_fn(distance));
    }
    rays
}
