//! The first pass of a bake for one instant: all samples are traced only where that tells anything.
//!
//! Where the centre of a pixel and that of the neighbour towards which a sample lies are on one flat piece of one surface, so
//! is the sample: it is known without a ray. The sun's disc is asked by eight rays a pixel near the edges of shadows, and by one everywhere
//! else.
//!
//! ```text
//! centres of all pixels ──► where surfaces end ──► samples that are not known
//!                      └──► where shadows end  ──► the rest of the sun's disc
//! ```

use super::bake_pass::BakePass;
use super::bake_stats::timed;
use super::packed_hit::PackedHit;
use super::primary_hits::{PackedNormals, RowSurfaces};
use super::sparse_centre::{Centre, FIRST, Piece, ROWS, SunSeen, piece, same_piece, to_part};
use super::sparse_row::SparseRow;
use super::sun_rays::sun_can_light;
use crate::accel::{RayStream, lanes};
use crate::camera_rays::{aims8, sample_ray, set_row};
use crate::sampling::SAMPLES;
use crate::scene::SurfaceInteraction;
use endless_scene::Surface;
use rayon::prelude::*;
use wide::f32x8;

/// How far from the edge of a shadow all of the disc is asked, at most: pixels.
const PENUMBRA: usize = 4;
/// Half the width of the shadow's edge of something five metres away.
const PENUMBRA_M: f32 = 0.023;

/// Whether a pixel's neighbours to the right and below go on on its surface.
#[derive(Clone, Copy, Default)]
struct GoesOn {
    right: bool,
    below: bool,
}

impl BakePass<'_> {
    /// What can be told before any row is looked at alone.
    pub(super) fn trace_sparse(&self) -> SparsePrimary<'_> {
        let (width, height) = (self.width(), self.camera.size.height as usize);
        let centres = timed("centres", || self.trace_centres());
        let mut goes_on = vec![GoesOn::default(); width * height];
        timed("ends of surfaces", || {
            goes_on.par_chunks_mut(width).enumerate().for_each(|(y, row)| self.compare_row(&centres, y, row));
        });
        let near_shadow_edge = timed("ends of shadows", || self.near_shadow_edges(&centres));
        self.stats.add((width * height) as u64 * 2);
        SparsePrimary { pass: self, centres, goes_on, near_shadow_edge }
    }

    fn trace_centres(&self) -> Vec<Centre> {
        let width = self.width();
        let mut centres = vec![Centre::SKY; self.camera.size.pixels()];
        centres.par_chunks_mut(ROWS * width).enumerate().for_each(|(band, centres)| {
            for first in (0..width).step_by(8) {
                self.trace_block(ROWS * band, first, centres);
            }
        });
        centres
    }

    /// Up to eight columns of a band of rows.
    fn trace_block(&self, y: usize, first: usize, centres: &mut [Centre]) {
        let width = self.width();
        let (rows, columns) = (centres.len() / width, (width - first).min(8));
        let mut rays = RayStream::<ROWS>::NONE;
        rays.tmax = [f32x8::splat(f32::MAX); ROWS];
        for row in 0..rows {
            let (x0, x1) = (first as u32, (first + columns) as u32);
            set_row(self.camera, &mut rays, row, aims8(self.camera, x0, x1, (y + row) as u32, 0));
        }
        let own = ((1u16 << columns) - 1) as u8;
        let active = (0..rows).fold(0u32, |bits, row| bits | u32::from(own) << (8 * row));
        let found = self.tracer.still.accel.closest32(&rays, active);
        let sun = self.tracer.environment.sun.as_ref();
        let (mut to_sun, mut asked) = (RayStream::<ROWS>::NONE, 0u32);
        let place = |lane: usize| lane / 8 * width + first + lane % 8;
        for lane in lanes(active) {
            let Some(hit) = found.get(lane) else { continue };
            let point = SurfaceInteraction::new(&self.tracer.still.instances, &rays.ray(lane), &hit);
            let normals = PackedNormals::new(&point);
            let is_lens = matches!(point.material.surface, Surface::SignalLens(_));
            let hit = PackedHit::new(&hit);
            centres[place(lane)] = Centre { distance: point.distance, hit, normals, is_lens, sun: SunSeen::Never };
            if let Some(sun) = sun.filter(|sun| sun_can_light(&point, sun.direction)) {
                asked |= 1 << lane;
                to_sun.set(lane, &to_part(sun, &point, 0, FIRST));
            }
        }
        if asked != 0 {
            let shaded = self.tracer.still.accel.occluded32(&to_sun, asked);
            for lane in lanes(asked) {
                centres[place(lane)].sun = if shaded >> lane & 1 == 1 { SunSeen::Shaded } else { SunSeen::Lit };
            }
        }
    }

    /// Whether the surface of each pixel of a row goes on. The picture's edges end nothing.
    fn compare_row(&self, centres: &[Centre], y: usize, goes_on: &mut [GoesOn]) {
        let (width, height) = (self.width(), self.camera.size.height as usize);
        let goes = |x: usize, (to_x, to_y): (usize, usize)| {
            let (own, other) = (&centres[y * width + x], &centres[to_y * width + to_x]);
            own.evidently_continues(other)
                .unwrap_or_else(|| same_piece(&self.piece_of(own, x, y), &self.piece_of(other, to_x, to_y)))
        };
        for (x, goes_on) in goes_on.iter_mut().enumerate() {
            goes_on.right = x + 1 == width || goes(x, (x + 1, y));
            goes_on.below = y + 1 == height || goes(x, (x, y + 1));
        }
    }

    fn piece_of(&self, centre: &Centre, x: usize, y: usize) -> Option<Piece> {
        let ray = sample_ray(self.camera, x as u32, y as u32, 0);
        piece(self.tracer.still, &ray, centre.distance, centre.hit, &centre.normals)
    }

    /// The pixels around which some lie in the light of the sun and some do not.
    fn near_shadow_edges(&self, centres: &[Centre]) -> Vec<bool> {
        let width = self.width();
        if self.tracer.environment.sun.is_none() {
            return vec![false; centres.len()];
        }
        let mut edges = vec![false; centres.len()];
        edges.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
            for (x, edge) in row.iter_mut().enumerate() {
                let here = y * width + x;
                let other = |there: usize| match (centres[here].sun, centres[there].sun) {
                    (SunSeen::Never, _) | (_, SunSeen::Never) => false,
                    (here, there) => here != there,
                };
                *edge = (x + 1 < width && other(here + 1)) || (here + width < centres.len() && other(here + width));
            }
        });
        // How far from there, by the width of a pixel.
        let reach = |centre: &Centre| ((PENUMBRA_M / (centre.distance * self.pixel_angle)) as usize).clamp(1, PENUMBRA);
        let near = |edges: &[bool], count: usize, at: usize, stride: usize, reach: usize| {
            let (line, first) = (at / stride, at % stride);
            (line.saturating_sub(reach)..(line + reach + 1).min(count)).any(|line| edges[line * stride + first])
        };
        let mut wide = vec![false; centres.len()];
        wide.par_chunks_mut(width).enumerate().for_each(|(y, wide)| {
            let row = y * width..(y + 1) * width;
            let (edges, centres) = (&edges[row.clone()], &centres[row]);
            if edges.iter().any(|edge| *edge) {
                for (x, wide) in wide.iter_mut().enumerate() {
                    *wide = near(edges, width, x, 1, reach(&centres[x]));
                }
            }
        });
        let height = centres.len() / width;
        edges.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
            for (x, edge) in row.iter_mut().enumerate() {
                let here = y * width + x;
                *edge = centres[here].sun != SunSeen::Never && near(&wide, height, here, width, reach(&centres[here]));
            }
        });
        edges
    }
}

/// The centres of all pixels, and around which of them more must be traced.
pub(super) struct SparsePrimary<'a> {
    pass: &'a BakePass<'a>,
    centres: Vec<Centre>,
    goes_on: Vec<GoesOn>,
    near_shadow_edge: Vec<bool>,
}

/// What is kept of a row of [`PrimaryHits`](super::primary_hits::PrimaryHits): nothing seen yet.
pub(super) struct KeptRow<'a> {
    pub(super) distances: &'a mut [[f32; SAMPLES]],
    pub(super) sun_free: &'a mut [[u8; SAMPLES]],
    pub(super) uniform: &'a mut [bool],
}

impl SparsePrimary<'_> {
    /// What [`BakePass::trace`] finds in a row, by fewer rays. Of the surfaces of uniform pixels it tells those of the centres.
    pub(super) fn trace_row(&self, y: usize, kept: KeptRow<'_>) -> RowSurfaces {
        let width = self.pass.width();
        let row = y * width..(y + 1) * width;
        // Which samples lie between the centre and those of neighbours on the same surface.
        let known = |x: usize| {
            let here = y * width + x;
            let left = x == 0 || self.goes_on[here - 1].right;
            let above = y == 0 || self.goes_on[here - width].below;
            [true, self.goes_on[here].right, left && self.goes_on[here].below, above]
        };
        let mut surfaces = RowSurfaces::nothing(width);
        let (hits, normals) = (&mut surfaces.hits[..], &mut surfaces.normals[..]);
        let (centres, edges) = (&self.centres[row.clone()], &self.near_shadow_edge[row]);
        let KeptRow { distances, sun_free, uniform } = kept;
        SparseRow { pass: self.pass, y, centres, edges, distances, hits, normals, sun_free, uniform }.fill(known);
        surfaces
    }
}
