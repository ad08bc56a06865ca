//! One frame: the static picture with all moving objects.

use super::affected::affected;
use super::bake::CameraBake;
use super::centre_light::{CentreLight, centre_lights};
use super::coverage::Coverage;
use super::developed_frame::DevelopedFrame;
use super::flow::{FlowPass, NeighbourFrames};
use super::frame_buffer::{FrameBuffer, FramePixel};
use super::mirror::mirrored_row;
use super::pixel::undisturbed;
use super::pixel_centre::{BLOCK, CentreBlock};
use super::row::PixelRow;
use super::tile::TILE;
use super::tile_context::{PixelSamples, TileContext};
use super::tile_coverage::{CoveredPixel, coverages};
use super::tile_work::TileWork;
use crate::scene::{FrameScene, StaticScene};
use crate::shade::{Tracer, shade_moving_together};
use endless_world::SensorFrame;
use rayon::prelude::*;

/// The tiles in which anything can have changed.
fn worked_on(work: &[TileWork]) -> Vec<(u32, &TileWork)> {
    work.iter().enumerate().filter(|(_, work)| !work.is_none()).map(|(tile, work)| (tile as u32, work)).collect()
}

/// Rows of a tile whose light is found together.
const BLOCK_ROWS: usize = BLOCK / TILE as usize;

impl CameraBake {
    /// What the camera sees at an instant; flow is unknown.
    pub fn render(&self, still: &StaticScene, frame: &FrameScene) -> SensorFrame {
        self.render_between(still, frame, NeighbourFrames::default())
    }

    /// The same between two other instants, to which flow leads where it is wanted.
    pub fn render_between(
        &self,
        still: &StaticScene,
        frame: &FrameScene,
        neighbours: NeighbourFrames<'_>,
    ) -> SensorFrame {
        self.finished(self.developed(still, frame), still, frame, neighbours)
    }

    /// The same picture, for which all threads work at once: for who waits for one picture. Of many pictures each is better
    /// left to one thread.
    pub fn render_at_once(
        &self,
        still: &StaticScene,
        frame: &FrameScene,
        neighbours: NeighbourFrames<'_>,
    ) -> SensorFrame {
        self.finished(self.developed_at_once(still, frame), still, frame, neighbours)
    }

    /// The same at an instant at which the light is a share of the way, 0 to 1, from that of this bake to that of the next,
    /// of the same camera: a mixture of both pictures.
    pub fn render_changing(
        &self,
        (next, share): (&Self, f32),
        still: &StaticScene,
        frame: &FrameScene,
        neighbours: NeighbourFrames<'_>,
    ) -> SensorFrame {
        let mixed = self.developed(still, frame).mixed(&next.developed(still, frame), share);
        self.finished(mixed, still, frame, neighbours)
    }

    /// With flow, and with what sensor and recorder do.
    pub(super) fn finished(
        &self,
        developed: DevelopedFrame,
        still: &StaticScene,
        frame: &FrameScene,
        neighbours: NeighbourFrames<'_>,
    ) -> SensorFrame {
        let (sensor, centres) = developed.recorded(self);
        FlowPass { bake: self, still, frame, centres: &centres }.added(sensor, neighbours)
    }

    fn developed(&self, still: &StaticScene, frame: &FrameScene) -> DevelopedFrame {
        self.developed_by(still, frame, |tracer, tiles, buffer| {
            self.render_tiles(tracer, frame, tiles, |place, pixel| buffer.set(self, place, &pixel));
        })
    }

    /// The same by all threads.
    fn developed_at_once(&self, still: &StaticScene, frame: &FrameScene) -> DevelopedFrame {
        /// Tiles that a thread takes on.
        const SHARE: usize = 12;
        self.developed_by(still, frame, |tracer, tiles, buffer| {
            let rendered = tiles.par_chunks(SHARE).with_max_len(1).map(|share| {
                let mut pixels = Vec::new();
                self.render_tiles(tracer, frame, share, |place, pixel| pixels.push((place, pixel)));
                pixels
            });
            for (place, pixel) in rendered.collect::<Vec<_>>().iter().flatten() {
                buffer.set(self, *place, pixel);
            }
        })
    }

    /// `render` draws the tiles that what moves affects.
    fn developed_by(
        &self,
        still: &StaticScene,
        frame: &FrameScene,
        render: impl FnOnce(&Tracer<'_>, &[(u32, &TileWork)], &mut FrameBuffer),
    ) -> DevelopedFrame {
        let tracer = self.lighting.tracer(still, Some(frame));
        let mut buffer = FrameBuffer::new(self);
        let work = affected(self, still, frame);
        render(&tracer, &worked_on(&work), &mut buffer);
        buffer.develop(self, still, frame)
    }

    /// Renders these tiles, one after the other.
    fn render_tiles(
        &self,
        tracer: &Tracer<'_>,
        frame: &FrameScene,
        tiles: &[(u32, &TileWork)],
        mut set: impl FnMut([u32; 2], FramePixel),
    ) {
        let mut rows: Vec<PixelRow<'_>> = (0..TILE).map(|_| PixelRow::new(self)).collect();
        let mut traced = 0;
        for &(tile, work) in tiles {
            let context = TileContext { tracer, frame, work, pixel_angle: self.pixel_angle };
            traced += self.render_tile(&context, tile, &mut rows, &mut set);
        }
        self.stats.add(traced);
    }

    /// Renders a tile; returns about how many rays that took.
    fn render_tile<'a>(
        &'a self,
        context: &TileContext<'_>,
        tile: u32,
        rows: &mut [PixelRow<'a>],
        set: &mut impl FnMut([u32; 2], FramePixel),
    ) -> u64 {
        let TileContext { tracer, frame, work, .. } = *context;
        let columns = self.tiles.tiles().columns;
        let (x0, y0) = (tile % columns * TILE, tile / columns * TILE);
        let (x1, y1) = self.tile_end(x0, y0);
        let count = (x1 - x0) as usize;
        let mut rays = 0;
        for (y, row) in (y0..y1).zip(rows.iter_mut()) {
            let first = (y * self.camera.size.width + x0) as usize;
            let uniform = &self.gbuffer.uniform[first..first + count];
            row.aim(x0, x1, y, !work.needs_rays() && uniform.iter().all(|u| *u));
            rays += row.find(frame, work);
        }
        let rows = &rows[..(y1 - y0) as usize];
        let covered = rows.iter().enumerate().flat_map(|(y, row)| {
            let seen = (0..count).filter(|&x| row.found[x].primary.iter().any(Option::is_some));
            seen.map(move |x| CoveredPixel { place: y * TILE as usize + x, rays: row.rays(x), found: &row.found[x] })
        });
        let coverages = coverages(
            self,
            frame,
            covered,
            |seen| shade_moving_together(tracer, seen, self.pixel_angle),
            |place, seen| self.halo((x0, y0), place, seen),
        );
        let halves = rows.chunks(BLOCK_ROWS).zip(coverages.chunks(BLOCK));
        for (y, (rows, coverages)) in (y0..).step_by(BLOCK_ROWS).zip(halves) {
            self.render_rows(context, (x0, y), rows, coverages, set);
        }
        rays
    }

    /// Renders some rows of a tile, the first of whose pixels is given, and tells what covers their pixels.
    fn render_rows(
        &self,
        context: &TileContext<'_>,
        (x0, y0): (u32, u32),
        rows: &[PixelRow<'_>],
        coverages: &[Coverage],
        set: &mut impl FnMut([u32; 2], FramePixel),
    ) {
        let count = (self.tile_end(x0, y0).0 - x0) as usize;
        let same = |row: &PixelRow<'_>, i: usize| context.work.only_found() && row.found[i].is_nothing();
        let all_same = |row: &PixelRow<'_>| (0..count).all(|i| same(row, i));
        if rows.iter().all(all_same) {
            return;
        }
        let lights = self.centre_lights(context, rows, count);
        for (line, row) in rows.iter().enumerate().filter(|(_, row)| !all_same(row)) {
            let mirrors = mirrored_row(context.tracer, row, self.pixel_angle);
            for i in (0..count).filter(|i| !same(row, *i)) {
                let (index, found, place) = (row.pixel(i), &row.found[i], TILE as usize * line + i);
                let light = Some(&lights[place]).filter(|_| self.gbuffer.uniform[index]);
                if light.is_some_and(CentreLight::is_nothing) && found.is_nothing() {
                    continue;
                }
                let still = row.still(i);
                let pixel = match undisturbed(&still, self.film.radiance[index], light, found) {
                    Some(radiance) => FramePixel { radiance, covered: None, shadow: None, streak: None },
                    None => {
                        let samples = PixelSamples { rays: &row.rays(i), still, found };
                        self.pixel(context, &samples, light, mirrors[i], &coverages[place])
                    }
                };
                set([x0 + i as u32, y0 + line as u32], pixel);
            }
        }
    }

    /// The light that the samples of each uniform pixel of some rows share; pixels that something that moves covers
    /// wholly are left out.
    fn centre_lights(&self, context: &TileContext<'_>, rows: &[PixelRow<'_>], count: usize) -> [CentreLight; BLOCK] {
        let centres: CentreBlock<'_> = std::array::from_fn(|place| {
            let (row, i) = (rows.get(place / TILE as usize)?, place % TILE as usize);
            let index = row.pixel(i);
            if i >= count || !self.gbuffer.uniform[index] || row.found[i].primary.iter().all(Option::is_some) {
                return None;
            }
            Some(row.still(i).centre(&row.ray(i, 0), self.gbuffer.centre_bsdf(index)))
        });
        centre_lights(context, &self.camera, &centres)
    }
}
