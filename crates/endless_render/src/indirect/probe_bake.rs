//! Baking of irradiance probes.

use super::gather::brightest;
use super::harmonics::SphericalHarmonics;
use super::hit_tape::{HitTape, RayEnd};
use super::indirect_hits::{IndirectRays, PROBE_BOUNCES, TapeStack};
use super::probe_grid::{Probe, ProbeGrid, ProbeRegion};
use crate::accel::Ray;
use crate::material::noise;
use crate::sampling::{hammersley, rotated, sphere_direction};
use crate::shade::{Tracer, shade_hit};
use crate::work_share;
use endless_scene::Surface;
use glam::{Vec2, Vec3A};
use rayon::prelude::*;
use std::f32::consts::PI;

/// Rays a probe, by bounce.
pub(super) const RAYS: [u32; PROBE_BOUNCES] = [64, 144];

impl ProbeGrid {
    /// Bakes probes over a rectangle of ground: first light that bounced once, then twice. With the ends of their rays, if
    /// these are to be kept.
    pub(crate) fn bake(
        without_probes: &Tracer<'_>,
        region: &ProbeRegion,
        indirect: IndirectRays<'_>,
    ) -> (Self, [TapeStack; PROBE_BOUNCES]) {
        let mut grid = Self::over(region);
        let (columns, rows) = (grid.size.x, grid.size.y);
        let mut stacks = [const { TapeStack::EMPTY }; PROBE_BOUNCES];
        for (bounce, rays) in RAYS.into_iter().enumerate() {
            let known = (!grid.probes.is_empty()).then_some(&grid);
            let tracer = Tracer { probes: known, ..*without_probes };
            let (probes, tapes): (Vec<Probe>, Vec<Vec<RayEnd>>) = (0..columns * rows * grid.size.z)
                .into_par_iter()
                .with_max_len(work_share::PLACES)
                .map(|i| {
                    let (x, y, z) = (i % columns, i / columns % rows, i / (columns * rows));
                    let mut tape = indirect.tape(|hits| &hits.probes[bounce], i as usize);
                    let pattern = i ^ noise::hash(region.pattern);
                    (probe(&tracer, &mut tape, grid.position(x, y, z), pattern, rays), tape.into_ends())
                })
                .unzip();
            grid.probes = probes;
            stacks[bounce] = TapeStack::new(tapes);
        }
        (grid, stacks)
    }
}

/// The light at a place, by so many rays.
pub(super) fn probe(tracer: &Tracer<'_>, tape: &mut HitTape<'_>, position: Vec3A, pattern: u32, rays: u32) -> Probe {
    let mut light = SphericalHarmonics::ZERO;
    let mut behind = 0u32;
    let limit = Vec3A::splat(brightest(tracer.environment));
    let turn = Vec2::new(noise::cell1(pattern, 1), noise::cell1(pattern, 2));
    for k in 0..rays {
        let direction = sphere_direction(rotated(hammersley(k, rays), turn));
        let ray = Ray { origin: position, direction, tmax: f32::MAX };
        let struck = tape.closest(tracer, &ray);
        if let Some(struck) = &struck {
            let point = tracer.point(&ray, struck);
            behind += u32::from(point.from_behind && point.material.surface != Surface::Foliage);
        }
        let radiance = shade_hit(tracer, &ray, struck.as_ref(), 0.6);
        light.add(direction, radiance.min(limit), 4.0 * PI / rays as f32);
    }
    let inside = behind as f32 / rays as f32;
    Probe::new(light, (1.0 - inside * 4.0).clamp(0.0, 1.0))
}
