//! The pass of a bake that gathers light: where it varies, not everywhere.
//!
//! Rays leave from one point of every two by two pixels (of more in large pictures). What they bring is denoised, and the
//! samples around take it from the points that lie on their own surface. Samples with no such point (edges, leaves, wires)
//! send rays themselves, a third as many or fewer. What these bring is denoised among such samples, and mixed with the
//! light in the open, of which the probes tell, darkened as it is at the points around.

use super::bake_pass::BakePass;
use super::bake_stats::timed;
use super::edge_samples::EdgeSamples;
use super::point_grid::{PointGrid, spacing};
use super::primary_hits::PrimaryHits;
use crate::indirect::{DenoiseGuide, GatherPoint, HitTape, PATTERN_SIDE, RayEnd, TapeStack, denoise, gather8, turn};
use crate::rgb9e5::Rgb9e5;
use crate::sampling::SAMPLES;
use crate::settings::Gathering;
use crate::shade::footprint_m;
use crate::work_share;
use endless_world::math::UnfusedVec3A;
use glam::{Vec2, Vec3A};
use rayon::prelude::*;
use wide::f32x8;

/// How much the light of samples that gather for themselves is that of the points around, where there are such.
const NEARBY_WEIGHT: f32 = 0.5;
/// In pictures at least this wide, samples that gather for themselves send half as many rays: the noise that these leave
/// is as fine as their pixels.
const WIDE: usize = 900;
/// The most that a point may get of the light in the open: where that is nearly none, shares mean nothing.
const MOST_SHARE: f32 = 3.0;

/// What was gathered.
pub(super) struct GatheredLight {
    /// Irradiance of every sample, klx.
    pub(super) irradiance: Vec<[Rgb9e5; SAMPLES]>,
    /// Ends of the rays from points of a grid, and from samples at edges.
    pub(super) points: TapeStack,
    pub(super) edges: TapeStack,
}

impl GatheredLight {
    /// The probes tell it where it is needed.
    const NOTHING: Self = Self { irradiance: Vec::new(), points: TapeStack::EMPTY, edges: TapeStack::EMPTY };
}

/// What is gathered from.
pub(super) struct IrradiancePass<'a> {
    pub(super) bake: &'a BakePass<'a>,
    pub(super) primary: &'a PrimaryHits,
}

/// What was gathered at the points of a picture, row by row.
struct GatheredPicture {
    guides: Vec<DenoiseGuide>,
    light: Vec<Vec3A>,
    /// By row.
    tapes: Vec<Vec<RayEnd>>,
}

impl IrradiancePass<'_> {
    /// Irradiance of every sample, klx; and the ends of the rays, if these are to be kept.
    pub(super) fn gather(&self) -> GatheredLight {
        match self.bake.settings.gathering {
            Gathering::Interpolated { rays } => self.interpolated(rays),
            Gathering::EverySample { rays } => self.every_sample(rays),
            Gathering::Probes => GatheredLight::NOTHING,
        }
    }

    fn width(&self) -> usize {
        self.bake.camera.size.width as usize
    }

    fn height(&self) -> usize {
        self.bake.camera.size.height as usize
    }

    /// The surface that a sample saw: four times the pixel's place, and its own in the pixel.
    fn point(&self, index: usize) -> Option<GatherPoint> {
        self.primary.pixel(index / SAMPLES).gather_point(&self.bake.ray_of(index), index % SAMPLES)
    }

    fn guide(&self, GatherPoint { facet, normal }: &GatherPoint, pixels: usize) -> DenoiseGuide {
        let reach_m = (footprint_m(facet, self.bake.pixel_angle) * pixels as f32).max(0.01);
        DenoiseGuide { position: facet.position, normal: *normal, reach_m }
    }

    /// Gathers for eight points that share a pattern of rays.
    fn gather_eight(
        &self,
        tape: &mut HitTape<'_>,
        points: &[Option<GatherPoint>; 8],
        turn: Vec2,
        rays: u32,
    ) -> [Vec3A; 8] {
        self.bake.stats.add(u64::from(rays) * 16);
        gather8(&self.bake.tracer, tape, points, turn, rays)
    }

    /// Every sample's light, taken from the points around or gathered there.
    fn interpolated(&self, rays: u32) -> GatheredLight {
        let (grid, points) = timed("gather at points", || self.points(rays));
        let mut irradiance = vec![[Rgb9e5::ZERO; SAMPLES]; self.primary.uniform.len()];
        let rows = irradiance.par_chunks_mut(self.width()).enumerate().with_max_len(work_share::ROWS);
        let edges: Vec<usize> =
            timed("interpolate", || rows.flat_map_iter(|(y, row)| self.interpolate_row(&grid, y, row)).collect());
        let (light, at_edges) = timed("gather at edges", || self.gather_at_edges(&edges, self.rays_at_edges(rays)));
        for (own, &index) in light.into_iter().zip(&edges) {
            let kept = &mut irradiance[index / SAMPLES][index % SAMPLES];
            let nearby = kept.get();
            let light = if nearby == Vec3A::ZERO { own } else { own.lerp_unfused(nearby, NEARBY_WEIGHT) };
            *kept = Rgb9e5::new(light);
        }
        GatheredLight { irradiance, points, edges: at_edges }
    }

    /// Rays of a sample that gathers for itself, where points have so many.
    fn rays_at_edges(&self, rays: u32) -> u32 {
        rays.div_ceil(if self.width() < WIDE { 3 } else { 6 })
    }

    /// Gathers at samples, and denoises among them.
    fn gather_at_edges(&self, edges: &[usize], rays: u32) -> (Vec<Vec3A>, TapeStack) {
        let blocks = edges.par_chunks(64).enumerate().with_max_len(work_share::PLACES);
        let (light, tapes): (Vec<[[Vec3A; 8]; 8]>, Vec<Vec<RayEnd>>) =
            blocks.map(|(block, edges)| self.gather_block(block, edges, rays)).unzip();
        let light = (0..edges.len()).map(|k| light[k / 64][k % 8][k / 8 % 8]).collect();
        let guide = |&index: &usize| self.point(index).map_or(DenoiseGuide::SKY, |point| self.guide(&point, 1));
        let guides = edges.par_iter().map(guide).collect();
        let clean = EdgeSamples::new(self.width(), self.height(), edges, guides).denoise(light);
        (clean, TapeStack::new(tapes))
    }

    /// Gathers for 64 samples, one after the other in the picture: those of a pixel have different patterns.
    fn gather_block(&self, block: usize, edges: &[usize], rays: u32) -> ([[Vec3A; 8]; 8], Vec<RayEnd>) {
        let mut tape = self.bake.indirect.tape(|hits| &hits.edges, block);
        let light = std::array::from_fn(|k| {
            let points = std::array::from_fn(|i| self.point(*edges.get(8 * i + k)?));
            self.gather_eight(&mut tape, &points, turn(k, block, self.bake.settings.pattern), rays)
        });
        (light, tape.into_ends())
    }

    /// Gathers at the points of the grid, and denoises.
    fn points(&self, rays: u32) -> (PointGrid, TapeStack) {
        let spacing = spacing(self.width());
        let GatheredPicture { guides, light, tapes } = self.gather_picture(spacing, 0, rays);
        let width = self.width().div_ceil(spacing);
        let light = denoise(width, &guides, light, 4);
        let share = guides.par_iter().zip(&light).map(|(guide, light)| self.share(guide, *light)).collect();
        (PointGrid::new(width, spacing, guides, light, share), TapeStack::new(tapes))
    }

    /// Light at a point as a share of that in the open.
    fn share(&self, here: &DenoiseGuide, light: Vec3A) -> Vec3A {
        if here.normal == Vec3A::ZERO {
            return Vec3A::ZERO;
        }
        (light / self.in_the_open(here).max(Vec3A::splat(1e-9))).min(Vec3A::splat(MOST_SHARE))
    }

    /// Light at a place as the probes in the air tell of it.
    fn in_the_open(&self, here: &DenoiseGuide) -> Vec3A {
        self.bake.tracer.ambient(here.position + here.normal * 0.25, here.normal)
    }

    /// Takes the light of a row's samples from the points around; gives the samples for which that does not do. What
    /// those take is a share of the light in the open, or nothing.
    fn interpolate_row(&self, grid: &PointGrid, y: usize, row: &mut [[Rgb9e5; SAMPLES]]) -> Vec<usize> {
        let mut edges = Vec::new();
        let mut directions = [[f32x8::ZERO; 3]; SAMPLES];
        for (x, pixel) in row.iter_mut().enumerate() {
            let index = (y * self.width() + x) * SAMPLES;
            if x % 8 == 0 {
                directions = self.bake.aims_of(index / SAMPLES, (self.width() - x).min(8));
            }
            let here = |sample: usize| {
                let ray = self.bake.ray_along(&directions[sample], x % 8);
                Some(self.guide(&self.primary.pixel(index / SAMPLES).gather_point(&ray, sample)?, grid.spacing))
            };
            if self.primary.uniform[index / SAMPLES]
                && let Some(light) = here(0).and_then(|here| grid.on_surface(&here, x, y))
            {
                *pixel = [Rgb9e5::new(light); SAMPLES];
                continue;
            }
            for (sample, light) in pixel.iter_mut().enumerate() {
                let Some(here) = here(sample) else { continue };
                *light = Rgb9e5::new(grid.on_surface(&here, x, y).unwrap_or_else(|| {
                    edges.push(index + sample);
                    grid.share_nearby(&here, x, y).map_or(Vec3A::ZERO, |share| share * self.in_the_open(&here))
                }));
            }
        }
        edges
    }

    /// Gathers at every sample, and denoises each of a pixel's as a picture of its own.
    fn every_sample(&self, rays: u32) -> GatheredLight {
        let mut all = vec![[Rgb9e5::ZERO; SAMPLES]; self.primary.uniform.len()];
        let mut points = Vec::new();
        for sample in 0..SAMPLES {
            let GatheredPicture { guides, light, tapes } = self.gather_picture(1, sample, rays);
            points.extend(tapes);
            let clean = denoise(self.width(), &guides, light, 5);
            all.par_iter_mut().zip(clean).for_each(|(pixel, light)| pixel[sample] = Rgb9e5::new(light));
        }
        GatheredLight { irradiance: all, points: TapeStack::new(points), edges: TapeStack::EMPTY }
    }

    /// Gathers for one sample of every pixel, or of those `spacing` apart.
    fn gather_picture(&self, spacing: usize, sample: usize, rays: u32) -> GatheredPicture {
        let (width, height) = (self.width().div_ceil(spacing), self.height().div_ceil(spacing));
        let mut guides = vec![DenoiseGuide::SKY; width * height];
        let mut light = vec![Vec3A::ZERO; width * height];
        let rows = guides.par_chunks_mut(width).zip(light.par_chunks_mut(width)).enumerate();
        let tapes = rows.with_max_len(work_share::ROWS).map(|(y, (guides, light))| {
            let mut tape = self.bake.indirect.tape(|hits| &hits.points, sample * height + y);
            // Points that share a pattern of rays lie `PATTERN_SIDE` apart.
            for block in (0..width).step_by(8 * PATTERN_SIDE) {
                for first in block..(block + PATTERN_SIDE).min(width) {
                    let column = |i: usize| Some(first + i * PATTERN_SIDE).filter(|x| *x < width);
                    let index = |x: usize| (y * self.width() + x) * spacing * SAMPLES + sample;
                    let points = std::array::from_fn(|i| self.point(index(column(i)?)));
                    let turn = turn(first + 3 * sample, y + 5 * sample, self.bake.settings.pattern);
                    let gathered = self.gather_eight(&mut tape, &points, turn, rays);
                    for (i, point) in points.iter().enumerate() {
                        if let (Some(x), Some(point)) = (column(i), point) {
                            guides[x] = self.guide(point, spacing);
                            light[x] = gathered[i];
                        }
                    }
                }
            }
            tape.into_ends()
        });
        let tapes = tapes.collect();
        GatheredPicture { guides, light, tapes }
    }
}
