//! Up to eight neighbouring pixels of a row: their rays towards what moves go in packets.

use super::affected::Work;
use super::bake::{CameraBake, sample_ray};
use super::compose::sun_origin;
use super::still_pixel::StillPixel;
use super::still_sample::StillSample;
use super::tile::TILE;
use crate::accel::{Hit, Ray};
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

/// A row of pixels.
pub(super) struct Row<'a> {
    bake: &'a CameraBake,
    /// The first pixel, as an index into the picture.
    first: usize,
    count: usize,
    origin: Vec3A,
    /// Of the rays, by sample.
    directions: [[Vec3A; TILE as usize]; SAMPLES],
}

impl<'a> Row<'a> {
    /// The pixels `x0..x1` of line `y`, at most eight. With `centres_only`, the other samples' rays are not made: they
    /// must not be asked for.
    pub(super) fn new(bake: &'a CameraBake, x0: u32, x1: u32, y: u32, centres_only: bool) -> Self {
        let first = y as usize * bake.camera.size.width as usize + x0 as usize;
        let origin = Vec3A::from(bake.camera.position);
        let mut row = Self { bake, first, count: (x1 - x0) as usize, origin, directions: [[Vec3A::ZERO; 8]; SAMPLES] };
        for (s, directions) in row.directions.iter_mut().enumerate() {
            if s == 0 || !centres_only {
                *directions = directions8(&bake.camera, x0, x1, y, s);
            }
        }
        row
    }

    /// Index of a pixel in the picture.
    pub(super) fn pixel(&self, i: usize) -> usize {
        self.first + i.min(self.count - 1)
    }

    /// Rays of a pixel's samples.
    pub(super) fn rays(&self, i: usize) -> [Ray; SAMPLES] {
        std::array::from_fn(|s| self.ray(i, s))
    }

    /// The ray of a pixel's sample.
    pub(super) fn ray(&self, i: usize, sample: usize) -> Ray {
        Ray { origin: self.origin, direction: self.directions[sample][i], tmax: f32::MAX }
    }

    fn still(&self, i: usize) -> &'a StillPixel {
        &self.bake.pixels[self.pixel(i)]
    }

    /// A still sample of a pixel.
    pub(super) fn sample(&self, i: usize, sample: usize) -> &'a StillSample {
        &self.bake.samples[self.pixel(i) * SAMPLES + sample]
    }

    /// Where a pixel's sample lies.
    fn facet(&self, i: usize, sample: usize) -> Facet {
        self.still(i).facet(&self.ray(i, sample), sample)
    }

    /// Asks what moves, as far as `work` says that it can matter; returns the number of rays.
    pub(super) fn find(&self, frame: &FrameScene, work: &Work) -> ([Found; TILE as usize], u64) {
        let mut found = [Found::NOTHING; TILE as usize];
        let mut rays = 0;
        if work.seen {
            rays += self.find_seen(frame, &mut found);
        }
        if work.sun {
            rays += self.find_sun(frame, &mut found);
        }
        if work.mirror {
            rays += self.find_mirrored(frame, &mut found);
        }
        (found, rays)
    }

    fn find_seen(&self, frame: &FrameScene, found: &mut [Found; TILE as usize]) -> u64 {
        let mut asked = Asked::new();
        for (i, s) in self.each_sample() {
            asked.push((i, s, 0), Ray { tmax: self.still(i).distances[s], ..self.ray(i, s) });
        }
        asked.closest(frame, |(i, s, _), hit| found[i].seen[s] = Some(hit));
        asked.traced
    }

    fn find_sun(&self, frame: &FrameScene, found: &mut [Found; TILE as usize]) -> u64 {
        let Some(sun) = &self.bake.environment.sun else { return 0 };
        let mut asked = Asked::new();
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
        asked.traced
    }

    fn find_mirrored(&self, frame: &FrameScene, found: &mut [Found; TILE as usize]) -> u64 {
        let mut asked = Asked::new();
        for (i, s) in self.each_sample() {
            let still = self.still(i);
            let asks = match self.bake.uniform[self.pixel(i)] {
                true => s % 2 == 0,
                false => still.distances[s] < f32::MAX && found[i].seen[s].is_none(),
            };
            if asks && still.mirrors >> s & 1 == 1 {
                asked.push((i, s, 0), self.sample(i, s).mirror_ray(&self.facet(i, s)));
            }
        }
        asked.closest(frame, |(i, s, _), hit| found[i].mirrored[s] = Some(hit));
        asked.traced
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
    rays: [[Ray; 8]; 4],
    count: usize,
    /// Rays traced so far.
    traced: u64,
}

impl Asked {
    fn new() -> Self {
        let none = Ray { origin: Vec3A::ZERO, direction: Vec3A::Z, tmax: 0.0 };
        Self { askers: [(0, 0, 0); 32], rays: [[none; 8]; 4], count: 0, traced: 0 }
    }

    /// Adds a ray; there must be room.
    fn push(&mut self, asker: Asker, ray: Ray) {
        self.askers[self.count] = asker;
        self.rays[self.count / 8][self.count % 8] = ray;
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
        let ends = self.rays.iter().flatten().map(|ray| ray.tmax);
        for ((hit, end), asker) in hits.iter().flatten().zip(ends).zip(&self.askers) {
            if let Some(hit) = hit.filter(|hit| hit.t < end) {
                tell(*asker, hit);
            }
        }
    }

    /// Tells whose ray is not free.
    fn occluded(&mut self, frame: &FrameScene, mut tell: impl FnMut(Asker)) {
        let active = self.take();
        if active == 0 {
            return;
        }
        let blocked = frame.accel.occluded32(&self.rays, active);
        for (lane, asker) in self.askers.iter().enumerate() {
            if blocked >> lane & 1 == 1 {
                tell(*asker);
            }
        }
    }
}

/// Directions of the rays through a sample of the pixels `x0..x1` of a line, the last one's repeated: those of
/// [`sample_ray`], eight side by side.
fn directions8(camera: &PinholeCamera, x0: u32, x1: u32, y: u32, sample: usize) -> [Vec3A; TILE as usize] {
    let column = |i: usize| (x0 + i as u32).min(x1 - 1);
    if camera.distortion != Distortion::NONE {
        return std::array::from_fn(|i| sample_ray(camera, column(i), y, sample).direction);
    }
    let (k, offset) = (&camera.intrinsics, SAMPLE_OFFSETS[sample]);
    let across = f32x8::new(std::array::from_fn(|i| column(i) as f32 + 0.5 + offset.x));
    let across = (across - f32x8::splat(k.cx)) / f32x8::splat(k.fx);
    let down = f32x8::splat((y as f32 + 0.5 + offset.y - k.cy) / k.fy);
    let m = &camera.world_from_camera;
    let axis = |axis: usize| {
        let [x, y, z] = [m.x_axis[axis], m.y_axis[axis], m.z_axis[axis]].map(f32x8::splat);
        x * across + y * down + z
    };
    let (x, y, z) = (axis(0), axis(1), axis(2));
    let over = f32x8::ONE / (x * x + y * y + z * z).sqrt();
    let (x, y, z) = ((x * over).to_array(), (y * over).to_array(), (z * over).to_array());
    std::array::from_fn(|i| Vec3A::new(x[i], y[i], z[i]))
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
                    let rays = directions8(&camera, x0, x1, y, sample);
                    for (x, direction) in (x0..x1).zip(rays) {
                        assert_eq!(direction, sample_ray(&camera, x, y, sample).direction);
                    }
                }
            }
        }
    }
}
