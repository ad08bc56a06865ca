//! One frame: the static picture with all moving objects.

use super::affected::affected;
use super::bake::CameraBake;
use super::centre_light::{CentreLight, centre_lights};
use super::frame_buffer::{FrameBuffer, FramePixel};
use super::mirror::mirrored_row;
use super::pixel::undisturbed;
use super::pixel_centre::PixelCentre;
use super::row::PixelRow;
use super::tile::TILE;
use super::tile_context::{PixelSamples, TileContext};
use super::tile_coverage::{CoveredPixel, coverages};
use crate::scene::{FrameScene, StaticScene};
use crate::shade::shade_moving_together;
use endless_world::SensorFrame;
use glam::Vec3A;

impl CameraBake {
    /// What the camera sees at an instant.
    pub fn render(&self, still: &StaticScene, frame: &FrameScene) -> SensorFrame {
        let tracer = self.lighting.tracer(still, Some(frame));
        let mut buffer = FrameBuffer::new(self);
        let mut rows: Vec<PixelRow<'_>> = (0..TILE).map(|_| PixelRow::new(self)).collect();
        let mut traced = 0;
        for (tile, work) in affected(self, still, frame).iter().enumerate() {
            if !work.is_none() {
                let context = TileContext { tracer: &tracer, frame, work, pixel_angle: self.pixel_angle };
                traced += self.render_tile(&context, tile as u32, &mut rows, &mut buffer);
            }
        }
        self.stats.add(traced);
        buffer.develop(self, frame.frame)
    }

    /// Renders a tile; returns about how many rays that took.
    fn render_tile<'a>(
        &'a self,
        context: &TileContext<'_>,
        tile: u32,
        rows: &mut [PixelRow<'a>],
        buffer: &mut FrameBuffer,
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
        for ((y, row), coverages) in (y0..).zip(rows).zip(coverages.chunks(TILE as usize)) {
            let same = |i: usize| work.only_found() && row.found[i].is_nothing();
            if (0..count).all(same) {
                continue;
            }
            let lights = self.centre_lights(context, row, count);
            let mirrors = mirrored_row(tracer, row, self.pixel_angle);
            for x in x0..x1 {
                let i = (x - x0) as usize;
                if same(i) {
                    continue;
                }
                let (index, found) = (row.pixel(i), &row.found[i]);
                let light = Some(&lights[i]).filter(|_| self.gbuffer.uniform[index]);
                if light.is_some_and(CentreLight::is_nothing) && found.is_nothing() {
                    continue;
                }
                let still = row.still(i);
                let pixel = match undisturbed(&still, self.film.radiance[index], light, found) {
                    Some(radiance) => FramePixel { radiance, covered: None, streak: None },
                    None => {
                        let samples = PixelSamples { rays: &row.rays(i), still, found };
                        self.pixel(context, &samples, light, mirrors[i], &coverages[i])
                    }
                };
                buffer.set(self, x, y, &pixel);
            }
        }
        rays
    }

    /// The light that the samples of each uniform pixel of a row share; pixels that something that moves covers wholly
    /// are left out.
    fn centre_lights(
        &self,
        context: &TileContext<'_>,
        row: &PixelRow<'_>,
        count: usize,
    ) -> [CentreLight; TILE as usize] {
        let centres: [Option<PixelCentre<'_>>; TILE as usize] = std::array::from_fn(|i| {
            let index = row.pixel(i);
            if i >= count || !self.gbuffer.uniform[index] || row.found[i].primary.iter().all(Option::is_some) {
                return None;
            }
            Some(row.still(i).centre(&row.ray(i, 0), self.gbuffer.centre_bsdf(index)))
        });
        centre_lights(context, Vec3A::from(self.camera.position), &centres)
    }
}
