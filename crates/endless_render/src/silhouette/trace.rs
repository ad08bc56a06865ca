//! The pixels that an object covers by itself.

use super::ObjectShape;
use crate::accel::RayStream;
use crate::camera_rays::{aims8, set_row};
use endless_world::{Lens, PinholeCamera};
use wide::f32x8;

/// Rows of pixels that are asked together.
const ROWS: u32 = 4;

impl ObjectShape {
    /// Those of the `asked` pixels, by row-major index, whose centres' rays meet the object. Ascending within each row of
    /// four, not from row to row.
    pub fn covers(&self, camera: &PinholeCamera, asked: impl Fn(usize) -> bool) -> Vec<u32> {
        let mut found = Vec::new();
        let Some([x0, y0, x1, y1]) = self.rows_and_columns(camera) else { return found };
        for y in (y0..y1).step_by(ROWS as usize) {
            for x in (x0..x1).step_by(8) {
                let block = PixelBlock { camera, x, y, x_end: x1.min(x + 8), y_end: y1.min(y + ROWS) };
                let active = block.lanes(&asked);
                if active != 0 {
                    let hit = self.accel.occluded32(&block.rays(), active);
                    found.extend(block.pixels(hit));
                }
            }
        }
        found
    }

    /// The part of the picture that it can cover: first and end columns and rows, `[x0, y0, x1, y1]`.
    fn rows_and_columns(&self, camera: &PinholeCamera) -> Option<[u32; 4]> {
        let (width, height) = (camera.size.width, camera.size.height);
        let Some([left, top, right, bottom]) = self.rough_image_bounds(camera) else {
            return matches!(camera.lens, Lens::Perspective(_)).then_some([0, 0, width, height]);
        };
        // Lines bend a little through a lens: two pixels more than the corners say.
        let first = |low: f32| (low - 2.0).max(0.0) as u32;
        let end = |high: f32, size: u32| ((high + 3.0).max(0.0) as u32).min(size);
        let [x0, y0, x1, y1] = [first(left), first(top), end(right, width), end(bottom, height)];
        (x0 < x1 && y0 < y1).then_some([x0, y0, x1, y1])
    }
}

/// Up to eight columns and four rows of pixels.
struct PixelBlock<'a> {
    camera: &'a PinholeCamera,
    x: u32,
    y: u32,
    x_end: u32,
    y_end: u32,
}

impl PixelBlock<'_> {
    fn index(&self, lane: u32) -> usize {
        (self.y + lane / 8) as usize * self.camera.size.width as usize + (self.x + lane % 8) as usize
    }

    /// The pixels that are asked, a bit each: lane `8 × row + column`.
    fn lanes(&self, asked: impl Fn(usize) -> bool) -> u32 {
        let inside = |lane: u32| self.x + lane % 8 < self.x_end && self.y + lane / 8 < self.y_end;
        (0..8 * ROWS).filter(|&lane| inside(lane) && asked(self.index(lane))).fold(0, |bits, lane| bits | 1 << lane)
    }

    /// The rays through their centres.
    fn rays(&self) -> RayStream<{ ROWS as usize }> {
        let mut rays = RayStream::NONE;
        rays.tmax = [f32x8::splat(f32::MAX); ROWS as usize];
        for row in 0..ROWS {
            let y = (self.y + row).min(self.y_end - 1);
            set_row(self.camera, &mut rays, row as usize, aims8(self.camera, self.x, self.x_end, y, CENTRE));
        }
        rays
    }

    /// Those of a mask.
    fn pixels(&self, mask: u32) -> impl Iterator<Item = u32> {
        (0..8 * ROWS).filter(move |lane| mask >> lane & 1 == 1).map(|lane| self.index(lane) as u32)
    }
}

/// The sample at a pixel's centre, by which the instance image is made.
const CENTRE: usize = 0;
