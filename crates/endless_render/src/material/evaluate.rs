//! From materials to BSDFs: what a surface is made of gets its procedural detail, and water where it rains.

use super::{Bsdf, building, ground, object, wet, window};
use crate::light::Environment;
use crate::scene::SurfaceInteraction;
use endless_scene::Surface;
use glam::Vec3A;

/// The BSDF of a point. `footprint_m` is the width of the pixel on the surface; `jitter` is uniform in [0, 1) and
/// differs between the pixel's samples.
pub(crate) fn evaluate_bsdf(
    point: &SurfaceInteraction<'_>,
    environment: &Environment,
    footprint_m: f32,
    jitter: f32,
) -> Bsdf {
    let Some(variation) = &environment.surfaces else {
        return finished(dry_bsdf(point, environment, footprint_m), point, environment, footprint_m, jitter);
    };
    let varied = variation.of(point);
    let mut bsdf = dry_bsdf(&varied.point(point), environment, footprint_m * varied.scale());
    bsdf.albedo = varied.albedo(point, bsdf.albedo, footprint_m);
    finished(bsdf, point, environment, footprint_m, jitter)
}

/// With water where it rains, and what no surface exceeds.
fn finished(
    mut bsdf: Bsdf,
    point: &SurfaceInteraction<'_>,
    environment: &Environment,
    footprint_m: f32,
    jitter: f32,
) -> Bsdf {
    if environment.wetness > 0.0 {
        wet::wet(&mut bsdf, point, environment, footprint_m, jitter);
    }
    bsdf.albedo = bsdf.albedo.clamp(Vec3A::splat(0.004), Vec3A::splat(0.9));
    bsdf
}

/// Of the surface and its detail.
fn dry_bsdf(point: &SurfaceInteraction<'_>, environment: &Environment, footprint_m: f32) -> Bsdf {
    let base = Vec3A::from_array(point.material.base_color);
    let surface = point.material.surface;
    match surface {
        Surface::Asphalt => ground::asphalt(point, base, footprint_m),
        Surface::RoadPaint => ground::road_paint(point, base, footprint_m),
        Surface::Paving => ground::paving(point, base, footprint_m),
        Surface::Cobbles => ground::cobbles(point, base, footprint_m),
        Surface::Kerb => ground::kerb(point, base, footprint_m),
        Surface::Concrete => ground::concrete(point, base, footprint_m),
        Surface::Grass => ground::grass(point, base, footprint_m),
        Surface::Soil | Surface::Gravel => ground::loose(point, base, footprint_m),
        Surface::Brick => building::brick(point, base, footprint_m),
        Surface::Plaster => building::plaster(point, base, footprint_m),
        Surface::Stone => building::stone(point, base, footprint_m),
        Surface::Cladding => building::cladding(point, base, footprint_m),
        Surface::RoofTile => building::roof_tile(point, base, footprint_m),
        Surface::FlatRoof => building::flat_roof(point, base, footprint_m),
        Surface::Wood => building::wood(point, base, footprint_m),
        Surface::WindowGlass => window::window(point, base, environment, false),
        Surface::ShopGlass => window::window(point, base, environment, true),
        Surface::LitSign => object::lit_sign(point, base, environment),
        Surface::CarPaint => object::car_paint(point, base, environment),
        Surface::CarGlass => object::car_glass(point, base, environment),
        Surface::Rubber => Bsdf { roughness: 0.75, specular: 0.035, ..Bsdf::matte(base, point.normal) },
        Surface::Plastic => Bsdf { roughness: 0.45, specular: 0.04, ..Bsdf::matte(base, point.normal) },
        Surface::Metal => object::metal(point, base, 0.35),
        Surface::Chrome => object::metal(point, base, 0.85),
        Surface::Painted => Bsdf::matte(base * object::grime(point), point.normal).coated(0.5, 0.035, 0.35),
        Surface::Cloth | Surface::Hair => Bsdf { roughness: 0.9, specular: 0.02, ..Bsdf::matte(base, point.normal) },
        Surface::Skin => Bsdf { roughness: 0.5, specular: 0.03, ..Bsdf::matte(base, point.normal) },
        Surface::Leather => Bsdf { roughness: 0.45, specular: 0.04, ..Bsdf::matte(base, point.normal) },
        Surface::Bark => object::bark(point, base, footprint_m),
        Surface::Foliage => object::foliage(point, base),
        Surface::Water => Bsdf::matte(base, point.normal).coated(1.0, 0.02, 0.05),
        Surface::Plate => Bsdf::matte(base, point.normal).coated(0.4, 0.04, 0.3),
        Surface::VehicleLight(slot) => object::vehicle_light(point, base, slot, environment),
        // What a lens shows changes with the signal: its light is added frame by frame.
        Surface::SignalLens(_) => Bsdf::matte(base * 0.12, point.normal).coated(0.6, 0.04, 0.2),
        Surface::LampLens => object::lamp_lens(point, base, environment),
    }
}
