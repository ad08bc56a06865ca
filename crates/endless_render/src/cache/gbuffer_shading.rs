//! Shading of the samples of the static picture.

use super::gbuffer_sample::{GBufferSample, pack_weight};
use super::lamp_mask::{lamp_sum, lamps_free};
use crate::accel::{Hit, Ray};
use crate::light::Environment;
use crate::material::{Bsdf, evaluate_bsdf};
use crate::octahedron;
use crate::scene::SurfaceInteraction;
use crate::shade::{MIRROR_THRESHOLD, Tracer, footprint_m, halos, mirror_light, mirror_ray};
use endless_scene::Surface;
use glam::Vec3A;

/// What is known of a sample before it is shaded.
pub(super) struct PrimarySample {
    pub(super) ray: Ray,
    /// What the ray met; `None`: the sky.
    pub(super) hit: Option<Hit>,
    /// Which directions to the sun's disc what stands still leaves free, a bit each.
    pub(super) sun_free: u8,
    /// Gathered there, klx.
    pub(super) irradiance: Vec3A,
    /// Number of the sample in its pixel.
    pub(super) sample: usize,
    /// Whether lamps are asked for their light at night.
    pub(super) asks_lamps: bool,
}

/// The BSDF of a still sample; the same wherever it is asked for.
pub(super) fn gbuffer_bsdf(
    point: &SurfaceInteraction<'_>,
    environment: &Environment,
    sample: usize,
    pixel_angle: f32,
) -> Bsdf {
    evaluate_bsdf(point, environment, footprint_m(point, pixel_angle), sample as f32 / 4.0 + 0.1)
}

/// Whether a point lies on a lens of a traffic light.
pub(super) fn shows_signal(point: &SurfaceInteraction<'_>) -> bool {
    matches!(point.material.surface, Surface::SignalLens(_)) && point.instance.signal.is_some()
}

/// Shades a sample, surface or sky; `tracer` must hold nothing that moves.
pub(super) fn shade_sample(tracer: &Tracer<'_>, primary: &PrimarySample, pixel_angle: f32) -> GBufferSample {
    match &primary.hit {
        Some(hit) => shade_surface(tracer, primary, hit, pixel_angle),
        None => shade_sky(tracer, &primary.ray),
    }
}

fn shade_surface(tracer: &Tracer<'_>, primary: &PrimarySample, hit: &Hit, pixel_angle: f32) -> GBufferSample {
    let PrimarySample { ray, sun_free, irradiance, sample, asks_lamps, .. } = *primary;
    let environment = tracer.environment;
    let point = SurfaceInteraction::new(&tracer.still.instances, &ray, hit);
    let bsdf = gbuffer_bsdf(&point, environment, sample, pixel_angle);
    let view = -ray.direction;
    let transmittance = environment.fog.transmittance(ray.origin, ray.direction, hit.t);
    let (mirror, mirror_t) = mirror_light(tracer, &point, &bsdf, pixel_angle);
    let mirrors = bsdf.coat_reflectance(view).max_element() >= MIRROR_THRESHOLD;
    let lens = shows_signal(&point);
    let facet = point.facet();
    let lamps_free = if environment.night && asks_lamps { lamps_free(tracer, &facet) } else { 0 };
    let direct = if environment.night {
        lamp_sum(tracer, &facet, &bsdf, lamps_free)
    } else {
        environment.sun.as_ref().map_or(Vec3A::ZERO, |sun| bsdf.lit_by(sun.illuminance, sun.direction, view))
    };
    let rest = bsdf.emission * transmittance
        + environment.fog.in_scatter(ray.direction, transmittance)
        + halos(tracer, &ray, hit.t);
    GBufferSample {
        hit: *hit,
        rest: rest.to_array(),
        ambient: (bsdf.lit_by_ambient(irradiance, view) * transmittance).to_array(),
        direct: (direct * transmittance).to_array(),
        mirror: (mirror * transmittance).to_array(),
        mirror_direction: mirror_ray(&point, &bsdf).direction.to_array(),
        mirror_t,
        mirror_weight: pack_weight(bsdf.coat_reflectance(view) * transmittance, bsdf.coat_roughness),
        normal: octahedron::pack(point.geometric_normal),
        sun_free,
        lamps_free,
        flags: u8::from(mirrors) * GBufferSample::MIRRORS + u8::from(lens) * GBufferSample::LENS,
    }
}

fn shade_sky(tracer: &Tracer<'_>, ray: &Ray) -> GBufferSample {
    let environment = tracer.environment;
    let sky = environment.sky.radiance(ray.direction);
    // Fog and rain fill the whole way to the sky; thin haze is part of the sky model already.
    let air =
        if environment.fog.is_dense() { environment.fog.through(sky, ray.origin, ray.direction, 2000.0) } else { sky };
    GBufferSample::sky(air + sun_disc(environment, ray.direction) + halos(tracer, ray, f32::MAX))
}

/// The sun itself, where a ray meets its disc.
fn sun_disc(environment: &Environment, direction: Vec3A) -> Vec3A {
    let Some(sun) = &environment.sun else { return Vec3A::ZERO };
    let cosine = direction.dot(sun.direction);
    // Disc, and an aureole that haze makes around it.
    let disc = if cosine > 0.999_975 { sun.illuminance * 200.0 } else { Vec3A::ZERO };
    let around = ((cosine - 0.97) / 0.03).max(0.0);
    disc + sun.illuminance * (0.06 * around * around * around)
}
