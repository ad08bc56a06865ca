//! Shading of moving objects: no random numbers, so no grain. Direct light by shadow rays to the lights that matter,
//! indirect light from the probes, one mirror ray for paint and glass.

use super::Tracer;
use super::headlight::{beam_light, beam_light8};
use super::lamplight::{lamp_light, lamp_light8};
use super::secondary::{MIRROR_THRESHOLD, mirror_footprint, mirror_ray, shade_secondary8, shade_struck};
use crate::accel::Ray;
use crate::material::{Look, look};
use crate::scene::SurfacePoint;
use endless_world::math;
use glam::Vec3A;
use std::f32::consts::FRAC_1_PI;

/// Lamps whose shadows a moving point tests.
const LAMPS: usize = 3;

/// A point of a moving surface and the pixel's sample that saw it.
pub(crate) struct Seen<'a> {
    pub(crate) point: SurfacePoint<'a>,
    pub(crate) sample: usize,
    /// Samples of the pixel whose light it tells, itself included.
    pub(crate) stands_for: u8,
}

/// Radiance of a moving surface towards the camera, fog included.
pub(crate) fn shade_moving(tracer: &Tracer<'_>, seen: &Seen<'_>, pixel_angle: f32) -> Vec3A {
    let asked = Asked::new(tracer, seen, pixel_angle);
    let sunlit = asked.sun.is_some_and(|ray| !tracer.occluded(&ray));
    let image = asked.mirror.as_ref().filter(|mirror| mirror.is_asked()).map(|mirror| {
        let struck = tracer.closest(&mirror.ray);
        shade_struck(tracer, &mirror.ray, struck.as_ref(), mirror.footprint_m)
    });
    let (point, look) = (&seen.point, &asked.look);
    let night = if tracer.environment.night {
        let beams = tracer.moving.map_or(Vec3A::ZERO, |moving| beam_light(tracer, moving, point, look));
        lamp_light(tracer, point, look, LAMPS) + beams
    } else {
        Vec3A::ZERO
    };
    asked.radiance(tracer, point, sunlit, image, night)
}

/// The same for up to eight points: their rays run side by side.
pub(crate) fn shade_moving8(tracer: &Tracer<'_>, seen: &[Seen<'_>], pixel_angle: f32, found: &mut [Vec3A]) {
    debug_assert!(seen.len() <= 8 && found.len() == seen.len());
    let asked: [Option<Asked>; 8] = std::array::from_fn(|i| Some(Asked::new(tracer, seen.get(i)?, pixel_angle)));
    let rays = |of: fn(&Asked) -> Option<Ray>| {
        let mut active = 0u8;
        let rays: [Ray; 8] = std::array::from_fn(|i| {
            let ray = asked[i].as_ref().and_then(of);
            active |= u8::from(ray.is_some()) << i;
            ray.unwrap_or(Ray { origin: Vec3A::ZERO, direction: Vec3A::Z, tmax: 0.0 })
        });
        (rays, active)
    };
    let (to_sun, active) = rays(|asked| asked.sun);
    let sunlit = active & !tracer.occluded8(&to_sun, active);
    let mirror = |asked: &Asked| asked.mirror.as_ref().filter(|mirror| mirror.is_asked()).map(|mirror| mirror.ray);
    let (into_mirror, active) = rays(mirror);
    let footprints_m = std::array::from_fn(|i| {
        let mirror = asked[i].as_ref().and_then(|asked| asked.mirror.as_ref());
        mirror.map_or(0.0, |mirror| mirror.footprint_m)
    });
    let images = shade_secondary8(tracer, &into_mirror, active, &footprints_m);
    let mut night = [Vec3A::ZERO; 8];
    if tracer.environment.night {
        let points = std::array::from_fn(|i| Some((&seen.get(i)?.point, &asked[i].as_ref()?.look)));
        let beams = tracer.moving.map_or([Vec3A::ZERO; 8], |moving| beam_light8(tracer, moving, &points));
        let lamps = lamp_light8(tracer, &points, LAMPS);
        night = std::array::from_fn(|i| lamps[i] + beams[i]);
    }
    for (i, (seen, found)) in seen.iter().zip(found).enumerate() {
        if let Some(asked) = &asked[i] {
            let image = (active >> i & 1 == 1).then_some(images[i]);
            *found = asked.radiance(tracer, &seen.point, sunlit >> i & 1 == 1, image, night[i]);
        }
    }
}

/// What must be known of a moving point's surroundings.
struct Asked {
    look: Look,
    /// Towards the sun, if it can light the point.
    sun: Option<Ray>,
    mirror: Option<Mirror>,
}

/// A coat's mirror image.
struct Mirror {
    ray: Ray,
    /// Share of the mirrored light that the coat gives.
    weight: Vec3A,
    /// Share of the image that is what the ray meets; the rest is the probes' soft light.
    sharp: f32,
    footprint_m: f32,
}

impl Asked {
    fn new(tracer: &Tracer<'_>, seen: &Seen<'_>, pixel_angle: f32) -> Self {
        let Seen { point, sample, .. } = seen;
        let environment = tracer.environment;
        let look = look(point, environment, footprint_m(point, pixel_angle), *sample as f32 / 4.0);
        let sun = environment.sun.as_ref().and_then(|sun| sun.ray_from(point));
        let mirror = Mirror::new(point, &look, pixel_angle);
        Self { look, sun, mirror }
    }

    /// `night` is the light of lamps.
    fn radiance(
        &self,
        tracer: &Tracer<'_>,
        point: &SurfacePoint<'_>,
        sunlit: bool,
        image: Option<Vec3A>,
        night: Vec3A,
    ) -> Vec3A {
        let environment = tracer.environment;
        let (look, view) = (&self.look, -point.direction);
        let ambient = tracer.ambient(point.position + point.geometric_normal * 0.3, look.normal) * point.openness;
        let mut radiance = look.emission + look.lit_by_ambient(ambient, view);
        if let Some(sun) = environment.sun.as_ref().filter(|_| sunlit) {
            radiance += look.lit_by(sun.illuminance, sun.direction, view);
        }
        if let Some(mirror) = &self.mirror {
            radiance += mirror.light(tracer, point, image);
        }
        radiance += night;
        environment.fog.through(radiance, point.seen_from(), point.direction, point.distance)
    }
}

impl Mirror {
    /// On bright paint a weak mirror is hardly seen: there it shows soft light alone.
    fn new(point: &SurfacePoint<'_>, look: &Look, pixel_angle: f32) -> Option<Self> {
        let weight = look.coat_reflectance(-point.direction);
        let contrast = weight.max_element() / (look.albedo.max_element() + 0.05);
        let sharp = math::smoothstep(0.12, 0.20, contrast);
        let ray = mirror_ray(point, look);
        let footprint_m = mirror_footprint(point.distance, look.coat_roughness, pixel_angle);
        (weight.max_element() >= MIRROR_THRESHOLD).then_some(Self { ray, weight, sharp, footprint_m })
    }

    /// Whether its ray must be traced.
    fn is_asked(&self) -> bool {
        self.sharp > 0.0
    }

    /// Its light, given the radiance along its ray if that was asked.
    fn light(&self, tracer: &Tracer<'_>, point: &SurfacePoint<'_>, image: Option<Vec3A>) -> Vec3A {
        let mut shown = image.unwrap_or(Vec3A::ZERO) * self.sharp;
        if self.sharp < 1.0 {
            let soft = tracer.ambient(point.position, self.ray.direction) * (FRAC_1_PI * point.openness);
            shown += soft * (1.0 - self.sharp);
        }
        self.weight * shown
    }
}

/// Width of a pixel on a surface.
pub(crate) fn footprint_m(point: &SurfacePoint<'_>, pixel_angle: f32) -> f32 {
    point.distance * pixel_angle / point.geometric_normal.dot(point.direction).abs().max(0.08)
}
