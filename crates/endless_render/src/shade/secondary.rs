//! Surfaces seen in mirrors and by indirect rays: shaded once, from the caches, without further rays but to the lights.

use super::lamplight::{lamp_light, lamp_light8};
use super::{Tracer, tracer::SceneHit};
use crate::accel::Ray;
use crate::light::Environment;
use crate::material::{Bsdf, evaluate_bsdf, evaluate_bsdfs};
use crate::scene::SurfaceInteraction;
use glam::Vec3A;

/// Lamps whose shadows a secondary point tests.
const LAMPS: usize = 2;

/// Radiance that arrives along a ray of which it is known what it met, kcd/m². `footprint_m` is the width of detail that
/// matters where it lands.
pub(crate) fn shade_hit(tracer: &Tracer<'_>, ray: &Ray, struck: Option<&SceneHit>, footprint_m: f32) -> Vec3A {
    let Some(struck) = struck else { return tracer.environment.sky.radiance(ray.direction) };
    let point = tracer.point(ray, struck);
    let bsdf = evaluate_bsdf(&point, tracer.environment, footprint_m, 0.5);
    let direct = if tracer.environment.night {
        lamp_light(tracer, &point, &bsdf, LAMPS)
    } else {
        let sunlit = sun_ray(tracer, &point).is_some_and(|ray| !tracer.occluded(&ray));
        if sunlit { sun_light(tracer.environment, &point, &bsdf) } else { Vec3A::ZERO }
    };
    let radiance = soft_light(tracer, &point, &bsdf) + direct;
    tracer.environment.fog.through(radiance, ray.origin, ray.direction, struck.hit.t)
}

/// [`shade_hit`] for those of eight rays whose bit is set in `active`.
pub(crate) fn shade_hit8(
    tracer: &Tracer<'_>,
    rays: &[Ray; 8],
    struck: &[Option<SceneHit>; 8],
    active: u8,
    footprints_m: &[f32; 8],
) -> [Vec3A; 8] {
    let environment = tracer.environment;
    let points: [Option<SurfaceInteraction<'_>>; 8] =
        std::array::from_fn(|i| struck[i].as_ref().map(|struck| tracer.point(&rays[i], struck)));
    let mut bsdfs =
        evaluate_bsdfs(&points.each_ref().map(Option::as_ref), environment, footprints_m, &[0.5; 8]).into_iter();
    let points = points.map(|point| point.zip(bsdfs.next().flatten()));
    let direct = direct8(tracer, rays, &points);
    std::array::from_fn(|i| match &points[i] {
        Some((point, bsdf)) => {
            let radiance = soft_light(tracer, point, bsdf) + direct[i];
            environment.fog.through(radiance, rays[i].origin, rays[i].direction, point.distance)
        }
        None if active >> i & 1 == 1 => environment.sky.radiance(rays[i].direction),
        None => Vec3A::ZERO,
    })
}

/// Light from the sun's centre, or of the strongest lamps, with hard shadows.
fn direct8(tracer: &Tracer<'_>, rays: &[Ray; 8], points: &[Option<(SurfaceInteraction<'_>, Bsdf)>; 8]) -> [Vec3A; 8] {
    if tracer.environment.night {
        return lamp_light8(tracer, &points.each_ref().map(|p| p.as_ref().map(|(p, bsdf)| (p, bsdf))), LAMPS);
    }
    let mut asked = 0u8;
    let to_sun = std::array::from_fn(|i| {
        let ray = points[i].as_ref().and_then(|(point, _)| sun_ray(tracer, point));
        asked |= u8::from(ray.is_some()) << i;
        ray.unwrap_or(Ray { tmax: 0.0, ..rays[i] })
    });
    let sunlit = asked & !tracer.occluded8(&to_sun, asked);
    std::array::from_fn(|i| {
        let lit = points[i].as_ref().filter(|_| sunlit >> i & 1 == 1);
        lit.map_or(Vec3A::ZERO, |(point, bsdf)| sun_light(tracer.environment, point, bsdf))
    })
}

/// Towards the centre of the sun's disc, if that can light a point.
fn sun_ray(tracer: &Tracer<'_>, point: &SurfaceInteraction<'_>) -> Option<Ray> {
    tracer.environment.sun.as_ref()?.ray_from(point)
}

/// Radiance of a surface point towards where it was seen from, but for direct light and fog.
fn soft_light(tracer: &Tracer<'_>, point: &SurfaceInteraction<'_>, bsdf: &Bsdf) -> Vec3A {
    let view = -point.direction;
    let ambient = tracer.ambient(point.position + point.geometric_normal * 0.25, bsdf.normal) * point.ambient_occlusion;
    let mut radiance = bsdf.emission + bsdf.lit_by_ambient(ambient, view);
    // A second mirror shows the sky, as far as the sky is there.
    let coat = bsdf.coat_reflectance(view);
    if coat.max_element() > 0.0 {
        let direction = bsdf.mirror_direction(point.direction, point.geometric_normal);
        let sky = tracer.environment.sky.radiance(direction) * direction.z.clamp(0.0, 0.35) * 2.0;
        radiance += coat * sky * point.ambient_occlusion;
    }
    radiance
}

/// Light of the sun, were nothing in its way.
pub(crate) fn sun_light(environment: &Environment, point: &SurfaceInteraction<'_>, bsdf: &Bsdf) -> Vec3A {
    let sun = environment.sun.as_ref();
    sun.map_or(Vec3A::ZERO, |sun| bsdf.lit_by(sun.illuminance, sun.direction, -point.direction))
}

/// What a coat's mirror shows, weighted by its reflectance, and how far it sees. No light where the weight is too small
/// to see.
pub(crate) fn mirror_light(
    tracer: &Tracer<'_>,
    point: &SurfaceInteraction<'_>,
    bsdf: &Bsdf,
    pixel_angle: f32,
) -> (Vec3A, f32) {
    let weight = bsdf.coat_reflectance(-point.direction);
    if weight.max_element() < MIRROR_THRESHOLD {
        return (Vec3A::ZERO, 0.0);
    }
    let ray = mirror_ray(point, bsdf);
    let struck = tracer.closest(&ray);
    let light =
        shade_hit(tracer, &ray, struck.as_ref(), mirror_footprint(point.distance, bsdf.coat_roughness, pixel_angle));
    (weight * light, struck.map_or(f32::MAX, |s| s.hit.t))
}

/// Mirrors weaker than this show nothing.
pub(crate) const MIRROR_THRESHOLD: f32 = 0.02;

pub(crate) fn mirror_ray(point: &SurfaceInteraction<'_>, bsdf: &Bsdf) -> Ray {
    Ray {
        origin: point.ray_origin(),
        direction: bsdf.mirror_direction(point.direction, point.geometric_normal),
        tmax: f32::MAX,
    }
}

/// Rough width of detail in a mirror image seen from this far.
pub(crate) fn mirror_footprint(distance: f32, roughness: f32, pixel_angle: f32) -> f32 {
    (distance + 12.0) * (pixel_angle + 0.05 * roughness)
}
