//! Rain on surfaces: wet ground darkens and shines; puddles mirror.

use super::Bsdf;
use super::per_pixel::PerPixel;
use super::pixel_group::PixelGroup;
use crate::light::Environment;
use crate::scene::SurfaceInteraction;
use endless_scene::Surface;
use endless_world::math::smoothstep;
use glam::Vec3A;

/// What the film of water on wet ground is like: where it dries first, where the ground is low, and two slopes of its
/// grain.
pub(super) fn film_look<G: PixelGroup>(at: &G, environment: &Environment) -> [G::Number; 4] {
    film(at.plan(), environment.rain == 0.0, at.footprint_m())
}

fn film<N: PerPixel>(p: [N; 2], drying: bool, footprint: N) -> [N; 4] {
    let patches = if drying { N::filtered_fbm2(p, 5.0, 4, footprint) } else { N::splat(0.0) };
    let hollow = N::filtered_fbm2(p.map(|axis| axis + 300.0), 6.5, 4, footprint);
    let q = p.map(|axis| axis * 38.0);
    [patches, hollow, N::value2(q, 101), N::value2(q, 102)]
}

/// Whether water stays on a surface as a film.
pub(super) fn bears_film(surface: Surface) -> bool {
    matches!(
        surface,
        Surface::Asphalt
            | Surface::RoadPaint
            | Surface::Paving
            | Surface::Cobbles
            | Surface::Kerb
            | Surface::Concrete
            | Surface::FlatRoof
    )
}

/// Makes a BSDF wet, as far as rain reaches the surface and stays on it; `film` is asked for what [`film_look`] finds.
pub(super) fn wet(
    bsdf: &mut Bsdf,
    point: &SurfaceInteraction<'_>,
    environment: &Environment,
    film: impl FnOnce() -> [f32; 4],
    jitter: f32,
) {
    let surface = point.material.surface;
    let up = smoothstep(0.3, 0.9, point.normal.z);
    match surface {
        _ if bears_film(surface) => ground(bsdf, point, environment, film(), jitter, up),
        Surface::Soil | Surface::Gravel | Surface::Grass | Surface::Bark | Surface::Wood | Surface::RoofTile => {
            bsdf.albedo *= 1.0 - 0.4 * environment.wetness * up.max(0.3);
            bsdf.roughness *= 0.8;
        }
        Surface::Brick | Surface::Plaster | Surface::Stone => bsdf.albedo *= 1.0 - 0.14 * environment.wetness,
        Surface::Foliage => {
            bsdf.roughness = 0.4;
            bsdf.specular = 0.04;
        }
        _ => {}
    }
}

fn ground(
    bsdf: &mut Bsdf,
    point: &SurfaceInteraction<'_>,
    environment: &Environment,
    [patches, hollow, x, y]: [f32; 4],
    jitter: f32,
    up: f32,
) {
    let mut wetness = environment.wetness;
    if environment.rain == 0.0 {
        // Drying after rain: patches and wheel paths first.
        wetness *= 1.0 - 0.75 * smoothstep(-0.1, 0.45, patches + 0.25);
    }
    wetness *= up;
    // Lagarde 2013: water in the pores darkens and smooths.
    let porous = if point.material.surface == Surface::RoadPaint { 0.25 } else { 0.52 };
    bsdf.albedo *= 1.0 - porous * wetness;
    bsdf.roughness += (0.38 - bsdf.roughness) * wetness;
    bsdf.specular += (0.03 - bsdf.specular) * wetness;
    // Puddles where the ground is low: broad hollows, gutters along kerbs, ruts.
    let rut = if point.uv.y.abs() < 2.2 && point.material.surface == Surface::Asphalt {
        0.10 * (1.0 - smoothstep(0.1, 0.5, (point.uv.y.abs() - 0.78).abs()))
    } else {
        0.0
    };
    let level = 0.5 - environment.puddles;
    let puddle = smoothstep(level, level + 0.16, hollow + rut + 0.12) * up * environment.wetness.min(1.0);
    let film = 0.42 * wetness;
    bsdf.coat = film.max(puddle);
    bsdf.coat_f0 = Vec3A::splat(0.02);
    bsdf.coat_roughness = 0.32 + (0.05 - 0.32) * puddle;
    bsdf.albedo *= 1.0 - 0.35 * puddle;
    // The film follows the grain of the ground, so its image is broken up and smeared; puddles lie flat.
    let spread = 0.045 * (1.0 - puddle) + 0.004 + 0.006 * environment.rain;
    let tilt = Vec3A::new(x + jitter - 0.5, y + (jitter * 7.0).fract() - 0.5, 0.0);
    bsdf.coat_normal = (Vec3A::Z + tilt * spread).normalize();
    if puddle < 0.5 && up < 0.9 {
        bsdf.coat_normal = bsdf.normal;
    }
}
