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
use super::sun_rays::{sun_can_light, sun_origin};
use crate::accel::{Ray, RayStream, lanes};
use crate::camera_rays::{aims8, sample_ray, set_row};
use crate::light::{SUN_SAMPLES, Sun};
use crate::octahedron;
use crate::sampling::SAMPLES;
use crate::scene::{ShadingPoint, StaticScene, SurfaceInteraction};
use crate::vec3x8::{Vec3x8, dot};
use endless_scene::Surface;
use glam::Vec3A;
use rayon::prelude::*;
use std::ops::Range;
use wide::f32x8;

/// Rows of pixels whose centres are traced together, eight columns at a time.
const ROWS: usize = 4;
/// The part of the sun's disc that is asked everywhere: half-way between its middle and its rim.
const FIRST: usize = 1;
/// The parts of it that each sample asks near the edge of a shadow: eight directions a pixel.
const PARTS: [usize; 2] = [FIRST, 3];
/// All parts of it.
const WHOLE: u8 = (1 << SUN_SAMPLES) - 1;
/// How far from the edge of a shadow all of the disc is asked, at most: pixels.
const PENUMBRA: usize = 4;
/// Half the width of the shadow's edge of something five metres away.
const PENUMBRA_M: f32 = 0.023;

/// What the ray through a pixel's centre met.
#[derive(Clone, Copy)]
struct Centre {
    distance: f32,
    hit: PackedHit,
    normals: PackedNormals,
    /// On a lens of a traffic light.
    is_lens: bool,
    sun: SunSeen,
}

/// What a sample's ray to the first part of the sun's disc says.
#[derive(Clone, Copy, PartialEq, Eq)]
enum SunSeen {
    /// The sun cannot light it, or there is none.
    Never,
    Lit,
    Shaded,
}

impl Centre {
    const SKY: Self = Self {
        distance: f32::MAX,
        hit: PackedHit::NONE,
        normals: PackedNormals::NONE,
        is_lens: false,
        sun: SunSeen::Never,
    };

    fn is_sky(&self) -> bool {
        self.distance == f32::MAX
    }

    /// Whether a neighbour's centre lies on the same surface, or sees the sky, too; where that takes no look at the scene.
    fn evidently_continues(&self, other: &Self) -> Option<bool> {
        if self.is_sky() || other.is_sky() {
            return Some(self.is_sky() && other.is_sky());
        }
        let flat = self.hit.is_on_triangle_of(&other.hit) && self.normals.shading == other.normals.shading;
        flat.then_some(!self.is_lens)
    }
}

/// The surface around a sample, as far as it tells whether others lie on it.
#[derive(Clone, Copy)]
struct Piece {
    instance: u32,
    material: u16,
    /// Lenses of traffic lights are pixels of their own.
    lens: bool,
    position: Vec3A,
    geometric: Vec3A,
    shading: Vec3A,
}

impl Piece {
    fn continues(&self, other: &Self) -> bool {
        self.instance == other.instance
            && self.material == other.material
            && !self.lens
            && self.shading.dot(other.shading) > 0.995
            && (other.position - self.position).dot(self.geometric).abs() < 0.02
    }
}

/// Whether both lie on one surface, or see the sky.
fn same_piece(a: &Option<Piece>, b: &Option<Piece>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a.continues(b),
        (None, None) => true,
        _ => false,
    }
}

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

/// The ray of a point to a part of the sun's disc, as a sample of a pixel asks it.
fn to_part(sun: &Sun, point: &SurfaceInteraction<'_>, sample: usize, part: usize) -> Ray {
    Ray { origin: sun_origin(&point.facet(), sun.direction), direction: sun.disc[sample][part], tmax: f32::MAX }
}

fn piece(still: &StaticScene, ray: &Ray, distance: f32, hit: PackedHit, normals: &PackedNormals) -> Option<Piece> {
    let hit = hit.at(distance)?;
    let mesh = &*still.instances[hit.instance as usize].geometry.mesh;
    let material = mesh.triangle_materials[hit.triangle as usize];
    Some(Piece {
        instance: hit.instance,
        material,
        lens: matches!(mesh.materials[usize::from(material)].surface, Surface::SignalLens(_)),
        position: ray.origin + ray.direction * distance,
        geometric: octahedron::unpack(normals.geometric),
        shading: octahedron::unpack(normals.shading),
    })
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

/// A row of pixels whose centres are known.
struct SparseRow<'a> {
    pass: &'a BakePass<'a>,
    y: usize,
    centres: &'a [Centre],
    /// Which are near the edge of a shadow.
    edges: &'a [bool],
    distances: &'a mut [[f32; SAMPLES]],
    hits: &'a mut [[PackedHit; SAMPLES]],
    normals: &'a mut [[PackedNormals; SAMPLES]],
    sun_free: &'a mut [[u8; SAMPLES]],
    uniform: &'a mut [bool],
}

/// Samples that are traced together.
struct Bundle {
    rays: RayStream<ROWS>,
    places: [(usize, usize); 8 * ROWS],
    count: usize,
}

impl SparseRow<'_> {
    /// `known` tells of each pixel the samples that lie on the surface of its centre.
    fn fill(&mut self, known: impl Fn(usize) -> [bool; SAMPLES]) {
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
            let directions = self.pass.directions_of(self.y * width + first, pixels.len());
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
            let directions = self.pass.directions_of(self.y * width + first, pixels.len());
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
