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
        if !work.asks_rays() {
            return (found, 0);
        }
        let all = ((1u16 << self.count) - 1) as u8;
        let mut rays = 0;
        for s in 0..SAMPLES {
            let distances: [f32; TILE as usize] = std::array::from_fn(|i| self.still(i).distances[s]);
            let mut open = all & mask(|i| distances[i] < f32::MAX);
            if work.seen {
                let towards = std::array::from_fn(|i| Ray { tmax: distances[i], ..self.ray(i, s) });
                for (i, hit) in frame.accel.closest8(&towards, all).into_iter().enumerate() {
                    found[i].seen[s] = hit.filter(|hit| hit.t < distances[i]);
                    open &= !(u8::from(found[i].seen[s].is_some()) << i);
                }
                rays += u64::from(all.count_ones());
            }
            if work.sun {
                rays += self.find_sun(frame, s, open, &mut found);
            }
            if work.mirror {
                let asks = |i: usize| match self.bake.uniform[self.pixel(i)] {
                    true => s % 2 == 0,
                    false => open >> i & 1 == 1,
                };
                let mirrors = |i: usize| self.still(i).mirrors >> s & 1 == 1;
                let active = all & mask(|i| mirrors(i) && asks(i));
                if active != 0 {
                    let towards: [Ray; 8] = std::array::from_fn(|i| match active >> i & 1 {
                        1 => self.sample(i, s).mirror_ray(&self.facet(i, s)),
                        _ => Ray { tmax: 0.0, ..self.ray(i, s) },
                    });
                    for (i, hit) in frame.accel.closest8(&towards, active).into_iter().enumerate() {
                        found[i].mirrored[s] = hit.filter(|hit| active >> i & 1 == 1 && hit.t < towards[i].tmax);
                    }
                }
                rays += u64::from(active.count_ones());
            }
        }
        (found, rays)
    }

    fn find_sun(&self, frame: &FrameScene, sample: usize, open: u8, found: &mut [Found; TILE as usize]) -> u64 {
        let Some(sun) = &self.bake.environment.sun else { return 0 };
        let open = open & mask(|i| self.still(i).sun_free[sample] != 0);
        if open == 0 {
            return 0;
        }
        let origins: [Vec3A; TILE as usize] = std::array::from_fn(|i| match open >> i & 1 {
            1 => sun_origin(&self.facet(i, sample), sun.direction),
            _ => self.origin,
        });
        let mut rays = 0;
        for part in 0..2 {
            let asked: [u8; TILE as usize] = std::array::from_fn(|i| {
                let uniform = self.bake.uniform[self.pixel(i)];
                self.still(i).sun_free[sample] & sun.parts(sample, uniform)[part].0
            });
            let active = open & mask(|i| asked[i] != 0);
            if active == 0 {
                continue;
            }
            let direction = sun.parts(sample, false)[part].1;
            let blocked =
                frame.accel.occluded8(&origins.map(|origin| Ray { origin, direction, tmax: f32::MAX }), active);
            for (i, found) in found.iter_mut().enumerate().filter(|(i, _)| blocked >> i & 1 == 1) {
                found.sun_blocked[sample] |= asked[i];
            }
            rays += u64::from(active.count_ones());
        }
        rays
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

/// A bit for each of eight.
fn mask(test: impl Fn(usize) -> bool) -> u8 {
    (0..8).fold(0, |bits, i| bits | u8::from(test(i)) << i)
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
