//! Baking of irradiance probes.

use super::gather::brightest;
use super::harmonics::SphericalHarmonics;
use super::probe_grid::{Probe, ProbeGrid, ProbeRegion};
use crate::accel::Ray;
use crate::light::{Environment, LampMaps};
use crate::material::noise;
use crate::sampling::{hammersley, rotated, sphere_direction};
use crate::scene::StaticScene;
use crate::shade::{Tracer, shade_hit};
use endless_scene::Surface;
use glam::{Vec2, Vec3A};
use rayon::prelude::*;
use std::f32::consts::PI;

/// Rays a probe, by bounce.
const RAYS: [u32; 2] = [64, 144];

impl ProbeGrid {
    /// Bakes probes over a rectangle of ground: first light that bounced once, then twice.
    pub(crate) fn bake(
        still: &StaticScene,
        environment: &Environment,
        lamp_maps: &LampMaps,
        region: &ProbeRegion,
    ) -> Self {
        let mut grid = Self::over(region);
        let (columns, rows) = (grid.size.x, grid.size.y);
        for rays in RAYS {
            let known = (!grid.probes.is_empty()).then_some(&grid);
            let tracer = Tracer { still, moving: None, environment, lamp_maps, probes: known };
            let probes = (0..columns * rows * grid.size.z)
                .into_par_iter()
                .map(|i| {
                    let (x, y, z) = (i % columns, i / columns % rows, i / (columns * rows));
                    probe(&tracer, grid.position(x, y, z), i ^ noise::hash(region.pattern), rays)
                })
                .collect();
            grid.probes = probes;
        }
        grid
    }
}

fn probe(tracer: &Tracer<'_>, position: Vec3A, pattern: u32, rays: u32) -> Probe {
    let mut light = SphericalHarmonics::ZERO;
    let mut behind = 0u32;
    let limit = Vec3A::splat(brightest(tracer.environment));
    let turn = Vec2::new(noise::cell1(pattern, 1), noise::cell1(pattern, 2));
    for k in 0..rays {
        let direction = sphere_direction(rotated(hammersley(k, rays), turn));
        let ray = Ray { origin: position, direction, tmax: f32::MAX };
        let struck = tracer.closest(&ray);
        if let Some(struck) = &struck {
            let point = tracer.point(&ray, struck);
            behind += u32::from(point.from_behind && point.material.surface != Surface::Foliage);
        }
        let radiance = shade_hit(tracer, &ray, struck.as_ref(), 0.6);
        light.add(direction, radiance.min(limit), 4.0 * PI / rays as f32);
    }
    let inside = behind as f32 / rays as f32;
    Probe { light, trust: (1.0 - inside * 4.0).clamp(0.0, 1.0) }
}
