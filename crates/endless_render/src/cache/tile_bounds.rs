//! The bounds of a tile, eight pixels at a time.

use super::bounds8::Bounds8;
use super::gbuffer::GBuffer;
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
        let distances = distances_of(&gbuffer.distances[first..first + (x1 - x0) as usize]);
        let seen = distances.map(|distances| distances.simd_ne(f32x8::splat(f32::MAX)).to_bitmask());
        if seen == [0; SAMPLES] {
            continue;
        }
        let row = TileRow::new(gbuffer, first, (x1 - x0) as usize);
        for (sample, (distances, seen)) in
            distances.into_iter().zip(seen).enumerate().filter(|(_, (_, seen))| *seen != 0)
        {
            bounds.add(&row, sample, seen, &places8(camera, &aims8(camera, x0, x1, y, sample), distances));
        }
    }
    bounds.all()
}

/// The distances of up to eight pixels, by sample; beyond them those of the sky.
fn distances_of(pixels: &[[f32; SAMPLES]]) -> [f32x8; SAMPLES] {
    let mut all = [[f32::MAX; WIDTH]; SAMPLES];
    for (lane, own) in pixels.iter().enumerate() {
        for (all, &own) in all.iter_mut().zip(own) {
            all[lane] = own;
        }
    }
    all.map(f32x8::new)
}

/// A row of a tile.
struct TileRow<'a> {
    gbuffer: &'a GBuffer,
    first: usize,
    /// Pixels that the sun reaches, by sample, a bit each.
    sunlit: [u32; SAMPLES],
    /// Pixels that mirror at all, a bit each.
    mirroring: u32,
    /// Some sample is a traffic light's lens.
    lens: bool,
}

impl<'a> TileRow<'a> {
    fn new(gbuffer: &'a GBuffer, first: usize, count: usize) -> Self {
        let [mirroring, lenses] = gbuffer.mirroring_and_lenses(first, count);
        let mut sunlit = [0; SAMPLES];
        for (lane, free) in gbuffer.sun_free[first..first + count].iter().enumerate() {
            for (sunlit, free) in sunlit.iter_mut().zip(free) {
                *sunlit |= u32::from(*free != 0) << lane;
            }
        }
        let lens = lenses != 0;
        Self { gbuffer, first, sunlit, mirroring, lens }
    }
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

    /// Adds the places of those pixels' samples, a bit each, that see anything.
    fn add(&mut self, row: &TileRow<'_>, sample: usize, seen: u32, places: &Vec3x8) {
        self.lens |= row.lens;
        self.points.add(places, lane_mask(seen));
        let sunlit = seen & row.sunlit[sample];
        if sunlit != 0 {
            self.sunlit.add(places, lane_mask(sunlit));
        }
        let mirroring = seen & row.mirroring;
        if mirroring != 0 {
            self.add_mirrors(row, sample, mirroring, places);
        }
    }

    fn add_mirrors(&mut self, row: &TileRow<'_>, sample: usize, pixels: u32, places: &Vec3x8) {
        let (mut found, mut directions) = (0, [0; WIDTH]);
        for lane in lanes(pixels) {
            if let Some(mirror) = row.gbuffer.pixel(row.first + lane).mirror(sample) {
                found |= 1 << lane;
                directions[lane % WIDTH] = mirror.direction;
                self.mirror_reach = self.mirror_reach.max(mirror.reach);
            }
        }
        if found != 0 {
            self.mirrors.add(places, lane_mask(found));
            self.mirror_directions.add(&unpack8(&directions), lane_mask(found));
        }
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
