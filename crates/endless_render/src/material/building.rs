//! Walls and roofs; uv is in metres along and up.

use super::noise_batch::NoiseBatch;
use super::{Bsdf, noise};
use crate::scene::SurfaceInteraction;
use endless_world::math::UnfusedVec3A;
use endless_world::math::smoothstep;
use glam::{Vec2, Vec3A};

/// Dirt that rain leaves on a wall: streaks downwards, a splash zone at the foot.
fn weathering(point: &SurfaceInteraction<'_>, footprint: f32) -> f32 {
    let p = point.position;
    let along = p.x * point.geometric_normal.y.abs() + p.y * point.geometric_normal.x.abs();
    let mut batch = NoiseBatch::new(footprint);
    let asked = [
        batch.filtered_fbm2(Vec2::new(along, p.z * 0.12), 0.6, 4),
        batch.filtered_fbm2(Vec2::new(along, p.z), 3.5, 4),
        // Whole stretches of wall age differently; soot and runoff darken more than sun bleaches.
        batch.filtered_fbm2(Vec2::new(along, p.z * 0.6) + 19.0, 11.0, 2),
    ];
    let found = batch.found();
    let [streaks, broad, large] = asked.map(|asked| found.of(asked));
    let foot = 0.70 + 0.30 * smoothstep(0.0, 1.1, p.z + 0.25 * broad);
    let runs = smoothstep(0.12, 0.5, streaks + 0.35 * broad);
    (0.95 + 0.14 * streaks + 0.20 * broad + 0.18 * large - 0.20 * runs) * foot
}

/// Offset and share of a running bond: (distance to the nearest joint, brick cell).
fn bond(uv: Vec2, size: Vec2) -> (f32, glam::IVec2) {
    let row = (uv.y / size.y).floor();
    let shifted = Vec2::new(uv.x / size.x + 0.5 * (row - 2.0 * (row * 0.5).floor()), uv.y / size.y);
    let cell = noise::corner_of(shifted);
    let local = (shifted - cell) * size;
    (local.min(size - local).min_element(), cell.as_ivec2())
}

pub(super) fn brick(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let (edge, cell) = bond(point.uv, Vec2::new(0.25, 0.075));
    let seen = (0.05 / footprint.max(1e-3)).min(1.0);
    let each = Vec3A::ONE.lerp_unfused(noise::tint(cell, 61, 0.28), seen);
    let mortar = (1.0 - smoothstep(0.005, 0.005 + footprint.max(0.004), edge)) * seen + 0.16 * (1.0 - seen);
    let body = base * each * weathering(point, footprint);
    Bsdf::matte(body.lerp_unfused(Vec3A::new(0.42, 0.40, 0.37), mortar * 0.8), point.normal)
}

pub(super) fn plaster(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let fine = 0.94 + 0.08 * noise::filtered_fbm2(point.uv, 0.12, 3, footprint);
    Bsdf::matte(base * (fine * weathering(point, footprint)), point.normal)
}

pub(super) fn stone(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let (edge, cell) = bond(point.uv, Vec2::new(0.8, 0.4));
    let joint = 1.0 - smoothstep(0.008, 0.008 + footprint.max(0.006), edge);
    let each = noise::tint(cell, 62, 0.12);
    Bsdf::matte(base * each * (weathering(point, footprint) * (1.0 - 0.4 * joint)), point.normal)
}

pub(super) fn cladding(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let (edge, cell) = {
        let size = Vec2::new(1.2, 0.9);
        let cell = noise::corner_of(point.uv / size);
        let local = point.uv - cell * size;
        (local.min(size - local).min_element(), cell.as_ivec2())
    };
    let seam = 1.0 - smoothstep(0.006, 0.006 + footprint.max(0.006), edge);
    let each = 1.0 + (noise::cell2(cell, 63) - 0.5) * 0.08;
    let mut bsdf = Bsdf::matte(base * (each * weathering(point, footprint) * (1.0 - 0.5 * seam)), point.normal);
    bsdf.roughness = 0.4;
    bsdf.specular = 0.045;
    bsdf
}

pub(super) fn roof_tile(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let size = Vec2::new(0.24, 0.32);
    let cell = noise::corner_of(point.uv / size);
    let local = point.uv / size - cell;
    let seen = (0.12 / footprint.max(1e-3)).min(1.0);
    let shade = 1.0 - 0.35 * seen * (1.0 - smoothstep(0.0, 0.22, local.y)) - 0.25 * seen * (local.x * 2.0 - 1.0).abs();
    let each = noise::tint(cell.as_ivec2(), 64, 0.18 * seen);
    let moss = smoothstep(0.25, 0.6, noise::filtered_fbm2(point.uv, 2.2, 4, footprint));
    let color = (base * each).lerp_unfused(Vec3A::new(0.12, 0.13, 0.08), moss * 0.5);
    Bsdf::matte(color * (shade + 0.1), point.normal)
}

pub(super) fn flat_roof(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let p = Vec2::new(point.position.x, point.position.y);
    let tone = 0.95 + 0.42 * noise::filtered_fbm2(p, 4.0, 5, footprint);
    Bsdf::matte(base * tone, point.normal)
}

pub(super) fn wood(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let board = (point.uv.x / 0.14).floor();
    let local = point.uv.x / 0.14 - board;
    let seen = (0.05 / footprint.max(1e-3)).min(1.0);
    let gap = seen * (1.0 - smoothstep(0.0, 0.08, local.min(1.0 - local)));
    let each = noise::tint(glam::IVec2::new(board as i32, 0), 65, 0.2 * seen);
    let grain = 1.0 + 0.25 * noise::filtered_fbm2(point.uv * Vec2::new(1.0, 0.07), 0.06, 3, footprint);
    Bsdf::matte(base * each * (grain * (1.0 - 0.6 * gap)), point.normal)
}
