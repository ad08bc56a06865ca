//! Walls and roofs; uv is in metres along and up.

use super::noise_questions::NoiseQuestions;
use super::per_pixel::{PerPixel, edge_distance, smoothstep, smoothstep_between};
use super::pixel_group::PixelGroup;
use super::{Bsdf, noise};
use crate::scene::SurfaceInteraction;
use endless_world::math::UnfusedVec3A;
use glam::{IVec2, Vec2, Vec3A};

/// Dirt that rain leaves on a wall: streaks downwards, a splash zone at the foot.
fn weathering<G: PixelGroup>(at: &G) -> G::Number {
    let along = at.each(|point| {
        point.position.x * point.geometric_normal.y.abs() + point.position.y * point.geometric_normal.x.abs()
    });
    weathering_at(along, at.each(|point| point.position.z), at.footprint_m())
}

fn weathering_at<N: PerPixel>(along: N, height: N, footprint: N) -> N {
    let mut batch = N::Noise::new(footprint);
    let asked = [
        batch.fbm2([along, height * 0.12], 0.6, 4),
        batch.fbm2([along, height], 3.5, 4),
        // Whole stretches of wall age differently; soot and runoff darken more than sun bleaches.
        batch.fbm2([along + 19.0, height * 0.6 + 19.0], 11.0, 2),
    ];
    let [streaks, broad, large] = asked.map(batch.found());
    let foot = smoothstep(0.0, 1.1, height + broad * 0.25) * 0.30 + 0.70;
    let runs = smoothstep(0.12, 0.5, streaks + broad * 0.35);
    (streaks * 0.14 + 0.95 + broad * 0.20 + large * 0.18 - runs * 0.20) * foot
}

/// Where pixels lie in a running bond of stones of a size, metres: the distance to the nearest joint, and the stone.
fn bond<N: PerPixel>(uv: [N; 2], size: [f32; 2]) -> (N, [N; 2]) {
    let row = (uv[1] / size[1]).floor();
    let shifted = [uv[0] / size[0] + (row - (row * 0.5).floor() * 2.0) * 0.5, uv[1] / size[1]];
    let cell = shifted.map(N::floor);
    (edge_distance(std::array::from_fn(|k| (shifted[k] - cell[k]) * size[k]), size), cell)
}

/// [`noise::tint`] of cells.
fn tint<N: PerPixel>(cell: [N; 2], salt: u32, spread: f32) -> [N; 3] {
    let [grey, red, green, blue] = std::array::from_fn(|k| N::cell2(cell, salt + k as u32) - 0.5);
    let grey = grey * 2.0 * spread + 1.0;
    [grey + red * spread * 0.4, grey + green * spread * 0.3, grey + blue * spread * 0.4]
}

/// Weathering, how far single bricks are seen, the share of mortar, and the tint of the brick.
pub(super) fn brick_look<G: PixelGroup>(at: &G) -> [G::Number; 6] {
    let (edge, cell) = bond(at.uv(), [0.25, 0.075]);
    let [seen, mortar] = mortar(edge, at.footprint_m());
    let [red, green, blue] = tint(cell, 61, 0.28);
    [weathering(at), seen, mortar, red, green, blue]
}

fn mortar<N: PerPixel>(edge: N, footprint: N) -> [N; 2] {
    let seen = (N::splat(0.05) / footprint.max(N::splat(1e-3))).min(N::ONE);
    let joint = N::ONE - smoothstep_between(N::splat(0.005), footprint.max(N::splat(0.004)) + 0.005, edge);
    [seen, joint * seen + (N::ONE - seen) * 0.16]
}

pub(super) fn brick(point: &SurfaceInteraction<'_>, base: Vec3A, look: [f32; 6]) -> Bsdf {
    let [weathering, seen, mortar, tint @ ..] = look;
    let each = Vec3A::ONE.lerp_unfused(Vec3A::from_array(tint), seen);
    let body = base * each * weathering;
    Bsdf::matte(body.lerp_unfused(Vec3A::new(0.42, 0.40, 0.37), mortar * 0.8), point.normal)
}

/// Tone of plaster.
pub(super) fn plaster_look<G: PixelGroup>(at: &G) -> [G::Number; 1] {
    let fine = PerPixel::filtered_fbm2(at.uv(), 0.12, 3, at.footprint_m()) * 0.08 + 0.94;
    [fine * weathering(at)]
}

pub(super) fn plaster(point: &SurfaceInteraction<'_>, base: Vec3A, [tone]: [f32; 1]) -> Bsdf {
    Bsdf::matte(base * tone, point.normal)
}

/// Tone and tint of ashlar.
pub(super) fn stone_look<G: PixelGroup>(at: &G) -> [G::Number; 4] {
    let (edge, cell) = bond(at.uv(), [0.8, 0.4]);
    let [red, green, blue] = tint(cell, 62, 0.12);
    [weathering(at) * joints(edge, 0.008, 0.4, at.footprint_m()), red, green, blue]
}

/// What joints half as wide as given, metres, leave of the tone, being darker by a share.
fn joints<N: PerPixel>(edge: N, half_width: f32, darker: f32, footprint: N) -> N {
    let blurred = footprint.max(N::splat(0.006)) + half_width;
    let joint = N::ONE - smoothstep_between(N::splat(half_width), blurred, edge);
    N::ONE - joint * darker
}

pub(super) fn stone(point: &SurfaceInteraction<'_>, base: Vec3A, [tone, tint @ ..]: [f32; 4]) -> Bsdf {
    Bsdf::matte(base * Vec3A::from_array(tint) * tone, point.normal)
}

/// Tone of panels.
pub(super) fn cladding_look<G: PixelGroup>(at: &G) -> [G::Number; 1] {
    const PANEL_M: [f32; 2] = [1.2, 0.9];
    let uv = at.uv();
    let cell: [G::Number; 2] = std::array::from_fn(|k| (uv[k] / PANEL_M[k]).floor());
    let edge = edge_distance(std::array::from_fn(|k| uv[k] - cell[k] * PANEL_M[k]), PANEL_M);
    let each = (PerPixel::cell2(cell, 63) - 0.5) * 0.08 + 1.0;
    [each * weathering(at) * joints(edge, 0.006, 0.5, at.footprint_m())]
}

pub(super) fn cladding(point: &SurfaceInteraction<'_>, base: Vec3A, [tone]: [f32; 1]) -> Bsdf {
    let mut bsdf = Bsdf::matte(base * tone, point.normal);
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

/// Tone of a flat roof.
pub(super) fn flat_roof_look<G: PixelGroup>(at: &G) -> [G::Number; 1] {
    [PerPixel::filtered_fbm2(at.plan(), 4.0, 5, at.footprint_m()) * 0.42 + 0.95]
}

pub(super) fn flat_roof(point: &SurfaceInteraction<'_>, base: Vec3A, [tone]: [f32; 1]) -> Bsdf {
    Bsdf::matte(base * tone, point.normal)
}

pub(super) fn wood(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let board = (point.uv.x / 0.14).floor();
    let local = point.uv.x / 0.14 - board;
    let seen = (0.05 / footprint.max(1e-3)).min(1.0);
    let gap = seen * (1.0 - smoothstep(0.0, 0.08, local.min(1.0 - local)));
    let each = noise::tint(IVec2::new(board as i32, 0), 65, 0.2 * seen);
    let grain = 1.0 + 0.25 * noise::filtered_fbm2(point.uv * Vec2::new(1.0, 0.07), 0.06, 3, footprint);
    Bsdf::matte(base * each * (grain * (1.0 - 0.6 * gap)), point.normal)
}
