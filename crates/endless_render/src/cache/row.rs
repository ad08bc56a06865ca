//! Up to eight neighbouring pixels of a row, whose rays towards moving objects are traced in packets.

use super::bake::CameraBake;
use super::moving_hits::MovingHits;
use super::ray_queue::RayQueue;
use super::still_pixel::StillPixel;
use super::sun_rays::sun_origin;
use super::tile::TILE;
use super::tile_work::TileWork;
use crate::accel::{Ray, first_lanes, lanes};
use crate::camera_rays::{aims8, lane_ray, set_row};
use crate::sampling::SAMPLES;
use crate::scene::FrameScene;
use crate::vec3x8::Vec3x8;
use wide::f32x8;

/// A row of pixels and what their rays towards what moves found: memory that is used for one row after another.
pub(super) struct PixelRow<'a> {
    view: RowView<'a>,
    pub(super) found: [MovingHits; TILE as usize],
    queue: RayQueue,
}

/// Where a row's rays go.
struct RowView<'a> {
    bake: &'a CameraBake,
    /// The first pixel, as an index into the picture.
    first: usize,
    count: usize,
    /// What tells the rays, by sample.
    aims: [Vec3x8; SAMPLES],
}

impl<'a> PixelRow<'a> {
    /// A row that looks nowhere yet.
    pub(super) fn new(bake: &'a CameraBake) -> Self {
        let view = RowView { bake, first: 0, count: 0, aims: [[f32x8::ZERO; 3]; SAMPLES] };
        Self { view, found: [MovingHits::NOTHING; TILE as usize], queue: RayQueue::new() }
    }

    /// Turns to the pixels `x0..x1` of line `y`, at most eight. With `centres_only`, the other samples' rays are not
    /// made: they must not be asked for.
    pub(super) fn aim(&mut self, x0: u32, x1: u32, y: u32, centres_only: bool) {
        let view = &mut self.view;
        view.first = y as usize * view.bake.camera.size.width as usize + x0 as usize;
        view.count = (x1 - x0) as usize;
        for (s, aims) in view.aims.iter_mut().enumerate() {
            if s == 0 || !centres_only {
                *aims = aims8(&view.bake.camera, x0, x1, y, s);
            }
        }
        self.found = [MovingHits::NOTHING; TILE as usize];
    }

    /// Index of a pixel in the picture.
    pub(super) fn pixel(&self, i: usize) -> usize {
        self.view.pixel(i)
    }

    /// Rays of a pixel's samples.
    pub(super) fn rays(&self, i: usize) -> [Ray; SAMPLES] {
        std::array::from_fn(|s| self.view.ray(i, s))
    }

    /// The ray of a pixel's sample.
    pub(super) fn ray(&self, i: usize, sample: usize) -> Ray {
        self.view.ray(i, sample)
    }

    /// A pixel of the static picture.
    pub(super) fn still(&self, i: usize) -> StillPixel<'a> {
        self.view.still(i)
    }

    /// Asks what moves, as far as `work` says that it can matter; returns the number of rays.
    pub(super) fn find(&mut self, frame: &FrameScene, work: &TileWork) -> u64 {
        let Self { view, found, queue } = self;
        queue.traced = 0;
        if work.primary {
            view.find_visible(frame, found, queue);
        }
        if work.sun {
            view.find_sun(frame, found, queue);
        }
        if work.mirror {
            view.find_mirrored(frame, found, queue);
        }
        queue.traced
    }
}

impl<'a> RowView<'a> {
    fn pixel(&self, i: usize) -> usize {
        self.first + i.min(self.count - 1)
    }

    fn ray(&self, i: usize, sample: usize) -> Ray {
        lane_ray(&self.bake.camera, &self.aims[sample], i)
    }

    fn still(&self, i: usize) -> StillPixel<'a> {
        self.bake.gbuffer.pixel(self.pixel(i))
    }

    fn find_visible(&self, frame: &FrameScene, found: &mut [MovingHits; TILE as usize], queue: &mut RayQueue) {
        let rays = &mut queue.rays;
        let distances: [&[f32; SAMPLES]; TILE as usize] =
            std::array::from_fn(|i| &self.bake.gbuffer.distances[self.pixel(i)]);
        for s in 0..SAMPLES {
            set_row(&self.bake.camera, rays, s, self.aims[s]);
            rays.tmax[s] = f32x8::new(distances.map(|pixel| pixel[s]));
        }
        let active = first_lanes(self.count);
        queue.traced += u64::from(active.count_ones());
        let hits = frame.accel.closest32(rays, active);
        for (i, found) in found.iter_mut().enumerate() {
            for s in 0..SAMPLES {
                found.primary[s] = hits.get(8 * s + i).filter(|hit| hit.t < distances[i][s]);
            }
        }
    }

    fn find_sun(&self, frame: &FrameScene, found: &mut [MovingHits; TILE as usize], queue: &mut RayQueue) {
        let Some(sun) = &self.bake.lighting.environment.sun else { return };
        for i in 0..self.count {
            let still = self.still(i);
            for s in 0..SAMPLES {
                let free = still.sun_free[s];
                if free == 0 || found[i].primary[s].is_some() {
                    continue;
                }
                let origin = sun_origin(&still.facet(&self.ray(i, s), s), sun.direction);
                for (part, direction) in sun.parts(s, still.uniform) {
                    if free & part == 0 {
                        continue;
                    }
                    queue.push((i, s, free & part), Ray { origin, direction, tmax: f32::MAX });
                    if queue.is_full() {
                        queue.occluded(frame, |(i, s, part)| found[i].sun_blocked[s] |= part);
                    }
                }
            }
        }
        queue.occluded(frame, |(i, s, part)| found[i].sun_blocked[s] |= part);
    }

    fn find_mirrored(&self, frame: &FrameScene, found: &mut [MovingHits; TILE as usize], queue: &mut RayQueue) {
        for i in 0..self.count {
            let still = self.still(i);
            for s in lanes(u32::from(still.mirrored)) {
                let Some(mirror) = still.mirror(s).filter(|_| still.uniform || found[i].primary[s].is_none()) else {
                    continue;
                };
                queue.push((i, s, 0), mirror.ray(&still.facet(&self.ray(i, s), s)));
            }
        }
        queue.closest(frame, |(i, s, _), hit| found[i].mirrored[s] = Some(hit));
    }
}
