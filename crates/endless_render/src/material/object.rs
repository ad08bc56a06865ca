//! Vehicles, plants, poles, lights.

use super::{Bsdf, cabin, noise};
use crate::light::{Environment, lamp_power};
use crate::scene::SurfaceInteraction;
use endless_scene::LightSlot;
use endless_world::VehicleLights;
use endless_world::math::UnfusedVec3A;
use endless_world::math::smoothstep;
use glam::{Vec2, Vec3, Vec3A};

/// Lights that look as bright at night as by day would blind the exposure: cameras clip both.
const NIGHT_GLARE: f32 = 0.03;

pub(super) fn car_paint(point: &SurfaceInteraction<'_>, base: Vec3A, environment: &Environment) -> Bsdf {
    let p = Vec3::from(point.object_position);
    // Dust and road dirt, most at the sills.
    let low = 1.0 - smoothstep(0.25, 0.85, p.z);
    let dirt = (0.06 + 0.35 * low) * (0.6 + 0.4 * noise::value3(p * 3.1, 3)).max(0.0);
    let dirt = dirt * (1.0 - 0.5 * environment.rain);
    let color = (base * point.instance.tint).lerp_unfused(Vec3A::new(0.20, 0.17, 0.14), dirt);
    let mut bsdf = Bsdf::matte(color, point.normal).coated(1.0 - 0.6 * dirt, 0.045, 0.14);
    bsdf.roughness = 0.35;
    bsdf.specular = 0.05;
    bsdf
}

pub(super) fn car_glass(point: &SurfaceInteraction<'_>, base: Vec3A, environment: &Environment) -> Bsdf {
    /// What a pane lets through both ways: windscreens must pass 70 %, rear panes are often tinted.
    const THROUGH: f32 = 0.7;
    /// Of a cabin's lamps, the outdoors at night being as dark as it is.
    const LAMP: Vec3A = Vec3A::new(0.105, 0.10, 0.088);
    let inside = cabin::behind(point, THROUGH);
    let behind = inside.as_ref().map_or((base * 0.35).min(Vec3A::splat(0.05)), |inside| inside.albedo);
    let mut bsdf = Bsdf::matte(behind, point.normal).coated(1.0, 0.05, 0.07);
    bsdf.specular = 0.0;
    if environment.night && point.instance.lights.contains(VehicleLights::INTERIOR) {
        bsdf.emission = inside.map_or(Vec3A::ZERO, |inside| inside.lit * LAMP);
    }
    bsdf
}

pub(super) fn metal(point: &SurfaceInteraction<'_>, base: Vec3A, mirror: f32) -> Bsdf {
    let mut bsdf = Bsdf::matte(base * (1.0 - 0.75 * mirror), point.normal).coated(mirror, 0.6, 0.25);
    bsdf.coat_f0 = base.max(Vec3A::splat(0.3)) * 0.85;
    bsdf.roughness = 0.45;
    bsdf
}

/// Unevenness of painted street furniture.
pub(super) fn grime(point: &SurfaceInteraction<'_>) -> f32 {
    1.0 + 0.12 * noise::value3(Vec3::from(point.position) * 2.3, 5)
        - 0.15 * (1.0 - smoothstep(0.0, 0.5, point.object_position.z))
}

pub(super) fn bark(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let p = point.object_position;
    let ridges = noise::filtered_fbm2(Vec2::new(p.x * 3.0 + p.y * 3.0, p.z * 0.5), 0.25, 4, footprint);
    Bsdf::matte(base * (1.0 + 0.6 * ridges), point.normal)
}

pub(super) fn foliage(point: &SurfaceInteraction<'_>, base: Vec3A) -> Bsdf {
    let p = Vec3::from(point.position);
    let vary = 0.92 + 0.25 * noise::value3(p * 1.7, 8) + 0.15 * noise::value3(p * 0.23, 9);
    let green = individual(point, super::ground::muted(base, 0.25));
    let mut bsdf = Bsdf::matte(green * vary, point.normal);
    bsdf.translucency = 0.35;
    bsdf.roughness = 0.55;
    bsdf.specular = 0.03;
    bsdf
}

/// The green of one tree among others of its kind: darker or paler, yellower or bluer, and of leafy trees a few whose
/// leaves turn, bough by bough. Hedges and fields are made of pieces that must not be told apart: they keep theirs.
fn individual(point: &SurfaceInteraction<'_>, green: Vec3A) -> Vec3A {
    const TREE_M: f32 = 4.0;
    /// Share of leafy trees that turn.
    const TURNING: f32 = 0.06;
    /// Conifers and evergreens have more blue than this, of their green.
    const LEAFY: f32 = 0.262;
    const AUTUMN: [Vec3A; 3] = [Vec3A::new(2.5, 1.75, 0.22), Vec3A::new(2.5, 1.05, 0.16), Vec3A::new(1.9, 1.45, 0.30)];
    let base = Vec3A::from_array(point.material.base_color);
    if base.x > base.y || base.z > base.y || point.instance.geometry.posed.blas.bounds().1.z < TREE_M {
        return green;
    }
    let stand = point.instance.world_from_object.translation;
    let dice = |salt| noise::cell2((stand * 4.0).round().as_ivec3().truncate(), salt);
    let warmth = 0.45 * (dice(31) - 0.35);
    let tint = Vec3A::new(1.0 + warmth, 1.0 + 0.2 * warmth, 1.0 - warmth) * (0.84 + 0.32 * dice(32));
    if base.z > LEAFY * base.y || dice(33) > TURNING {
        return green * tint;
    }
    let own = noise::value3(Vec3::from(point.position) * 0.8, 34);
    let turned = smoothstep(-0.5, 0.6, own + 1.2 * dice(35) - 0.3);
    (green * tint).lerp_unfused(AUTUMN[(3.0 * dice(36)) as usize % 3] * green.y, turned)
}

pub(super) fn lit_sign(point: &SurfaceInteraction<'_>, base: Vec3A, environment: &Environment) -> Bsdf {
    let mut bsdf = Bsdf::matte(base, point.normal).coated(0.5, 0.04, 0.2);
    if environment.night {
        bsdf.emission = base * (0.05 * lamp_power(point.position, environment.lamps_lit));
    }
    bsdf
}

pub(super) fn lamp_lens(point: &SurfaceInteraction<'_>, base: Vec3A, environment: &Environment) -> Bsdf {
    let mut bsdf = Bsdf::matte(base, point.normal).coated(0.6, 0.04, 0.2);
    if environment.night {
        let power = 0.9 * lamp_power(point.position, environment.lamps_lit);
        bsdf.emission = Vec3A::new(1.0, 0.86, 0.66) * power * point.instance.tint;
    }
    bsdf
}

pub(super) fn vehicle_light(
    point: &SurfaceInteraction<'_>,
    base: Vec3A,
    slot: LightSlot,
    environment: &Environment,
) -> Bsdf {
    let mut bsdf = Bsdf::matte(base, point.normal).coated(1.0, 0.05, 0.08);
    let on = |lights| point.instance.lights.intersects(lights);
    let glare = if environment.night { NIGHT_GLARE } else { 1.0 };
    let red = Vec3A::new(1.0, 0.035, 0.02);
    let amber = Vec3A::new(1.0, 0.42, 0.03);
    let beacon = base * (24.0 / base.max_element().max(1e-3));
    bsdf.emission = glare
        * match slot {
            LightSlot::Head if on(VehicleLights::LOW_BEAM | VehicleLights::HIGH_BEAM) => {
                Vec3A::new(1.0, 0.95, 0.86) * 45.0
            }
            LightSlot::Tail if on(VehicleLights::BRAKE) => red * 16.0,
            LightSlot::Tail if on(VehicleLights::POSITION) => red * 5.0,
            LightSlot::Brake if on(VehicleLights::BRAKE) => red * 18.0,
            LightSlot::IndicatorLeft if on(VehicleLights::LEFT_BLINKER) => amber * 16.0,
            LightSlot::IndicatorRight if on(VehicleLights::RIGHT_BLINKER) => amber * 16.0,
            LightSlot::Reverse if on(VehicleLights::REVERSE) => Vec3A::splat(12.0),
            LightSlot::BeaconLeft if on(VehicleLights::SPECIAL1) => beacon,
            LightSlot::BeaconRight if on(VehicleLights::SPECIAL2) => beacon,
            _ => Vec3A::ZERO,
        };
    bsdf
}
