//! Shading of the samples of the static picture, a ray at a time: the oracle of [`super::block_shading`], and what both share.

use super::gbuffer_sample::{Mirror, MirrorSample};
use super::lamp_mask::{lamp_sum, lamps_free};
use super::shaded_pixel::ShadedSample;
use super::sky_sample::sky_sample;
use crate::accel::{Hit, Ray};
use crate::light::Environment;
use crate::material::{Bsdf, evaluate_bsdf, evaluate_bsdfs};
use crate::sampling::SAMPLES;
use crate::scene::SurfaceInteraction;
use crate::shade::{MIRROR_THRESHOLD, Tracer, footprint_m, halos, mirror_light, mirror_ray, sun_light};
use glam::Vec3A;

/// What is known of a sample before it is shaded.
#[derive(Clone, Copy)]
pub(super) struct PrimarySample {
    pub(super) ray: Ray,
    /// What the ray met; `None`: the sky.
    pub(super) hit: Option<Hit>,
    /// Gathered there, klx.
    pub(super) irradiance: Vec3A,
}

/// The air before a surface.
#[derive(Debug, Clone, Copy)]
pub(super) struct Air {
    /// Share of the surface's light that it lets through.
    pub(super) transmittance: f32,
    /// What it scatters into the ray, kcd/m²: of sun and sky, and of lamps.
    pub(super) glow: Vec3A,
}

impl Air {
    /// As far as a surface; `halos` is the glow of lamps.
    pub(super) fn before(environment: &Environment, ray: &Ray, distance: f32, halos: Vec3A) -> Self {
        let transmittance = environment.fog.transmittance(ray.origin, ray.direction, distance);
        Self { transmittance, glow: environment.fog.in_scatter(ray.direction, transmittance) + halos }
    }
}

/// What reaches a still surface and what is before it.
#[derive(Debug, Clone, Copy)]
pub(super) struct SampleLight {
    pub(super) air: Air,
    /// By day the sun's light if nothing were in its way; at night that of all lamps, shadowed by the static scene.
    pub(super) direct: Vec3A,
    /// The lamps near it that light it past the static scene, a bit each.
    pub(super) lamps_free: u32,
    /// What the coat mirrors, and how far it sees.
    pub(super) mirror: (Vec3A, f32),
}

/// The BSDF of a still sample; the same wherever it is asked for.
pub(super) fn gbuffer_bsdf(
    point: &SurfaceInteraction<'_>,
    environment: &Environment,
    sample: usize,
    pixel_angle: f32,
) -> Bsdf {
    evaluate_bsdf(point, environment, footprint_m(&point.facet(), pixel_angle), sample_jitter(sample))
}

/// [`gbuffer_bsdf`] of eight samples of any pixels.
pub(super) fn gbuffer_bsdfs(
    points: &[Option<&SurfaceInteraction<'_>>; 8],
    environment: &Environment,
    samples: &[usize; 8],
    pixel_angle: f32,
) -> [Option<Bsdf>; 8] {
    let footprints_m = points.map(|point| point.map_or(1.0, |point| footprint_m(&point.facet(), pixel_angle)));
    evaluate_bsdfs(points, environment, &footprints_m, &samples.map(sample_jitter))
}

/// Differs between the samples of a pixel.
fn sample_jitter(sample: usize) -> f32 {
    sample as f32 / 4.0 + 0.1
}

/// Shades the samples of a pixel, a ray at a time; `tracer` must hold nothing that moves. Of a uniform pixel the centre is
/// shaded, and where it mirrors the third sample, too; they share the air before the centre and the lamp light there.
pub(super) fn shade_pixel(
    tracer: &Tracer<'_>,
    samples: &[PrimarySample; SAMPLES],
    uniform: bool,
    pixel_angle: f32,
) -> [ShadedSample; SAMPLES] {
    let environment = tracer.environment;
    let mut centre: Option<SampleLight> = None;
    let mut seen = None;
    let mut shaded = [ShadedSample::sky(Vec3A::ZERO); SAMPLES];
    for (sample, primary) in samples.iter().enumerate() {
        let PrimarySample { ray, hit: Some(hit), .. } = primary else {
            shaded[sample] = sky_sample(environment, &primary.ray, halos(tracer, &primary.ray, f32::MAX));
            continue;
        };
        if uniform && !is_shaded(sample, seen.as_ref().map(|(point, bsdf)| (point, bsdf))) {
            continue;
        }
        let point = SurfaceInteraction::new(&tracer.still.instances, ray, hit);
        let bsdf = gbuffer_bsdf(&point, environment, sample, pixel_angle);
        let shared = centre.filter(|_| uniform);
        let air = shared.map_or_else(|| Air::before(environment, ray, hit.t, halos(tracer, ray, hit.t)), |c| c.air);
        let mirror = mirror_light(tracer, &point, &bsdf, pixel_angle);
        let mut light = SampleLight { air, direct: Vec3A::ZERO, lamps_free: 0, mirror };
        if !environment.night {
            light.direct = sun_light(environment, &point, &bsdf);
        } else if let Some(shared) = shared {
            light.direct = shared.direct;
        } else {
            light.lamps_free = lamps_free(tracer, &point.facet());
            light.direct = lamp_sum(tracer, &point.facet(), &bsdf, light.lamps_free);
        }
        centre = centre.or(Some(light));
        shaded[sample] = surface_sample(primary.irradiance, &point, &bsdf, &light);
        seen = seen.or(Some((point, bsdf)));
    }
    shaded
}

/// Whether a sample of a uniform pixel is shaded, of which the centre is known: it is itself, and so is the third sample
/// where the centre mirrors, for a mirror's image has detail that no material has.
pub(super) fn is_shaded(sample: usize, centre: Option<(&SurfaceInteraction<'_>, &Bsdf)>) -> bool {
    let mirrors = |(point, bsdf): (&SurfaceInteraction<'_>, &Bsdf)| {
        bsdf.coat_reflectance(-point.direction).max_element() >= MIRROR_THRESHOLD
    };
    sample == 0 || sample == 2 && centre.is_some_and(mirrors)
}

/// A sample that met a surface, on which `irradiance` was gathered, klx.
pub(super) fn surface_sample(
    irradiance: Vec3A,
    point: &SurfaceInteraction<'_>,
    bsdf: &Bsdf,
    light: &SampleLight,
) -> ShadedSample {
    let view = -point.direction;
    let Air { transmittance, glow } = light.air;
    let reflectance = bsdf.coat_reflectance(view);
    let mirror = (reflectance.max_element() >= MIRROR_THRESHOLD).then(|| {
        let (mirrored, reach) = light.mirror;
        MirrorSample::new(&Mirror {
            light: mirrored * transmittance,
            weight: reflectance * transmittance,
            direction: mirror_ray(point, bsdf).direction,
            reach,
            roughness: bsdf.coat_roughness,
        })
    });
    ShadedSample {
        rest: bsdf.emission * transmittance + glow,
        ambient: bsdf.lit_by_ambient(irradiance, view) * transmittance,
        direct: light.direct * transmittance,
        mirror,
        lamps_free: light.lamps_free,
        is_lens: point.is_signal_lens(),
    }
}
