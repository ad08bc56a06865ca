//! A block of neighbouring pixels of a row: which of their samples have a light of their own, and what these see.

use super::bake_pass::BakePass;
use super::primary_hits::{PrimaryPixel, PrimaryRow};
use crate::accel::{Hit, Ray, first_lanes, lanes};
use crate::camera_rays::aims8;
use crate::octahedron;
use crate::rgb9e5::Rgb9e5;
use crate::sampling::SAMPLES;
use crate::scene::{SurfaceInteraction, TriangleHits};
use crate::vec3x8::Vec3x8;
use endless_scene::Surface;
use endless_world::Lens;
use glam::Vec3A;
use wide::f32x8;

/// Pixels of a block: what is known of them stays in the processor's nearest caches.
pub(super) const BLOCK: usize = 64;
/// Their samples: lane [`BLOCK`] × sample + pixel.
pub(super) const LANES: usize = BLOCK * SAMPLES;
/// In the place of a lane: nobody tells the light, for nobody asks.
pub(super) const NOBODY: u16 = u16::MAX;
/// Fewest points on one triangle for which it pays to find them together.
const FEWEST: u32 = 3;
/// Share of what is around a plant that its leaves see past each other, as gathered light has it in the mean.
const OPEN_TO_LEAVES: f32 = 0.5;
/// The same of walls, from which sills, balconies and eaves stand out.
const OPEN_TO_WALLS: f32 = 0.93;
/// Normals of walls rise or fall by less.
const UPRIGHT: f32 = 0.5;

/// A sample that met a surface and is not lit as another.
pub(super) struct BlockPoint<'a> {
    pub(super) surface: SurfaceInteraction<'a>,
    /// Where its ray began.
    pub(super) origin: Vec3A,
    /// Gathered there, or of probes, klx.
    pub(super) irradiance: Vec3A,
    pub(super) lane: u16,
}

impl BlockPoint<'_> {
    /// Which of its pixel's samples it is.
    pub(super) fn sample(&self) -> usize {
        usize::from(self.lane) / BLOCK
    }

    /// The ray that met it.
    pub(super) fn ray(&self) -> Ray {
        Ray { origin: self.origin, direction: self.surface.direction, tmax: f32::MAX }
    }
}

/// A sample that met nothing.
#[derive(Clone, Copy)]
pub(super) struct SkySample {
    pub(super) ray: Ray,
    pub(super) lane: u16,
    /// Its light is that of all samples of its pixel.
    pub(super) alone: bool,
}

/// What is known of a row before it is shaded.
#[derive(Clone, Copy)]
pub(super) struct ShadedRow<'a> {
    pub(super) y: usize,
    pub(super) primary: PrimaryRow<'a>,
    /// Gathered at each sample, klx; `None` if the probes tell.
    pub(super) irradiance: Option<&'a [[Rgb9e5; SAMPLES]]>,
}

impl ShadedRow<'_> {
    /// What was gathered at a sample, klx.
    pub(super) fn gathered(&self, x: usize, sample: usize) -> Option<Vec3A> {
        Some(self.irradiance?[x][sample].get())
    }
}

/// What a block of pixels sees.
pub(super) struct RowBlock<'a> {
    pub(super) pass: &'a BakePass<'a>,
    pub(super) row: ShadedRow<'a>,
    /// The first pixel in the row.
    pub(super) first: usize,
    pub(super) points: Vec<BlockPoint<'a>>,
    pub(super) skies: Vec<SkySample>,
    /// For each lane the one whose light it has: itself, where it is shaded.
    pub(super) told_by: [u16; LANES],
}

impl<'a> RowBlock<'a> {
    /// That looks at nothing yet.
    pub(super) fn new(pass: &'a BakePass<'a>, row: ShadedRow<'a>) -> Self {
        let (points, skies) = (Vec::with_capacity(LANES), Vec::with_capacity(LANES));
        Self { pass, row, first: 0, points, skies, told_by: [NOBODY; LANES] }
    }

    /// Turns to `count` pixels of the row from `first` on.
    pub(super) fn look_at(&mut self, first: usize, count: usize) {
        self.first = first;
        self.points.clear();
        self.skies.clear();
        for pixel in (0..count).step_by(8) {
            self.look_at_eight(pixel, (count - pixel).min(8));
        }
    }

    /// Of these, `count` that follow pixel `own`. The centre of a uniform pixel tells its light; that of one of nothing but
    /// sky, too, where no other light was gathered.
    fn look_at_eight(&mut self, own: usize, count: usize) {
        let (pass, first) = (self.pass, self.first + own);
        let bits =
            |of: &dyn Fn(usize) -> bool| (0..count).rev().fold(0, |bits, i| bits << 1 | u32::from(of(first + i)));
        let ShadedRow { y, primary, irradiance } = self.row;
        let uniform = bits(&|x| primary.uniform[x]);
        let sky = bits(&|x| primary.distances[x] == [f32::MAX; SAMPLES]);
        let simple = if irradiance.is_some() { uniform } else { uniform | sky };
        for sample in 0..SAMPLES {
            let at = own + BLOCK * sample;
            let asked = first_lanes(count) & if sample == 0 { 0xff } else { 0xff & !simple };
            for pixel in lanes(if sample == 0 { 0 } else { simple }) {
                self.told_by[at + pixel] = if irradiance.is_some() { NOBODY } else { (own + pixel) as u16 };
            }
            if asked == 0 {
                continue;
            }
            let aims = aims8(pass.camera, first as u32, (first + count) as u32, y as u32, sample);
            let from = self.points.len();
            let is_together = sample == 0 && matches!(pass.camera.lens, Lens::Perspective(_));
            let mut left = asked;
            while let Some(pixel) = lanes(left).next() {
                let alike = if is_together { self.look_at_triangle(own, left, &aims) } else { 0 };
                if alike != 0 {
                    left &= !alike;
                    continue;
                }
                let alone = sample == 0 && simple & sky >> pixel & 1 == 1;
                self.look_along(&pass.ray_along(&aims, pixel), at + pixel, alone);
                left &= left - 1;
            }
            if irradiance.is_none() {
                self.ask_probes(from);
            }
        }
    }

    /// Turns to the centres of those of eight pixels that follow the first that is asked on one triangle with it, if they are
    /// enough, and tells which they are.
    fn look_at_triangle(&mut self, own: usize, asked: u32, aims: &Vec3x8) -> u32 {
        let (first, row) = (self.first + own, self.row);
        let primary = row.primary;
        let hit_of = |pixel: usize| &primary.surfaces.hits[first + pixel][0];
        let Some(start) = lanes(asked).next() else { return 0 };
        let alike = lanes(asked).take_while(|&pixel| hit_of(pixel).is_on_triangle_of(hit_of(start)));
        let alike = alike.fold(0u32, |bits, pixel| bits | 1 << pixel);
        let Some((hit, true)) = primary.pixel(first + start).hit(0).zip(Some(alike.count_ones() >= FEWEST)) else {
            return 0;
        };
        let hits: [Hit; 8] = std::array::from_fn(|i| {
            let pixel = if alike >> i & 1 == 1 { i } else { start };
            hit_of(pixel).at(primary.distances[first + pixel][0]).unwrap_or(hit)
        });
        let origin = Vec3A::from(self.pass.camera.position);
        let eight = TriangleHits {
            triangle: hit.triangle,
            origin,
            directions: *aims,
            distances: f32x8::new(hits.map(|hit| hit.t)),
            weights: [f32x8::new(hits.map(|hit| hit.u)), f32x8::new(hits.map(|hit| hit.v))],
        };
        let instance = &self.pass.tracer.still.instances[hit.instance as usize];
        eight.points(instance, lanes(alike), |pixel, surface| {
            let lane = (own + pixel) as u16;
            let irradiance = row.gathered(first + pixel, 0).unwrap_or(Vec3A::ZERO);
            self.told_by[usize::from(lane)] = lane;
            self.points.push(BlockPoint { surface, origin, irradiance, lane });
        });
        alike
    }

    /// Turns to one sample; `alone` if the light of the sky is that of all samples of its pixel.
    fn look_along(&mut self, ray: &Ray, lane: usize, alone: bool) {
        let (x, sample) = (self.first + lane % BLOCK, lane / BLOCK);
        self.told_by[lane] = lane as u16;
        let Some(hit) = self.row.primary.pixel(x).hit(sample) else {
            self.skies.push(SkySample { ray: *ray, lane: lane as u16, alone });
            return;
        };
        let gathered = self.row.gathered(x, sample);
        if gathered.is_none()
            && let Some(alike) = self.alike(lane, &hit)
        {
            self.told_by[lane] = alike;
            return;
        }
        self.push_point(ray, &hit, gathered.unwrap_or(Vec3A::ZERO), lane);
    }

    pub(super) fn push_point(&mut self, ray: &Ray, hit: &Hit, irradiance: Vec3A, lane: usize) {
        let surface = SurfaceInteraction::new(&self.pass.tracer.still.instances, ray, hit);
        self.points.push(BlockPoint { surface, origin: ray.origin, irradiance, lane: lane as u16 });
    }

    /// The light at the points since `from`, one sample of each of eight pixels, as the probes tell of it: along a plane it
    /// changes evenly.
    fn ask_probes(&mut self, from: usize) {
        let (pass, points) = (self.pass, &mut self.points[from..]);
        let (Some(first), Some(last)) = (points.first(), points.last()) else { return };
        let (start, way) = (first.surface.position, last.surface.position - first.surface.position);
        let even = last.lane > first.lane + 1 && is_nearly_plane(points);
        let ends = even.then(|| (ambient(pass, &first.surface), ambient(pass, &last.surface)));
        for point in points {
            let light = match ends {
                Some((first, last)) => {
                    first + (last - first) * ((point.surface.position - start).dot(way) / way.length_squared())
                }
                None => ambient(pass, &point.surface),
            };
            point.irradiance = light * open(&point.surface);
        }
    }

    /// An earlier sample of the same pixel that may tell the light of this one.
    fn alike(&self, lane: usize, hit: &Hit) -> Option<u16> {
        let seen = self.row.primary.pixel(self.first + lane % BLOCK);
        let may_tell = |&other: &usize| {
            let shaded = usize::from(self.told_by[other]) == other;
            let before = if shaded { seen.hit(other / BLOCK) } else { None };
            before.is_some_and(|before| alike(self.pass, &seen, [other / BLOCK, lane / BLOCK], &before, hit))
        };
        (lane % BLOCK..lane).step_by(BLOCK).find(may_tell).map(|other| other as u16)
    }
}

/// Light near a point as the probes tell of it.
fn ambient(pass: &BakePass<'_>, point: &SurfaceInteraction<'_>) -> Vec3A {
    pass.tracer.ambient(point.position + point.geometric_normal * 0.25, point.normal)
}

/// The share of it that what is close by leaves, which is not in the probes.
fn open(point: &SurfaceInteraction<'_>) -> f32 {
    match point.material.surface {
        Surface::Foliage => OPEN_TO_LEAVES,
        _ if point.normal.z.abs() < UPRIGHT => OPEN_TO_WALLS * point.ambient_occlusion,
        _ => point.ambient_occlusion,
    }
}

/// Whether points that follow each other lie on one piece that is flat, or hardly bends.
fn is_nearly_plane(points: &[BlockPoint<'_>]) -> bool {
    /// Far less than from probe to probe.
    const WIDE_M: f32 = 1.0;
    /// Cosine of the largest angle between normals.
    const BENT: f32 = 0.996;
    let (Some(from), Some(to)) = (points.first(), points.last()) else { return false };
    let (from, to) = (&from.surface, &to.surface);
    let same = |p: &SurfaceInteraction<'_>| {
        p.normal.dot(from.normal) > BENT && (p.position - from.position).dot(from.geometric_normal).abs() < 0.02
    };
    (to.position - from.position).length_squared() < WIDE_M * WIDE_M && points.iter().all(|p| same(&p.surface))
}

/// Whether two samples of a pixel may have one light: they lie on one smooth surface, or among leaves.
fn alike(pass: &BakePass<'_>, seen: &PrimaryPixel<'_>, [a, b]: [usize; 2], first: &Hit, second: &Hit) -> bool {
    if first.instance != second.instance {
        return false;
    }
    let instance = &pass.tracer.still.instances[first.instance as usize];
    let (own, other) = (instance.material_of(first.triangle), instance.material_of(second.triangle));
    match own.1.surface {
        _ if own.0 != other.0 => false,
        Surface::SignalLens(_) => false,
        Surface::Foliage => a == 0 && b == 3 || a == 1 && b == 2,
        _ => {
            let normal = |sample: usize| octahedron::unpack(seen.normals[sample].shading);
            normal(a).dot(normal(b)) > 0.98 && (first.t - second.t).abs() < 0.05 * first.t
        }
    }
}
