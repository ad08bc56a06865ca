//! What is seen where nothing is met: the sky through the air, the sun, the glow of lamps.

use super::shaded_pixel::ShadedSample;
use crate::accel::Ray;
use crate::camera_rays::is_nowhere;
use crate::light::{Environment, Sun};
use crate::shade::{Tracer, halos, halos8};
use crate::vec3x8::{Vec3x8, dot, side_by_side, splat};
use endless_world::PinholeCamera;
use glam::Vec3A;
use wide::f32x8;

/// Fog and rain fill the way to the sky as far as this, metres.
const FAR_M: f32 = 2000.0;
/// Cosine of the radius of the sun's disc.
const DISC: f32 = 0.999_975;
/// Cosine of the radius of the aureole that haze makes around it, and what is left to 1.
const AUREOLE: (f32, f32) = (0.97, 0.03);

/// A sample that met nothing, black where the lens shows nothing; `halos` is the glow of lamps along its ray.
pub(super) fn sky_sample(environment: &Environment, ray: &Ray, halos: Vec3A) -> ShadedSample {
    if is_nowhere(ray) {
        return ShadedSample::sky(Vec3A::ZERO);
    }
    let sky = environment.sky.radiance(ray.direction);
    // Fog and rain fill the whole way to the sky; thin haze is part of the sky model already.
    let air =
        if environment.fog.is_dense() { environment.fog.through(sky, ray.origin, ray.direction, FAR_M) } else { sky };
    ShadedSample::sky(air + sun_disc(environment, ray.direction) + halos)
}

/// The light that [`sky_sample`] finds along each of eight rays.
pub(super) fn sky_samples8(tracer: &Tracer<'_>, camera: &PinholeCamera, rays: &[&Ray; 8]) -> Vec3x8 {
    let environment = tracer.environment;
    if rays.iter().any(|ray| is_nowhere(ray)) {
        return side_by_side(rays.map(|ray| sky_sample(environment, ray, halos(tracer, ray, f32::MAX)).rest));
    }
    let directions = side_by_side(rays.map(|ray| ray.direction));
    let mut seen = environment.sky.radiance8(&directions);
    let fog = &environment.fog;
    if fog.is_dense() {
        let heights = f32x8::new(rays.map(|ray| ray.origin.z));
        let left = fog.transmittance8(heights, directions[2], f32x8::splat(FAR_M));
        let scattered = fog.in_scatter8(&directions, left);
        seen = std::array::from_fn(|k| seen[k] * left + scattered[k]);
    }
    if let Some(sun) = &environment.sun {
        let disc = sun_disc8(sun, &directions);
        seen = std::array::from_fn(|k| seen[k] + disc[k]);
    }
    if environment.halos() {
        let glow = match camera.lens.is_central() {
            true => halos8(tracer, rays[0].origin, &directions, f32x8::splat(f32::MAX)),
            false => rays.map(|ray| halos(tracer, ray, f32::MAX)),
        };
        let glow = side_by_side(glow);
        seen = std::array::from_fn(|k| seen[k] + glow[k]);
    }
    seen
}

/// The sun itself, where a ray meets its disc.
fn sun_disc(environment: &Environment, direction: Vec3A) -> Vec3A {
    let Some(sun) = &environment.sun else { return Vec3A::ZERO };
    let cosine = direction.dot(sun.direction);
    let disc = if cosine > DISC { sun.illuminance * 200.0 } else { Vec3A::ZERO };
    let around = ((cosine - AUREOLE.0) / AUREOLE.1).max(0.0);
    disc + sun.illuminance * (0.06 * around * around * around)
}

/// [`sun_disc`] in eight directions.
fn sun_disc8(sun: &Sun, directions: &Vec3x8) -> Vec3x8 {
    let cosine = dot(directions, &splat(sun.direction));
    let around = ((cosine - f32x8::splat(AUREOLE.0)) / f32x8::splat(AUREOLE.1)).fast_max(f32x8::ZERO);
    let around = f32x8::splat(0.06) * around * around * around;
    let is_disc = cosine.simd_gt(f32x8::splat(DISC));
    sun.illuminance.to_array().map(|axis| {
        let disc = is_disc.select(f32x8::splat(axis * 200.0), f32x8::ZERO);
        disc + f32x8::splat(axis) * around
    })
}
