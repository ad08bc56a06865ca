//! The sun near the edges of shadows: what the samples of a row see of its disc.

use super::shadow_edges::is_sharp;
use super::sparse_centre::{BY_FIRST, BY_RIM, FIRST, RIM, WHOLE};
use super::sparse_row::SparseRow;
use super::sun_rays::{LitPlaces, faces8};
use super::waiting_sun_rays::{SunQuestion, WaitingSunRays};
use crate::accel::{RayStream, lanes};
use crate::light::Sun;
use crate::octahedron::unpack8;
use crate::sampling::SAMPLES;
use crate::vec3x8::{Vec3x8, lane_of};
use glam::Vec3A;
use wide::f32x8;

impl SparseRow<'_> {
    /// Has a ray to the sun traced, sooner or later.
    fn ask(&mut self, waiting: &mut WaitingSunRays, question: SunQuestion, origin: Vec3A, direction: Vec3A) {
        waiting.push(question, origin, direction);
        if waiting.is_full() {
            self.trace_to_sun(waiting);
        }
    }

    fn trace_to_sun(&mut self, waiting: &mut WaitingSunRays) {
        let sun_free = &mut self.sun_free;
        waiting.trace(&self.pass.tracer.still.accel, |seen| sun_free[seen.pixel][seen.sample] |= seen.parts);
    }

    /// Asks what each sample near the edge of a shadow sees of the sun's disc: one of two parts first, and the other where
    /// the samples of a pixel do not agree and the edge is not sharp.
    pub(super) fn ask_the_disc(&mut self, sun: &Sun) {
        let waiting = &mut WaitingSunRays::none();
        let near = self.near_shadows_edge(sun);
        for pixel in &near {
            for (sample, origin) in pixel.origins() {
                // The centre has asked the first part already.
                let [first, rim] = if pixel.is_sharp { [WHOLE; 2] } else { [BY_FIRST, BY_RIM] };
                let known = if sample == 0 { self.sun_free[pixel.x][0] & first } else { 0 };
                self.sun_free[pixel.x][sample] = known;
                if sample != 0 {
                    let question = SunQuestion { pixel: pixel.x, sample, parts: rim };
                    self.ask(waiting, question, origin, sun.disc[sample][RIM]);
                }
            }
        }
        self.trace_to_sun(waiting);
        for pixel in near.iter().filter(|pixel| !pixel.is_sharp) {
            let asked = pixel.origins().count();
            let lit = pixel.origins().filter(|(sample, _)| self.sun_free[pixel.x][*sample] != 0).count();
            let agree = asked > 1 && (lit == 0 || lit == asked);
            for (sample, origin) in pixel.origins() {
                let (part, parts) = if sample == 0 { (RIM, BY_RIM) } else { (FIRST, BY_FIRST) };
                if !agree {
                    self.ask(waiting, SunQuestion { pixel: pixel.x, sample, parts }, origin, sun.disc[sample][part]);
                } else if lit != 0 {
                    self.sun_free[pixel.x][sample] = WHOLE;
                }
            }
        }
        self.trace_to_sun(waiting);
    }

    /// The pixels of the row near the edge of a shadow, leaves left out: those whose samples have asked one by one.
    fn near_shadows_edge(&self, sun: &Sun) -> Vec<PenumbraPixel> {
        let mut found = Vec::new();
        let Some(edges) = self.edges else { return found };
        for first in (0..self.centres.len()).step_by(8) {
            let pixels = first..(first + 8).min(self.centres.len());
            let near = lanes(edges[first / 8].into()).filter(|lane| !self.centres[first + lane].is_leaf);
            let near = near.fold(0u32, |bits, lane| bits | 1 << lane);
            if near == 0 {
                continue;
            }
            let rays = self.rays(self.aims(pixels));
            let asking: [_; SAMPLES] = std::array::from_fn(|sample| self.asking(sun, first, near, sample, &rays));
            found.extend(lanes(near).map(|lane| PenumbraPixel {
                x: first + lane,
                is_sharp: is_sharp(&self.centres[first + lane], self.pass.pixel_angle),
                asked: asking.each_ref().map(|(asked, _)| asked >> lane & 1 == 1),
                origins: asking.each_ref().map(|(_, origins)| lane_of(origins, lane)),
            }));
        }
        found
    }

    /// Which of eight pixels ask the sun for a sample, a bit each, and from where.
    fn asking(&self, sun: &Sun, first: usize, near: u32, sample: usize, rays: &RayStream<SAMPLES>) -> (u32, Vec3x8) {
        let (mut packed, mut distances, mut lit) = ([0; 8], [f32::MAX; 8], 0);
        for lane in lanes(near) {
            let x = first + lane;
            packed[lane] = self.normals[x][if self.uniform[x] { 0 } else { sample }].geometric;
            distances[lane] = self.distances[x][sample];
            lit |= u32::from(self.sun_free[x][sample] != 0) << lane;
        }
        let (normals, distances) = (unpack8(&packed), f32x8::new(distances));
        let sees = distances.simd_lt(f32x8::splat(f32::MAX)).to_bitmask();
        // Through leaves that it does not light from the front it was seen before, or is not looked for.
        let asked = near & sees & (faces8(&normals, sun) | lit);
        let places = LitPlaces { positions: rays.places(sample, distances), normals, distances, is_leaf: 0 };
        (asked, places.ray_origins(sun))
    }
}

/// A pixel near the edge of a shadow.
struct PenumbraPixel {
    /// In the row.
    x: usize,
    /// One part of the disc stands for all.
    is_sharp: bool,
    /// The samples that ask the sun, and from where.
    asked: [bool; SAMPLES],
    origins: [Vec3A; SAMPLES],
}

impl PenumbraPixel {
    fn origins(&self) -> impl Iterator<Item = (usize, Vec3A)> {
        self.origins.iter().copied().enumerate().filter(|(sample, _)| self.asked[*sample])
    }
}
