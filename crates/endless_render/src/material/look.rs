//! The look of a surface point: parameters of the reflection model, and what it emits.

use super::{building, ground, thing, wet, window};
use crate::light::Environment;
use crate::scene::SurfacePoint;
use endless_scene::Surface;
use glam::Vec3A;

/// A diffuse and rough specular base under an optional smooth coat (lacquer, glass, water).
#[derive(Debug, Clone)]
pub(crate) struct Look {
    /// Diffuse albedo of the base, linear.
    pub(crate) albedo: Vec3A,
    /// Shading normal of the base.
    pub(crate) normal: Vec3A,
    /// GGX roughness (perceptual; α = roughness²) of the base.
    pub(crate) roughness: f32,
    /// Reflectance at normal incidence of the base's specular lobe.
    pub(crate) specular: f32,
    /// Share of the surface that the coat covers.
    pub(crate) coat: f32,
    /// The coat's reflectance at normal incidence; coloured for metals.
    pub(crate) coat_f0: Vec3A,
    /// The coat's normal.
    pub(crate) coat_normal: Vec3A,
    /// GGX roughness of the coat for highlights of small lights; its reflections are mirror-like.
    pub(crate) coat_roughness: f32,
    /// Share of light that passes through (leaves).
    pub(crate) translucency: f32,
    /// Emitted radiance, kcd/m².
    pub(crate) emission: Vec3A,
}

impl Look {
    /// A plain rough surface.
    pub(crate) fn matte(albedo: Vec3A, normal: Vec3A) -> Self {
        Self {
            albedo,
            normal,
            roughness: 0.85,
            specular: 0.03,
            coat: 0.0,
            coat_f0: Vec3A::splat(0.04),
            coat_normal: normal,
            coat_roughness: 0.1,
            translucency: 0.0,
            emission: Vec3A::ZERO,
        }
    }

    /// The same with a smooth coat.
    pub(crate) fn coated(mut self, share: f32, f0: f32, roughness: f32) -> Self {
        self.coat = share;
        self.coat_f0 = Vec3A::splat(f0);
        self.coat_roughness = roughness;
        self
    }
}

/// The look of a point. `footprint_m` is the width of the pixel on the surface; `jitter` is uniform in [0, 1) and
/// differs between the pixel's samples.
pub(crate) fn look(point: &SurfacePoint<'_>, environment: &Environment, footprint_m: f32, jitter: f32) -> Look {
    let base = Vec3A::from_array(point.material.base_color);
    let surface = point.material.surface;
    let mut look = match surface {
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
        Surface::LitSign => thing::lit_sign(point, base, environment),
        Surface::CarPaint => thing::car_paint(point, base, environment),
        Surface::CarGlass => thing::car_glass(point, base, environment),
        Surface::Rubber => Look { roughness: 0.75, specular: 0.035, ..Look::matte(base, point.normal) },
        Surface::Plastic => Look { roughness: 0.45, specular: 0.04, ..Look::matte(base, point.normal) },
        Surface::Metal => thing::metal(point, base, 0.35),
        Surface::Chrome => thing::metal(point, base, 0.85),
        Surface::Painted => Look::matte(base * thing::grime(point), point.normal).coated(0.5, 0.035, 0.35),
        Surface::Cloth | Surface::Hair => Look { roughness: 0.9, specular: 0.02, ..Look::matte(base, point.normal) },
        Surface::Skin => Look { roughness: 0.5, specular: 0.03, ..Look::matte(base, point.normal) },
        Surface::Leather => Look { roughness: 0.45, specular: 0.04, ..Look::matte(base, point.normal) },
        Surface::Bark => thing::bark(point, base, footprint_m),
        Surface::Foliage => thing::foliage(point, base),
        Surface::Water => Look::matte(base, point.normal).coated(1.0, 0.02, 0.05),
        Surface::Plate => Look::matte(base, point.normal).coated(0.4, 0.04, 0.3),
        Surface::VehicleLight(slot) => thing::vehicle_light(point, base, slot, environment),
        // What a lens shows changes with the signal: its light is added frame by frame.
        Surface::SignalLens(_) => Look::matte(base * 0.12, point.normal).coated(0.6, 0.04, 0.2),
        Surface::LampLens => thing::lamp_lens(point, base, environment),
    };
    if environment.wetness > 0.0 {
        wet::wet(&mut look, point, environment, footprint_m, jitter);
    }
    look.albedo = look.albedo.clamp(Vec3A::splat(0.004), Vec3A::splat(0.9));
    look
}
