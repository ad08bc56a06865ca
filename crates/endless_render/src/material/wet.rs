//! Rain on surfaces: wet ground darkens and shines; puddles mirror.

use super::{Bsdf, noise};
use crate::light::Environment;
use crate::scene::SurfaceInteraction;
use endless_scene::Surface;
use endless_world::math::smoothstep;
use glam::{Vec2, Vec3A};

/// Makes a BSDF wet, as far as rain reaches the surface and stays on it.
pub(super) fn wet(
    bsdf: &mut Bsdf,
    point: &SurfaceInteraction<'_>,
    environment: &Environment,
    footprint: f32,
    jitter: f32,
) {
    let surface = point.material.surface;
    let up = smoothstep(0.3, 0.9, point.normal.z);
    match surface {
        Surface::Asphalt
        | Surface::RoadPaint
        | Surface::Paving
        | Surface::Cobbles
        | Surface::Kerb
        | Surface::Concrete
        | Surface::FlatRoof => {
            ground(bsdf, point, environment, footprint, jitter, up);
        }
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
    footprint: f32,
    jitter: f32,
    up: f32,
) {
    let p = Vec2::new(point.position.x, point.position.y);
    let mut wetness = environment.wetness;
    if environment.rain == 0.0 {
        // Drying after rain: patches and wheel paths first.
        let dry = noise::filtered_fbm2(p, 5.0, 4, footprint) + 0.25;
        wetness *= 1.0 - 0.75 * smoothstep(-0.1, 0.45, dry);
    }
    wetness *= up;
    // Lagarde 2013: water in the pores darkens and smooths.
    let porous = if point.material.surface == Surface::RoadPaint { 0.25 } else { 0.52 };
    bsdf.albedo *= 1.0 - porous * wetness;
    bsdf.roughness += (0.38 - bsdf.roughness) * wetness;
    bsdf.specular += (0.03 - bsdf.specular) * wetness;
    // Puddles where the ground is low: broad hollows, gutters along kerbs, ruts.
    let hollow = noise::filtered_fbm2(p + 300.0, 6.5, 4, footprint);
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
    let q = p * 38.0;
    let tilt = Vec2::new(noise::value2(q, 101) + jitter - 0.5, noise::value2(q, 102) + (jitter * 7.0).fract() - 0.5);
    bsdf.coat_normal = (Vec3A::Z + Vec3A::new(tilt.x, tilt.y, 0.0) * spread).normalize();
    if puddle < 0.5 && up < 0.9 {
        bsdf.coat_normal = bsdf.normal;
    }
}
