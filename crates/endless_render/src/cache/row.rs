//! Up to eight neighbouring pixels of a row: their rays towards what moves go in packets.

use super::affected::Work;
use super::bake::{CameraBake, sample_ray};
use super::compose::sun_origin;
use super::still_pixel::StillPixel;
use super::still_sample::StillSample;
use super::tile::TILE;
use crate::accel::{Hit, Ray, RayBundle, lanes};
use crate::eight::{Vectors, normalize};
use crate::sampling::{SAMPLE_OFFSETS, SAMPLES};
use crate::scene::{Facet, FrameScene};
use endless_world::{Distortion, PinholeCamera};
use glam::Vec3A;
use wide::f32x8;

/// What a pixel's rays towards what moves found, a sample each.
#[derive(Debug, Clone, Copy)]
pub(super) struct Found {
    /// In front of the still surface.
    pub(super) seen: [Option<Hit>; SAMPLES],
    /// Directions to the sun that traffic blocks, a bit each.
    pub(super) sun_blocked: [u8; SAMPLES],
    /// In the mirror, nearer than what it mirrors of the town. A uniform pixel asks for every other sample.
    pub(super) mirrored: [Option<Hit>; SAMPLES],
}

impl Found {
    /// Nothing found.
    pub(super) const NOTHING: Self =
        Self { seen: [None; SAMPLES], sun_blocked: [0; SAMPLES], mirrored: [None; SAMPLES] };

    /// Nothing that moves is on its way.
    pub(super) fn is_nothing(&self) -> bool {
        self.sun_blocked == [0; SAMPLES] && self.seen.iter().chain(&self.mirrored).all(Option::is_none)
    }

    /// Asks everything that moves, a ray at a time: the oracle of [`Row::find`].
    pub(super) fn one_by_one(
        bake: &CameraBake,
        frame: &FrameScene,
        rays: &[Ray; SAMPLES],
        samples: &[StillSample],
        uniform: bool,
    ) -> Self {
        let mut found = Self::NOTHING;
        for (s, still) in samples.iter().enumerate() {
            let nearer = |ray: Ray| frame.accel.closest(&ray).filter(|hit| hit.t < ray.tmax);
            found.seen[s] = nearer(Ray { tmax: still.hit.t, ..rays[s] });
            if still.is_sky() {
                continue;
            }
            let facet = still.facet(&rays[s]);
            if let Some(sun) = &bake.environment.sun {
                let origin = sun_origin(&facet, sun.direction);
                for (part, direction) in sun.parts(s, uniform) {
                    let asked = still.sun_free & part;
                    if asked != 0 && frame.accel.occluded(&Ray { origin, direction, tmax: f32::MAX }) {
                        found.sun_blocked[s] |= asked;
                    }
                }
            }
            if still.mirrors() && !(uniform && s % 2 == 1) {
                found.mirrored[s] = nearer(still.mirror_ray(&facet));
            }
        }
        found
    }
}

/// A row of pixels and what their rays towards what moves found: memory that is used for one row after another.
pub(super) struct Row<'a> {
    view: View<'a>,
    pub(super) found: [Found; TILE as usize],
    asked: Asked,
}

/// Where a row's rays go.
struct View<'a> {
    bake: &'a CameraBake,
    /// The first pixel, as an index into the picture.
    first: usize,
    count: usize,
    /// Of the rays, by sample.
    directions: [Vectors; SAMPLES],
}

impl<'a> Row<'a> {
    /// A row that looks nowhere yet.
    pub(super) fn new(bake: &'a CameraBake) -> Self {
        let view = View { bake, first: 0, count: 0, directions: [[f32x8::ZERO; 3]; SAMPLES] };
        Self { view, found: [Found::NOTHING; TILE as usize], asked: Asked::new() }
    }

    /// Turns to the pixels `x0..x1` of line `y`, at most eight. With `centres_only`, the other samples' rays are not
    /// made: they must not be asked for.
    pub(super) fn aim(&mut self, x0: u32, x1: u32, y: u32, centres_only: bool) {
        let view = &mut self.view;
        view.first = y as usize * view.bake.camera.size.width as usize + x0 as usize;
        view.count = (x1 - x0) as usize;
        for (s, directions) in view.directions.iter_mut().enumerate() {
            if s == 0 || !centres_only {
                *directions = directions8(&view.bake.camera, x0, x1, y, s);
            }
        }
        self.found = [Found::NOTHING; TILE as usize];
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
    pub(super) fn sample(&self, i: usize, sample: usize) -> &'a StillSample {
        &self.view.bake.samples[self.pixel(i) * SAMPLES + sample]
    }

    /// Asks what moves, as far as `work` says that it can matter; returns the number of rays.
    pub(super) fn find(&mut self, frame: &FrameScene, work: &Work) -> u64 {
        let Self { view, found, asked } = self;
        asked.traced = 0;
        if work.seen {
            view.find_seen(frame, found, asked);
        }
        if work.sun {
            view.find_sun(frame, found, asked);
        }
        if work.mirror {
            view.find_mirrored(frame, found, asked);
        }
        asked.traced
    }
}

impl<'a> View<'a> {
    fn pixel(&self, i: usize) -> usize {
        self.first + i.min(self.count - 1)
    }

    fn ray(&self, i: usize, sample: usize) -> Ray {
        let [x, y, z] = self.directions[sample].each_ref().map(|axis| axis.as_array()[i]);
        Ray { origin: self.bake.camera.position.into(), direction: Vec3A::new(x, y, z), tmax: f32::MAX }
    }

    fn still(&self, i: usize) -> &'a StillPixel {
        &self.bake.pixels[self.pixel(i)]
    }

    /// Where a pixel's sample lies.
    fn facet(&self, i: usize, sample: usize) -> Facet {
        self.still(i).facet(&self.ray(i, sample), sample)
    }

    fn find_seen(&self, frame: &FrameScene, found: &mut [Found; TILE as usize], asked: &mut Asked) {
        let rays = &mut asked.rays;
        let still: [&StillPixel; TILE as usize] = std::array::from_fn(|i| self.still(i));
        rays.origin = self.bake.camera.position.to_array().map(|axis| [f32x8::splat(axis); SAMPLES]);
        for s in 0..SAMPLES {
            for k in 0..3 {
                rays.direction[k][s] = self.directions[s][k];
            }
            rays.tmax[s] = f32x8::new(still.map(|still| still.distances[s]));
        }
        let active = u32::from_ne_bytes([((1u16 << self.count) - 1) as u8; SAMPLES]);
        asked.traced += u64::from(active.count_ones());
        let hits = frame.accel.closest32(rays, active);
        for (i, found) in found.iter_mut().enumerate() {
            for s in 0..SAMPLES {
                found.seen[s] = hits.get(8 * s + i).filter(|hit| hit.t < still[i].distances[s]);
            }
        }
    }

    fn find_sun(&self, frame: &FrameScene, found: &mut [Found; TILE as usize], asked: &mut Asked) {
        let Some(sun) = &self.bake.environment.sun else { return };
        for (i, s) in self.each_sample() {
            let free = self.still(i).sun_free[s];
            if free == 0 || found[i].seen[s].is_some() || self.still(i).distances[s] == f32::MAX {
                continue;
            }
            let origin = sun_origin(&self.facet(i, s), sun.direction);
            for (part, direction) in sun.parts(s, self.bake.uniform[self.pixel(i)]) {
                if free & part == 0 {
                    continue;
                }
                asked.push((i, s, free & part), Ray { origin, direction, tmax: f32::MAX });
                if asked.is_full() {
                    asked.occluded(frame, |(i, s, part)| found[i].sun_blocked[s] |= part);
                }
            }
        }
        asked.occluded(frame, |(i, s, part)| found[i].sun_blocked[s] |= part);
    }

    fn find_mirrored(&self, frame: &FrameScene, found: &mut [Found; TILE as usize], asked: &mut Asked) {
        for (i, s) in self.each_sample() {
            let still = self.still(i);
            let asks = match self.bake.uniform[self.pixel(i)] {
                true => s % 2 == 0,
                false => still.distances[s] < f32::MAX && found[i].seen[s].is_none(),
            };
            if asks && still.mirrors >> s & 1 == 1 {
                let sample = &self.bake.samples[self.pixel(i) * SAMPLES + s];
                asked.push((i, s, 0), sample.mirror_ray(&self.facet(i, s)));
            }
        }
        asked.closest(frame, |(i, s, _), hit| found[i].mirrored[s] = Some(hit));
    }

    /// Pixel by pixel: rays that go side by side then go nearly the same way.
    fn each_sample(&self) -> impl Iterator<Item = (usize, usize)> {
        (0..self.count).flat_map(|i| (0..SAMPLES).map(move |s| (i, s)))
    }
}

/// Who asks for a ray: a pixel, a sample, and the parts of the sun's disc that it stands for.
type Asker = (usize, usize, u8);

/// Rays of a row that are traced together: one for each sample of eight pixels.
struct Asked {
    askers: [Asker; 32],
    rays: RayBundle<4>,
    count: usize,
    /// Rays traced so far.
    traced: u64,
}

impl Asked {
    fn new() -> Self {
        Self { askers: [(0, 0, 0); 32], rays: RayBundle::NONE, count: 0, traced: 0 }
    }

    /// Adds a ray; there must be room.
    fn push(&mut self, asker: Asker, ray: Ray) {
        self.askers[self.count] = asker;
        self.rays.set(self.count, &ray);
        self.count += 1;
    }

    fn is_full(&self) -> bool {
        self.count == self.askers.len()
    }

    /// Takes all rays off the list: those there were, a bit each.
    fn take(&mut self) -> u32 {
        let active = ((1u64 << self.count) - 1) as u32;
        self.traced += self.count as u64;
        self.count = 0;
        active
    }

    /// Tells who met something nearer than its ray's end.
    fn closest(&mut self, frame: &FrameScene, mut tell: impl FnMut(Asker, Hit)) {
        let active = self.take();
        if active == 0 {
            return;
        }
        let hits = frame.accel.closest32(&self.rays, active);
        for lane in lanes(active) {
            if let Some(hit) = hits.get(lane).filter(|hit| hit.t < self.rays.ray(lane).tmax) {
                tell(self.askers[lane], hit);
            }
        }
    }

    /// Tells whose ray is not free.
    fn occluded(&mut self, frame: &FrameScene, mut tell: impl FnMut(Asker)) {
        let active = self.take();
        if active == 0 {
            return;
        }
        for lane in lanes(frame.accel.occluded32(&self.rays, active)) {
            tell(self.askers[lane]);
        }
    }
}

/// Directions of the rays through a sample of the pixels `x0..x1` of a line, the last one's repeated: those of
/// [`sample_ray`], eight side by side.
fn directions8(camera: &PinholeCamera, x0: u32, x1: u32, y: u32, sample: usize) -> Vectors {
    let column = |i: usize| (x0 + i as u32).min(x1 - 1);
    if camera.distortion != Distortion::NONE {
        let directions: [Vec3A; 8] = std::array::from_fn(|i| sample_ray(camera, column(i), y, sample).direction);
        return [0, 1, 2].map(|axis| f32x8::new(directions.map(|d| d[axis])));
    }
    let (k, offset) = (&camera.intrinsics, SAMPLE_OFFSETS[sample]);
    let across = f32x8::new(std::array::from_fn(|i| column(i) as f32 + 0.5 + offset.x));
    let across = (across - f32x8::splat(k.cx)) / f32x8::splat(k.fx);
    let down = f32x8::splat((y as f32 + 0.5 + offset.y - k.cy) / k.fy);
    let m = &camera.world_from_camera;
    normalize([0, 1, 2].map(|axis| {
        let [x, y, z] = [m.x_axis[axis], m.y_axis[axis], m.z_axis[axis]].map(f32x8::splat);
        x * across + y * down + z
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{CameraSite, ImageSize, Mount};

    #[test]
    fn eight_rays_are_those_of_one_after_another() {
        let site = CameraSite {
            name: "mast".into(),
            position: [3.0, -5.0, 7.5],
            yaw_rad: 2.7,
            down_tilt_rad: 0.43,
            horizontal_fov_rad: 1.1,
            mount: Mount::Pole,
        };
        let straight = PinholeCamera::new(&site, ImageSize { width: 325, height: 180 });
        let bent = straight.clone().with_distortion(Distortion { k1: -0.2, k2: 0.05 });
        for camera in [straight, bent] {
            for (y, x0) in (0..180).flat_map(|y| (0..325).step_by(8).map(move |x0| (y, x0))) {
                let x1 = (x0 + 8).min(325);
                for sample in 0..SAMPLES {
                    let [dx, dy, dz] = directions8(&camera, x0, x1, y, sample).map(f32x8::to_array);
                    for (i, x) in (x0..x1).enumerate() {
                        let direction = Vec3A::new(dx[i], dy[i], dz[i]);
                        assert_eq!(direction, sample_ray(&camera, x, y, sample).direction);
                    }
                }
            }
        }
    }
}
