//! A row of [`super::sparse_primary`]: what lies between the centres of its pixels.

use super::bake_pass::BakePass;
use super::packed_hit::PackedHit;
use super::primary_hits::PackedNormals;
use super::sparse_centre::{Centre, FIRST, PARTS, ROWS, SunSeen, WHOLE, piece, to_part};
use super::sun_rays::{sun_can_light, sun_origin};
use crate::accel::{Ray, RayStream, lanes};
use crate::octahedron;
use crate::sampling::SAMPLES;
use crate::scene::{ShadingPoint, SurfaceInteraction};
use crate::vec3x8::{Vec3x8, dot};
use glam::Vec3A;
use std::ops::Range;
use wide::f32x8;

/// A row of pixels whose centres are known.
pub(super) struct SparseRow<'a> {
    pub(super) pass: &'a BakePass<'a>,
    pub(super) y: usize,
    pub(super) centres: &'a [Centre],
    /// Which are near the edge of a shadow.
    pub(super) edges: &'a [bool],
    pub(super) distances: &'a mut [[f32; SAMPLES]],
    pub(super) hits: &'a mut [[PackedHit; SAMPLES]],
    pub(super) normals: &'a mut [[PackedNormals; SAMPLES]],
    pub(super) sun_free: &'a mut [[u8; SAMPLES]],
    pub(super) uniform: &'a mut [bool],
}

/// Samples that are traced together.
struct Bundle {
    rays: RayStream<ROWS>,
    places: [(usize, usize); 8 * ROWS],
    count: usize,
}

impl SparseRow<'_> {
    /// `known` tells of each pixel the samples that lie on the surface of its centre.
    pub(super) fn fill(&mut self, known: impl Fn(usize) -> [bool; SAMPLES]) {
        let width = self.centres.len();
        let mut bundle = Bundle { rays: RayStream::NONE, places: [(0, 0); 8 * ROWS], count: 0 };
        let mut unknown = Vec::new();
        for first in (0..width).step_by(8) {
            let pixels = first..(first + 8).min(width);
            for x in pixels.clone() {
                let centre = &self.centres[x];
                self.distances[x] = [centre.distance; SAMPLES];
                self.hits[x][0] = centre.hit;
                self.normals[x][0] = centre.normals;
                self.sun_free[x] = [if centre.sun == SunSeen::Lit { WHOLE } else { 0 }; SAMPLES];
                self.uniform[x] = !centre.is_sky();
            }
            let all_known = pixels.clone().all(|x| known(x) == [true; SAMPLES]);
            if all_known && self.centres[pixels.clone()].iter().all(Centre::is_sky) {
                continue;
            }
            let directions = self.pass.aims_of(self.y * width + first, pixels.len());
            if all_known && self.pass.camera.lens.is_central() {
                self.spread_on_planes(pixels, &directions);
                continue;
            }
            for x in pixels {
                let rays: [Ray; SAMPLES] = std::array::from_fn(|s| self.pass.ray_along(&directions[s], x - first));
                let known = known(x);
                self.spread(x, &rays, known);
                for sample in (1..SAMPLES).filter(|&sample| !known[sample]) {
                    self.push(&mut bundle, x, sample, &rays[sample]);
                }
                if known != [true; SAMPLES] {
                    unknown.push((x, rays));
                }
            }
        }
        self.trace(&mut bundle);
        for (x, rays) in unknown {
            self.uniform[x] = self.is_uniform(x, &rays, known(x));
        }
        let mut disc = DiscRays { rays: RayStream::NONE, places: Vec::with_capacity(8 * ROWS / PARTS.len()) };
        for first in (0..width).step_by(8) {
            let pixels = first..(first + 8).min(width);
            if !self.edges[pixels.clone()].iter().any(|edge| *edge) {
                continue;
            }
            let directions = self.pass.aims_of(self.y * width + first, pixels.len());
            for x in pixels {
                if self.edges[x] {
                    let rays: [Ray; SAMPLES] = std::array::from_fn(|s| self.pass.ray_along(&directions[s], x - first));
                    self.ask_the_disc(&mut disc, x, &rays);
                }
            }
        }
        self.trace_disc(&mut disc);
    }

    /// How far the samples of eight pixels lie, all of which lie on the planes of their centres; all rays leave one lens.
    fn spread_on_planes(&mut self, pixels: Range<usize>, directions: &[Vec3x8; SAMPLES]) {
        let (mut normals, mut centres) = ([[0.0; 8]; 3], [0.0; 8]);
        let (mut last, mut normal) = (0, Vec3A::Z);
        for (lane, x) in pixels.clone().enumerate() {
            let packed = self.normals[x][0].geometric;
            if lane == 0 || packed != last {
                (last, normal) = (packed, octahedron::unpack(packed));
            }
            for (axis, own) in normals.iter_mut().zip(normal.to_array()) {
                axis[lane] = own;
            }
            centres[lane] = self.centres[x].distance;
        }
        let (normals, centres) = (normals.map(f32x8::new), f32x8::new(centres));
        let height = centres * dot(&directions[0], &normals);
        for (sample, direction) in directions.iter().enumerate().skip(1) {
            let sinks = dot(direction, &normals);
            let meets = sinks.simd_lt(f32x8::splat(-1e-4)) & centres.simd_lt(f32x8::splat(f32::MAX));
            let distances = meets.select(height / sinks, centres).to_array();
            for (x, distance) in pixels.clone().zip(distances) {
                self.distances[x][sample] = distance;
            }
        }
    }

    /// Samples of a pixel that lie on the plane of its centre, or see the sky as it does.
    fn spread(&mut self, x: usize, rays: &[Ray; SAMPLES], known: [bool; SAMPLES]) {
        if self.distances[x][0] == f32::MAX {
            return;
        }
        let normal = octahedron::unpack(self.normals[x][0].geometric);
        let centre = rays[0].origin + rays[0].direction * self.distances[x][0];
        for (sample, ray) in rays.iter().enumerate().skip(1).filter(|(sample, _)| known[*sample]) {
            let sinks = ray.direction.dot(normal);
            let distance = if sinks < -1e-4 { (centre - ray.origin).dot(normal) / sinks } else { self.distances[x][0] };
            self.distances[x][sample] = distance;
            self.hits[x][sample] = self.hits[x][0];
            self.normals[x][sample] = self.normals[x][0];
            self.sun_free[x][sample] = self.sun_free[x][0];
        }
    }

    fn push(&mut self, bundle: &mut Bundle, x: usize, sample: usize, ray: &Ray) {
        bundle.rays.set(bundle.count, ray);
        bundle.places[bundle.count] = (x, sample);
        bundle.count += 1;
        if bundle.count == bundle.places.len() {
            self.trace(bundle);
        }
    }

    fn trace(&mut self, bundle: &mut Bundle) {
        let tracer = &self.pass.tracer;
        let active = (1u64 << std::mem::take(&mut bundle.count)) - 1;
        let found = tracer.still.accel.closest32(&bundle.rays, active as u32);
        let (mut to_sun, mut asked) = (RayStream::<ROWS>::NONE, 0u32);
        for lane in lanes(active as u32) {
            let (x, sample) = bundle.places[lane];
            let Some(hit) = found.get(lane) else { continue };
            let point = SurfaceInteraction::new(&tracer.still.instances, &bundle.rays.ray(lane), &hit);
            self.distances[x][sample] = hit.t;
            self.hits[x][sample] = PackedHit::new(&hit);
            self.normals[x][sample] = PackedNormals::new(&point);
            let sun = tracer.environment.sun.as_ref();
            if let Some(sun) = sun.filter(|sun| sun_can_light(&point, sun.direction)) {
                asked |= 1 << lane;
                to_sun.set(lane, &to_part(sun, &point, sample, FIRST));
            }
        }
        if asked == 0 {
            return;
        }
        let shaded = tracer.still.accel.occluded32(&to_sun, asked);
        for lane in lanes(asked & !shaded) {
            let (x, sample) = bundle.places[lane];
            self.sun_free[x][sample] = WHOLE;
        }
    }

    /// Whether a pixel's samples lie on one flat piece of one surface.
    fn is_uniform(&self, x: usize, rays: &[Ray; SAMPLES], known: [bool; SAMPLES]) -> bool {
        if self.distances[x][0] == f32::MAX {
            return false;
        }
        if known == [true; SAMPLES] {
            return true;
        }
        let still = self.pass.tracer.still;
        let piece = |s: usize| piece(still, &rays[s], self.distances[x][s], self.hits[x][s], &self.normals[x][s]);
        let Some(centre) = piece(0) else { return false };
        (1..SAMPLES)
            .filter(|&sample| !known[sample])
            .all(|sample| piece(sample).is_some_and(|piece| centre.continues(&piece)))
    }

    /// Asks what each sample of a pixel sees of the sun's disc.
    fn ask_the_disc(&mut self, disc: &mut DiscRays, x: usize, rays: &[Ray; SAMPLES]) {
        let Some(sun) = &self.pass.tracer.environment.sun else { return };
        for (sample, ray) in rays.iter().enumerate() {
            let own = if self.uniform[x] { 0 } else { sample };
            let normal = octahedron::unpack(self.normals[x][own].geometric);
            let facet = ShadingPoint::along(ray, self.distances[x][sample], normal);
            // Through leaves that it does not light from the front it was seen before, or is not looked for.
            let may_light = normal.dot(sun.direction) > 0.0 || self.sun_free[x][sample] != 0;
            if facet.distance == f32::MAX || !may_light {
                continue;
            }
            let origin = sun_origin(&facet, sun.direction);
            for (lane, part) in (disc.places.len() * PARTS.len()..).zip(PARTS) {
                disc.rays.set(lane, &Ray { origin, direction: sun.disc[sample][part], tmax: f32::MAX });
            }
            disc.places.push((x, sample));
            if disc.places.len() * PARTS.len() == 8 * ROWS {
                self.trace_disc(disc);
            }
        }
    }

    fn trace_disc(&mut self, disc: &mut DiscRays) {
        let asked = (1u64 << (disc.places.len() * PARTS.len())) - 1;
        if asked == 0 {
            return;
        }
        let shaded = self.pass.tracer.still.accel.occluded32(&disc.rays, asked as u32);
        for (k, (x, sample)) in disc.places.drain(..).enumerate() {
            let free = |ray: usize| u8::from(shaded >> (PARTS.len() * k + ray) & 1 == 0);
            // Each ray stands for half of what the sample asks elsewhere.
            self.sun_free[x][sample] = (free(0) * 0b0011) | (free(1) * 0b1100);
        }
    }
}

/// Rays to all of the sun's disc from a few samples.
struct DiscRays {
    rays: RayStream<ROWS>,
    places: Vec<(usize, usize)>,
}
