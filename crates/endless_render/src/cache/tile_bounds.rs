//! The bounds of a tile, eight pixels at a time.

use super::bounds8::Bounds8;
use super::gbuffer::GBuffer;
use super::still_pixel::StillPixel;
use super::tile::{TILE, TileBounds};
use crate::accel::{lane_mask, lanes};
use crate::camera_rays::{aims8, places8};
use crate::octahedron::unpack8;
use crate::sampling::SAMPLES;
use crate::vec3x8::Vec3x8;
use endless_world::PinholeCamera;
use wide::f32x8;

const WIDTH: usize = TILE as usize;

/// Those of the tile whose first pixel's column and row are given.
pub(super) fn bounds_of(camera: &PinholeCamera, gbuffer: &GBuffer, (x0, y0): (u32, u32)) -> TileBounds {
    let mut bounds = WideBounds::EMPTY;
    let x1 = (x0 + TILE).min(camera.size.width);
    for y in y0..(y0 + TILE).min(camera.size.height) {
        let first = (y * camera.size.width + x0) as usize;
        let row = TileRow::new(gbuffer, first, (x1 - x0) as usize);
        for sample in 0..SAMPLES {
            let distances = row.distances(sample);
            let seen = distances.simd_ne(f32x8::splat(f32::MAX)).to_bitmask() as u8 & row.own;
            if seen != 0 {
                bounds.add(&row, sample, seen, &places8(camera, &aims8(camera, x0, x1, y, sample), distances));
            }
        }
    }
    bounds.all()
}

/// A row of a tile.
struct TileRow<'a> {
    /// Beyond the picture's edge its last pixel's.
    pixels: [StillPixel<'a>; WIDTH],
    /// Which are the picture's, a bit each.
    own: u8,
    /// Which mirror at all.
    mirroring: u8,
}

impl<'a> TileRow<'a> {
    fn new(gbuffer: &'a GBuffer, first: usize, count: usize) -> Self {
        let pixels: [StillPixel<'a>; WIDTH] = std::array::from_fn(|i| gbuffer.pixel(first + i.min(count - 1)));
        let mirroring = bits_of(&pixels, |pixel| pixel.mirrored != 0);
        Self { pixels, own: u8::MAX >> (WIDTH - count), mirroring }
    }

    fn distances(&self, sample: usize) -> f32x8 {
        f32x8::new(std::array::from_fn(|i| self.pixels[i].distances[sample]))
    }
}

/// The pixels of which something is true, a bit each.
fn bits_of(pixels: &[StillPixel<'_>; WIDTH], is_so: impl Fn(&StillPixel<'_>) -> bool) -> u8 {
    pixels.iter().enumerate().fold(0, |bits, (lane, pixel)| bits | u8::from(is_so(pixel)) << lane)
}

/// [`TileBounds`] of each lane.
struct WideBounds {
    points: Bounds8,
    sunlit: Bounds8,
    mirrors: Bounds8,
    mirror_directions: Bounds8,
    mirror_reach: f32,
    lens: bool,
}

impl WideBounds {
    const EMPTY: Self = Self {
        points: Bounds8::EMPTY,
        sunlit: Bounds8::EMPTY,
        mirrors: Bounds8::EMPTY,
        mirror_directions: Bounds8::EMPTY,
        mirror_reach: 0.0,
        lens: false,
    };

    /// Adds those pixels' samples, a bit each, that see anything.
    fn add(&mut self, row: &TileRow<'_>, sample: usize, seen: u8, positions: &Vec3x8) {
        self.points.add(positions, lane_mask(seen.into()));
        let sunlit = seen & bits_of(&row.pixels, |pixel| pixel.sun_free[sample] != 0);
        if sunlit != 0 {
            self.sunlit.add(positions, lane_mask(sunlit.into()));
        }
        self.lens |= seen & bits_of(&row.pixels, |pixel| pixel.is_lens(sample)) != 0;
        let mirroring = seen & row.mirroring;
        if mirroring != 0 {
            self.add_mirrors(row, sample, mirroring, positions);
        }
    }

    fn add_mirrors(&mut self, row: &TileRow<'_>, sample: usize, pixels: u8, positions: &Vec3x8) {
        let (mut found, mut directions) = (0, [0; WIDTH]);
        for lane in lanes(pixels.into()) {
            if let Some(mirror) = row.pixels[lane].mirror(sample) {
                found |= 1 << lane;
                directions[lane] = mirror.direction;
                self.mirror_reach = self.mirror_reach.max(mirror.reach);
            }
        }
        self.mirrors.add(positions, lane_mask(found));
        self.mirror_directions.add(&unpack8(&directions), lane_mask(found));
    }

    fn all(&self) -> TileBounds {
        TileBounds {
            points: self.points.all(),
            sunlit: self.sunlit.all(),
            mirrors: self.mirrors.all(),
            mirror_directions: self.mirror_directions.all(),
            mirror_reach: self.mirror_reach,
            lens: self.lens,
        }
    }
}
