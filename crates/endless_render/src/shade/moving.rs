//! Shading of moving objects: no random numbers, so no grain. Direct light by shadow rays to the lights that matter,
//! indirect light from the probes, one mirror ray for paint and glass.

use super::Tracer;
use super::headlight::{beam_light, beam_light8};
use super::lamplight::{lamp_light, lamp_light8};
use super::secondary::{MIRROR_THRESHOLD, mirror_footprint, mirror_ray, shade_hit, shade_hit8};
use crate::accel::{Ray, RayStream};
use crate::material::{Bsdf, evaluate_bsdf};
use crate::sampling::SAMPLES;
use crate::scene::{ShadingPoint, SurfaceInteraction};
use endless_world::math;
use glam::Vec3A;
use std::f32::consts::FRAC_1_PI;

/// Lamps whose shadows a moving point tests.
const LAMPS: usize = 3;

/// A point of a moving surface and the pixel's sample that saw it.
pub(crate) struct MovingSample<'a> {
    pub(crate) point: SurfaceInteraction<'a>,
    pub(crate) sample: usize,
    /// Samples of the pixel whose light it tells, itself included.
    pub(crate) stands_for: u8,
}

/// Radiance of a moving surface towards the camera, fog included.
pub(crate) fn shade_moving(tracer: &Tracer<'_>, seen: &MovingSample<'_>, pixel_angle: f32) -> Vec3A {
    let pending = PendingLight::new(tracer, seen, pixel_angle);
    let sunlit = pending.sun.is_some_and(|ray| !tracer.occluded(&ray));
    let image = pending.mirror.as_ref().filter(|mirror| mirror.is_sharp()).map(|mirror| {
        let struck = tracer.closest(&mirror.ray);
        shade_hit(tracer, &mirror.ray, struck.as_ref(), mirror.footprint_m)
    });
    let (point, bsdf) = (&seen.point, &pending.bsdf);
    let night = if tracer.environment.night {
        let beams = tracer.moving.map_or(Vec3A::ZERO, |moving| beam_light(tracer, moving, point, bsdf));
        lamp_light(tracer, point, bsdf, LAMPS) + beams
    } else {
        Vec3A::ZERO
    };
    pending.radiance(tracer, point, sunlit, image, night)
}

/// The same for many points: their rays run side by side.
pub(crate) fn shade_moving_together(tracer: &Tracer<'_>, seen: &[&MovingSample<'_>], pixel_angle: f32) -> Vec<Vec3A> {
    let pending: Vec<PendingLight> = seen.iter().map(|seen| PendingLight::new(tracer, seen, pixel_angle)).collect();
    let mut sunlit = vec![false; seen.len()];
    let to_sun: Vec<(usize, Ray)> = pending.iter().enumerate().filter_map(|(i, a)| Some((i, a.sun?))).collect();
    for bundle in to_sun.chunks(32) {
        let (rays, active) = side_by_side(bundle.iter().map(|(_, ray)| ray));
        let hidden = tracer.occluded32(&rays, active);
        for (lane, (i, _)) in bundle.iter().enumerate() {
            sunlit[*i] = hidden >> lane & 1 == 0;
        }
    }
    let mut images = vec![None; seen.len()];
    let mirror =
        |(i, pending): (usize, &'_ PendingLight)| pending.mirror.filter(MirrorRay::is_sharp).map(|mirror| (i, mirror));
    let mirrors: Vec<(usize, MirrorRay)> = pending.iter().enumerate().filter_map(mirror).collect();
    for bundle in mirrors.chunks(32) {
        let (rays, active) = side_by_side(bundle.iter().map(|(_, mirror)| &mirror.ray));
        let struck = tracer.closest32(&rays, active);
        for (row, eight) in bundle.chunks(8).enumerate() {
            let footprints_m = std::array::from_fn(|lane| eight.get(lane).map_or(0.0, |(_, m)| m.footprint_m));
            let active = (active >> (8 * row)) as u8;
            let rays = std::array::from_fn(|lane| rays.ray(8 * row + lane));
            let shown = shade_hit8(tracer, &rays, &struck[row], active, &footprints_m);
            for ((i, _), light) in eight.iter().zip(shown) {
                images[*i] = Some(light);
            }
        }
    }
    let mut night = vec![Vec3A::ZERO; seen.len()];
    if tracer.environment.night {
        for ((seen, pending), night) in seen.chunks(8).zip(pending.chunks(8)).zip(night.chunks_mut(8)) {
            let points = std::array::from_fn(|i| Some((&seen.get(i)?.point, &pending[i].bsdf)));
            let beams = tracer.moving.map_or([Vec3A::ZERO; 8], |moving| beam_light8(tracer, moving, &points));
            let lamps = lamp_light8(tracer, &points, LAMPS);
            for (i, night) in night.iter_mut().enumerate() {
                *night = lamps[i] + beams[i];
            }
        }
    }
    let radiance = |i: usize| pending[i].radiance(tracer, &seen[i].point, sunlit[i], images[i], night[i]);
    (0..seen.len()).map(radiance).collect()
}

/// At most 32 rays as packets take them.
fn side_by_side<'r>(given: impl ExactSizeIterator<Item = &'r Ray>) -> (RayStream<4>, u32) {
    let active = ((1u64 << given.len()) - 1) as u32;
    let mut rays = RayStream::NONE;
    for (lane, ray) in given.enumerate() {
        rays.set(lane, ray);
    }
    (rays, active)
}

/// What must be known of a moving point's surroundings.
struct PendingLight {
    bsdf: Bsdf,
    /// Towards the sun, if it can light the point.
    sun: Option<Ray>,
    mirror: Option<MirrorRay>,
}

/// A coat's mirror image.
#[derive(Clone, Copy)]
struct MirrorRay {
    ray: Ray,
    /// Share of the mirrored light that the coat gives.
    weight: Vec3A,
    /// Share of the image that is what the ray meets; the rest is the probes' soft light.
    sharp: f32,
    footprint_m: f32,
}

impl PendingLight {
    fn new(tracer: &Tracer<'_>, seen: &MovingSample<'_>, pixel_angle: f32) -> Self {
        let MovingSample { point, sample, .. } = seen;
        let environment = tracer.environment;
        let bsdf = evaluate_bsdf(point, environment, footprint_m(&point.facet(), pixel_angle), *sample as f32 / 4.0);
        let sun = environment.sun.as_ref().and_then(|sun| sun.ray_from(point));
        let mirror = MirrorRay::new(point, &bsdf, f32::from(seen.stands_for) / SAMPLES as f32, pixel_angle);
        Self { bsdf, sun, mirror }
    }

    /// `night` is the light of lamps.
    fn radiance(
        &self,
        tracer: &Tracer<'_>,
        point: &SurfaceInteraction<'_>,
        sunlit: bool,
        image: Option<Vec3A>,
        night: Vec3A,
    ) -> Vec3A {
        let environment = tracer.environment;
        let (bsdf, view) = (&self.bsdf, -point.direction);
        let ambient =
            tracer.ambient(point.position + point.geometric_normal * 0.3, bsdf.normal) * point.ambient_occlusion;
        let mut radiance = bsdf.emission + bsdf.lit_by_ambient(ambient, view);
        if let Some(sun) = environment.sun.as_ref().filter(|_| sunlit) {
            radiance += bsdf.lit_by(sun.illuminance, sun.direction, view);
        }
        if let Some(mirror) = &self.mirror {
            radiance += mirror.light(tracer, point, image);
        }
        radiance += night;
        environment.fog.through(radiance, point.seen_from(), point.direction, point.distance)
    }
}

impl MirrorRay {
    /// On bright paint, and in a small `share` of a pixel, a weak mirror is hardly seen: there it shows soft light alone.
    fn new(point: &SurfaceInteraction<'_>, bsdf: &Bsdf, share: f32, pixel_angle: f32) -> Option<Self> {
        let weight = bsdf.coat_reflectance(-point.direction);
        let sharp = sharp_share(share, weight, bsdf);
        let ray = mirror_ray(point, bsdf);
        let footprint_m = mirror_footprint(point.distance, bsdf.coat_roughness, pixel_angle);
        (weight.max_element() >= MIRROR_THRESHOLD).then_some(Self { ray, weight, sharp, footprint_m })
    }

    /// Whether its ray must be traced.
    fn is_sharp(&self) -> bool {
        self.sharp > 0.0
    }

    /// Its light, given the radiance along its ray if that was pending.
    fn light(&self, tracer: &Tracer<'_>, point: &SurfaceInteraction<'_>, image: Option<Vec3A>) -> Vec3A {
        let mut shown = image.unwrap_or(Vec3A::ZERO) * self.sharp;
        if self.sharp < 1.0 {
            shown += soft_image(tracer, point, self.ray.direction) * (1.0 - self.sharp);
        }
        self.weight * shown
    }
}

/// How much of a mirror's image is what its ray meets, 0 to 1; the rest is soft light. `share` is that of a pixel which it
/// fills, `weight` that of light which the coat reflects.
pub(crate) fn sharp_share(share: f32, weight: Vec3A, bsdf: &Bsdf) -> f32 {
    let contrast = share * weight.max_element() / (bsdf.albedo.max_element() + 0.05);
    math::smoothstep(0.12, 0.20, contrast)
}

/// What a mirror shows as far as it is soft, kcd/m².
pub(crate) fn soft_mirror(tracer: &Tracer<'_>, point: &SurfaceInteraction<'_>, bsdf: &Bsdf) -> Vec3A {
    soft_image(tracer, point, bsdf.mirror_direction(point.direction, point.geometric_normal))
}

fn soft_image(tracer: &Tracer<'_>, point: &SurfaceInteraction<'_>, direction: Vec3A) -> Vec3A {
    tracer.ambient(point.position, direction) * (FRAC_1_PI * point.ambient_occlusion)
}

/// Width of a pixel on a surface.
pub(crate) fn footprint_m(point: &ShadingPoint, pixel_angle: f32) -> f32 {
    point.distance * pixel_angle / point.geometric_normal.dot(point.direction).abs().max(0.08)
}
