//! Up to eight neighbouring pixels of a row, whose rays towards moving objects are traced in packets.

use super::bake::CameraBake;
use super::gbuffer_pixel::GBufferPixel;
use super::gbuffer_sample::GBufferSample;
use super::moving_hits::MovingHits;
use super::ray_queue::RayQueue;
use super::sun_rays::sun_origin;
use super::tile::TILE;
use super::tile_work::TileWork;
use crate::accel::{Ray, first_lanes};
use crate::camera_rays::directions8;
use crate::sampling::SAMPLES;
use crate::scene::{FrameScene, ShadingPoint};
use crate::vec3x8::Vec3x8;
use glam::Vec3A;
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
    /// Of the rays, by sample.
    directions: [Vec3x8; SAMPLES],
}

impl<'a> PixelRow<'a> {
    /// A row that looks nowhere yet.
    pub(super) fn new(bake: &'a CameraBake) -> Self {
        let view = RowView { bake, first: 0, count: 0, directions: [[f32x8::ZERO; 3]; SAMPLES] };
        Self { view, found: [MovingHits::NOTHING; TILE as usize], queue: RayQueue::new() }
    }

    /// Turns to the pixels `x0..x1` of line `y`, at most eight. With `centres_only`, the other samples' rays are not
    /// made: they must not be queue for.
    pub(super) fn aim(&mut self, x0: u32, x1: u32, y: u32, centres_only: bool) {
        let view = &mut self.view;
        view.first = y as usize * view.bake.camera.size.width as usize + x0 as usize;
        view.count = (x1 - x0) as usize;
        for (s, directions) in view.directions.iter_mut().enumerate() {
            if s == 0 || !centres_only {
                *directions = directions8(&view.bake.camera, x0, x1, y, s);
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

    /// A still sample of a pixel.
    pub(super) fn sample(&self, i: usize, sample: usize) -> &'a GBufferSample {
        &self.view.bake.gbuffer.samples[self.pixel(i) * SAMPLES + sample]
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
        let [x, y, z] = self.directions[sample].each_ref().map(|axis| axis.as_array()[i]);
        Ray { origin: self.bake.camera.position.into(), direction: Vec3A::new(x, y, z), tmax: f32::MAX }
    }

    fn still(&self, i: usize) -> &'a GBufferPixel {
        &self.bake.gbuffer.pixels[self.pixel(i)]
    }

    /// Where a pixel's sample lies.
    fn facet(&self, i: usize, sample: usize) -> ShadingPoint {
        self.still(i).facet(&self.ray(i, sample), sample)
    }

    fn find_visible(&self, frame: &FrameScene, found: &mut [MovingHits; TILE as usize], queue: &mut RayQueue) {
        let rays = &mut queue.rays;
        let still: [&GBufferPixel; TILE as usize] = std::array::from_fn(|i| self.still(i));
        rays.origin = self.bake.camera.position.to_array().map(|axis| [f32x8::splat(axis); SAMPLES]);
        for s in 0..SAMPLES {
            for k in 0..3 {
                rays.direction[k][s] = self.directions[s][k];
            }
            rays.tmax[s] = f32x8::new(still.map(|still| still.distances[s]));
        }
        let active = first_lanes(self.count);
        queue.traced += u64::from(active.count_ones());
        let hits = frame.accel.closest32(rays, active);
        for (i, found) in found.iter_mut().enumerate() {
            for s in 0..SAMPLES {
                found.primary[s] = hits.get(8 * s + i).filter(|hit| hit.t < still[i].distances[s]);
            }
        }
    }

    fn find_sun(&self, frame: &FrameScene, found: &mut [MovingHits; TILE as usize], queue: &mut RayQueue) {
        let Some(sun) = &self.bake.lighting.environment.sun else { return };
        for (i, s) in self.each_sample() {
            let free = self.still(i).sun_free[s];
            if free == 0 || found[i].primary[s].is_some() || self.still(i).distances[s] == f32::MAX {
                continue;
            }
            let origin = sun_origin(&self.facet(i, s), sun.direction);
            for (part, direction) in sun.parts(s, self.bake.gbuffer.uniform[self.pixel(i)]) {
                if free & part == 0 {
                    continue;
                }
                queue.push((i, s, free & part), Ray { origin, direction, tmax: f32::MAX });
                if queue.is_full() {
                    queue.occluded(frame, |(i, s, part)| found[i].sun_blocked[s] |= part);
                }
            }
        }
        queue.occluded(frame, |(i, s, part)| found[i].sun_blocked[s] |= part);
    }

    fn find_mirrored(&self, frame: &FrameScene, found: &mut [MovingHits; TILE as usize], queue: &mut RayQueue) {
        for (i, s) in self.each_sample() {
            let still = self.still(i);
            let asks = match self.bake.gbuffer.uniform[self.pixel(i)] {
                true => s % 2 == 0,
                false => still.distances[s] < f32::MAX && found[i].primary[s].is_none(),
            };
            if asks && still.mirrors >> s & 1 == 1 {
                let sample = &self.bake.gbuffer.samples[self.pixel(i) * SAMPLES + s];
                queue.push((i, s, 0), sample.mirror_ray(&self.facet(i, s)));
            }
        }
        queue.closest(frame, |(i, s, _), hit| found[i].mirrored[s] = Some(hit));
    }

    /// Pixel by pixel: rays that go side by side then go nearly the same way.
    fn each_sample(&self) -> impl Iterator<Item = (usize, usize)> {
        (0..self.count).flat_map(|i| (0..SAMPLES).map(move |s| (i, s)))
    }
}
