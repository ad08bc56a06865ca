//! A row of [`super::sparse_primary`]: what lies between the centres of its pixels.

use super::bake_pass::BakePass;
use super::packed_hit::PackedHit;
use super::primary_hits::PackedNormals;
use super::sample_bundle::{RowCentres, SampleBundle};
use super::sparse_centre::{Centre, FIRST, SunSeen, WHOLE};
use crate::accel::{Ray, RayStream, lanes};
use crate::camera_rays::{aims8, set_row};
use crate::octahedron::unpack8;
use crate::sampling::SAMPLES;
use crate::vec3x8::{Vec3x8, dot, lane_of};
use std::ops::Range;
use wide::f32x8;

/// A row of pixels whose centres are known.
pub(super) struct SparseRow<'a> {
    pub(super) pass: &'a BakePass<'a>,
    pub(super) y: usize,
    pub(super) centres: &'a [Centre],
    /// Of the rows above and below, if there are such.
    pub(super) beside: [Option<&'a [Centre]>; 2],
    /// Which are near the edge of a shadow: of eight that follow each other, a bit each. None where edges have steps.
    pub(super) edges: Option<&'a [u8]>,
    pub(super) distances: &'a mut [[f32; SAMPLES]],
    pub(super) hits: &'a mut [[PackedHit; SAMPLES]],
    pub(super) normals: &'a mut [[PackedNormals; SAMPLES]],
    pub(super) sun_free: &'a mut [[u8; SAMPLES]],
    pub(super) uniform: &'a mut [bool],
}

/// Of up to eight pixels, a bit each: the samples that lie on the surfaces of their centres.
#[derive(Clone, Copy)]
struct Known {
    samples: [u32; SAMPLES],
    /// Pixels that see the sky.
    sky: u32,
    /// All pixels there are.
    all: u32,
}

impl Known {
    /// Pixels of which all samples are known.
    fn whole(&self) -> u32 {
        self.samples.iter().fold(self.all, |whole, sample| whole & sample)
    }
}

impl SparseRow<'_> {
    /// `known` tells of each pixel the samples that lie on the surface of its centre.
    pub(super) fn fill(&mut self, known: impl Fn(usize) -> [bool; SAMPLES]) {
        let width = self.centres.len();
        let is_central = self.pass.camera.lens.is_central();
        let mut bundle = SampleBundle::none();
        let mut among_leaves = Vec::new();
        for first in (0..width).step_by(8) {
            let pixels = first..(first + 8).min(width);
            let mut known = self.begin(pixels.clone(), &known);
            let dense = lanes(known.all & !known.whole()).filter(|lane| self.is_among_leaves(first + lane));
            let dense = dense.fold(0, |bits, lane| bits | 1 << lane);
            among_leaves.extend(lanes(dense).map(|lane| first + lane));
            known.samples[2] |= dense;
            known.samples[3] |= dense;
            let is_whole = known.whole() == known.all;
            if is_whole && known.sky == known.all {
                continue;
            }
            let aims = self.aims(pixels.clone());
            if is_whole && is_central {
                self.spread_on_planes(pixels, &aims);
            } else {
                let rays = self.rays(aims);
                let centres = rays.places(0, self.centre_distances(pixels.clone()));
                self.spread(pixels, &rays, &centres, &known);
                self.ask_for_unknown(first, &rays, &centres, &known, &mut bundle);
            }
        }
        self.trace(&mut bundle);
        among_leaves.into_iter().for_each(|x| self.share_among_leaves(x));
        if let Some(sun) = &self.pass.tracer.environment.sun {
            self.ask_the_disc(sun);
        }
    }

    /// Whether a pixel and its four neighbours see leaves: two of its samples tell all.
    fn is_among_leaves(&self, x: usize) -> bool {
        let row = self.centres[x.saturating_sub(1)..].iter().take(if x == 0 { 2 } else { 3 });
        row.chain(self.beside.iter().flatten().map(|row| &row[x])).all(|centre| centre.is_leaf)
    }

    /// The second sample of such a pixel tells the third, as the centre does the last.
    fn share_among_leaves(&mut self, x: usize) {
        self.distances[x][2] = self.distances[x][1];
        self.hits[x][2] = self.hits[x][1];
        self.normals[x][2] = self.normals[x][1];
        self.sun_free[x][2] = self.sun_free[x][1];
    }

    /// Takes what the centres of up to eight pixels tell.
    fn begin(&mut self, pixels: Range<usize>, known: impl Fn(usize) -> [bool; SAMPLES]) -> Known {
        let mut all = Known { samples: [0; SAMPLES], sky: 0, all: (1 << pixels.len()) - 1 };
        for (lane, x) in pixels.enumerate() {
            let centre = &self.centres[x];
            self.distances[x] = [centre.distance; SAMPLES];
            self.hits[x][0] = centre.hit;
            self.normals[x][0] = centre.normals;
            self.sun_free[x] = [if centre.sun == SunSeen::Lit { WHOLE } else { 0 }; SAMPLES];
            // Until a sample is found to lie elsewhere.
            self.uniform[x] = !centre.is_sky();
            all.sky |= u32::from(centre.is_sky()) << lane;
            for (bits, own) in all.samples.iter_mut().zip(known(x)) {
                *bits |= u32::from(own) << lane;
            }
        }
        all
    }

    /// What tells the rays of up to eight pixels, by sample.
    pub(super) fn aims(&self, pixels: Range<usize>) -> [Vec3x8; SAMPLES] {
        let (x0, x1) = (pixels.start as u32, pixels.end as u32);
        std::array::from_fn(|sample| aims8(self.pass.camera, x0, x1, self.y as u32, sample))
    }

    /// The rays themselves, a row for each sample.
    pub(super) fn rays(&self, aims: [Vec3x8; SAMPLES]) -> RayStream<SAMPLES> {
        let mut rays = RayStream::NONE;
        rays.tmax = [f32x8::splat(f32::MAX); SAMPLES];
        for (sample, aims) in aims.into_iter().enumerate() {
            set_row(self.pass.camera, &mut rays, sample, aims);
        }
        rays
    }

    /// How far the centres of up to eight pixels lie; beyond the last, that of the last.
    fn centre_distances(&self, pixels: Range<usize>) -> f32x8 {
        f32x8::new(std::array::from_fn(|lane| self.centres[(pixels.start + lane).min(pixels.end - 1)].distance))
    }

    /// The normals of the triangles there.
    fn centre_normals(&self, pixels: Range<usize>) -> Vec3x8 {
        let centre = |lane: usize| &self.centres[(pixels.start + lane).min(pixels.end - 1)];
        unpack8(&std::array::from_fn(|lane| centre(lane).normals.geometric))
    }

    /// How far the samples of eight pixels lie, all of which lie on the planes of their centres; all rays leave one lens.
    fn spread_on_planes(&mut self, pixels: Range<usize>, directions: &[Vec3x8; SAMPLES]) {
        let normals = self.centre_normals(pixels.clone());
        let centres = self.centre_distances(pixels.clone());
        let height = centres * dot(&directions[0], &normals);
        let seen = centres.simd_lt(f32x8::splat(f32::MAX));
        let distances = directions.each_ref().map(|direction| {
            let sinks = dot(direction, &normals);
            let meets = sinks.simd_lt(f32x8::splat(-1e-4)) & seen;
            meets.select(height / sinks, centres).to_array()
        });
        for (lane, x) in pixels.enumerate() {
            for (sample, distances) in distances.iter().enumerate().skip(1) {
                self.distances[x][sample] = distances[lane];
            }
        }
    }

    /// Samples of eight pixels that lie on the planes of their centres, or see the sky as they do.
    fn spread(&mut self, pixels: Range<usize>, rays: &RayStream<SAMPLES>, places: &Vec3x8, known: &Known) {
        let normals = self.centre_normals(pixels.clone());
        let centres = self.centre_distances(pixels.clone());
        for sample in 1..SAMPLES {
            let own = known.samples[sample] & !known.sky;
            if own == 0 {
                continue;
            }
            let sinks = dot(&rays.direction.map(|axis| axis[sample]), &normals);
            let way = std::array::from_fn(|k| places[k] - rays.origin[k][sample]);
            let meets = sinks.simd_lt(f32x8::splat(-1e-4));
            let distances = meets.select(dot(&way, &normals) / sinks, centres).to_array();
            for lane in lanes(own) {
                let x = pixels.start + lane;
                self.distances[x][sample] = distances[lane];
                self.hits[x][sample] = self.hits[x][0];
                self.normals[x][sample] = self.normals[x][0];
            }
        }
    }

    /// Has those samples traced that are not known.
    fn ask_for_unknown(
        &mut self,
        first: usize,
        rays: &RayStream<SAMPLES>,
        centres: &Vec3x8,
        known: &Known,
        bundle: &mut SampleBundle,
    ) {
        for lane in lanes(known.all & !known.whole()) {
            for sample in (1..SAMPLES).filter(|&sample| known.samples[sample] >> lane & 1 == 0) {
                bundle.push((first + lane, sample), &rays.ray(8 * sample + lane), lane_of(centres, lane));
                if bundle.is_full() {
                    self.trace(bundle);
                }
            }
        }
    }

    fn trace(&mut self, bundle: &mut SampleBundle) {
        let pass = self.pass;
        let known = RowCentres { centres: self.centres, beside: self.beside, edges: self.edges.unwrap_or_default() };
        bundle.trace(pass, known, |x, sample, seen| {
            let Some(seen) = seen else {
                self.uniform[x] = false;
                self.distances[x][sample] = f32::MAX;
                return;
            };
            self.distances[x][sample] = seen.distance;
            self.hits[x][sample] = seen.hit;
            self.normals[x][sample] = seen.normals;
            self.uniform[x] &= seen.goes_on;
            if let Some(is_lit) = seen.is_lit_as_beside {
                self.sun_free[x][sample] = if is_lit { WHOLE } else { 0 };
            }
            if let (Some(origin), Some(sun)) = (seen.asks_sun_from, &pass.tracer.environment.sun) {
                // From leaves near and far, which have little in common: alone they are faster.
                let ray = Ray { origin, direction: sun.disc[sample][FIRST], tmax: f32::MAX };
                self.sun_free[x][sample] = if pass.tracer.still.accel.occluded(&ray) { 0 } else { WHOLE };
            }
        });
    }
}
