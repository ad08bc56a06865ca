//! Surfaces seen in mirrors and by indirect rays: shaded once, from the caches, without further rays but to the lights.

use super::{Tracer, tracer::Struck};
use crate::accel::Ray;
use crate::material::{Look, look};
use crate::scene::SurfacePoint;
use glam::Vec3A;

/// Lamps whose shadows a secondary point tests.
const LAMPS: usize = 2;

/// Radiance that arrives along a ray, kcd/m². `footprint_m` is the width of detail that matters where it lands.
pub(crate) fn shade_secondary(tracer: &Tracer<'_>, ray: &Ray, footprint_m: f32) -> Vec3A {
    shade_struck(tracer, ray, tracer.closest(ray).as_ref(), footprint_m)
}

/// The same for a ray of which it is known what it met.
pub(crate) fn shade_struck(tracer: &Tracer<'_>, ray: &Ray, struck: Option<&Struck>, footprint_m: f32) -> Vec3A {
    let Some(struck) = struck else { return tracer.environment.sky.radiance(ray.direction) };
    let point = tracer.point(ray, struck);
    let sunlit = sun_ray(tracer, &point).is_some_and(|ray| !tracer.occluded(&ray));
    let radiance = shade_point(tracer, &point, footprint_m, sunlit);
    tracer.environment.fog.through(radiance, ray.origin, ray.direction, struck.hit.t)
}

/// [`shade_secondary`] for those of eight rays whose bit is set in `active`: they run side by side.
pub(crate) fn shade_secondary8(
    tracer: &Tracer<'_>,
    rays: &[Ray; 8],
    active: u8,
    footprints_m: &[f32; 8],
) -> [Vec3A; 8] {
    if active == 0 {
        return [Vec3A::ZERO; 8];
    }
    let struck = tracer.closest8(rays, active);
    let points: [Option<SurfacePoint<'_>>; 8] =
        std::array::from_fn(|i| struck[i].as_ref().map(|struck| tracer.point(&rays[i], struck)));
    let mut asked = 0u8;
    let to_sun = std::array::from_fn(|i| {
        let ray = points[i].as_ref().and_then(|point| sun_ray(tracer, point));
        asked |= u8::from(ray.is_some()) << i;
        ray.unwrap_or(Ray { tmax: 0.0, ..rays[i] })
    });
    let sunlit = asked & !tracer.occluded8(&to_sun, asked);
    std::array::from_fn(|i| match &points[i] {
        Some(point) => {
            let radiance = shade_point(tracer, point, footprints_m[i], sunlit >> i & 1 == 1);
            tracer.environment.fog.through(radiance, rays[i].origin, rays[i].direction, point.distance)
        }
        None if active >> i & 1 == 1 => tracer.environment.sky.radiance(rays[i].direction),
        None => Vec3A::ZERO,
    })
}

/// Towards the centre of the sun's disc, if that can light a point.
fn sun_ray(tracer: &Tracer<'_>, point: &SurfacePoint<'_>) -> Option<Ray> {
    tracer.environment.sun.as_ref()?.ray_from(point)
}

/// Radiance of a surface point towards where it was seen from, without fog.
fn shade_point(tracer: &Tracer<'_>, point: &SurfacePoint<'_>, footprint_m: f32, sunlit: bool) -> Vec3A {
    let environment = tracer.environment;
    let view = -point.direction;
    let look = look(point, environment, footprint_m, 0.5);
    let ambient = tracer.ambient(point.position + point.geometric_normal * 0.25, look.normal) * point.openness;
    let mut radiance = look.emission + look.lit_by_ambient(ambient, view);
    // A second mirror shows the sky, as far as the sky is there.
    let coat = look.coat_reflectance(view);
    if coat.max_element() > 0.0 {
        let direction = look.mirror_direction(point.direction, point.geometric_normal);
        let sky = environment.sky.radiance(direction) * direction.z.clamp(0.0, 0.35) * 2.0;
        radiance += coat * sky * point.openness;
    }
    radiance + direct(tracer, point, &look, view, sunlit)
}

/// Light from the sun's centre, if the point is `sunlit`, and the strongest lamps, with hard shadows.
fn direct(tracer: &Tracer<'_>, point: &SurfacePoint<'_>, look: &Look, view: Vec3A, sunlit: bool) -> Vec3A {
    let environment = tracer.environment;
    if environment.night {
        return lamp_light(tracer, point, look, view, LAMPS);
    }
    match &environment.sun {
        Some(sun) if sunlit => look.lit_by(sun.illuminance, sun.direction, view),
        _ => Vec3A::ZERO,
    }
}

/// Light of the strongest lamps, with hard shadows.
pub(super) fn lamp_light(
    tracer: &Tracer<'_>,
    point: &SurfacePoint<'_>,
    look: &Look,
    view: Vec3A,
    count: usize,
) -> Vec3A {
    let origin = point.ray_origin();
    // The few strongest, by insertion into a short list.
    let mut best = [Candidate { strength: 0.0, lit: Vec3A::ZERO, lamp: 0, direction: Vec3A::Z }; 4];
    let count = count.min(best.len());
    for &lamp in tracer.still.lamps.indices_near(point.position) {
        let (illuminance, direction) = tracer.still.lamps.all()[usize::from(lamp)].illuminance_at(point.position);
        if point.geometric_normal.dot(direction) <= 0.0 || illuminance.max_element() <= 0.0 {
            continue;
        }
        let lit = look.lit_by(illuminance, direction, view);
        let strength = lit.max_element();
        if strength <= best[count - 1].strength {
            continue;
        }
        let mut at = count - 1;
        while at > 0 && best[at - 1].strength < strength {
            best[at] = best[at - 1];
            at -= 1;
        }
        best[at] = Candidate { strength, lit, lamp, direction };
    }
    best[..count].iter().filter(|c| c.strength > 0.0).map(|c| c.lit * lamp_share(tracer, c, origin)).sum()
}

/// A lamp that may light a point.
#[derive(Clone, Copy)]
struct Candidate {
    strength: f32,
    lit: Vec3A,
    lamp: u16,
    /// To the lamp.
    direction: Vec3A,
}

/// Share of a lamp's light that arrives: past the town by the lamp's map, past what moves by a ray.
fn lamp_share(tracer: &Tracer<'_>, candidate: &Candidate, origin: Vec3A) -> f32 {
    let lamp = usize::from(candidate.lamp);
    let way = tracer.still.lamps.all()[lamp].position - origin;
    let ray = Ray { origin, direction: way, tmax: 0.999 };
    let share = match tracer.lamp_maps.lit(lamp, candidate.direction, way.length()) {
        Some(share) => share,
        None => f32::from(!tracer.still.accel.occluded(&ray)),
    };
    if share > 0.0 && tracer.moving.is_some_and(|m| m.accel.occluded(&ray)) { 0.0 } else { share }
}

/// What a coat's mirror shows, weighted by its reflectance, and how far it sees. No light where the weight is too small
/// to see.
pub(crate) fn mirror_light(
    tracer: &Tracer<'_>,
    point: &SurfacePoint<'_>,
    look: &Look,
    pixel_angle: f32,
) -> (Vec3A, f32) {
    let weight = look.coat_reflectance(-point.direction);
    if weight.max_element() < MIRROR_THRESHOLD {
        return (Vec3A::ZERO, 0.0);
    }
    let ray = mirror_ray(point, look);
    let struck = tracer.closest(&ray);
    let light =
        shade_struck(tracer, &ray, struck.as_ref(), mirror_footprint(point.distance, look.coat_roughness, pixel_angle));
    (weight * light, struck.map_or(f32::MAX, |s| s.hit.t))
}

/// Mirrors weaker than this show nothing.
pub(crate) const MIRROR_THRESHOLD: f32 = 0.02;

pub(crate) fn mirror_ray(point: &SurfacePoint<'_>, look: &Look) -> Ray {
    Ray {
        origin: point.ray_origin(),
        direction: look.mirror_direction(point.direction, point.geometric_normal),
        tmax: f32::MAX,
    }
}

/// Rough width of detail in a mirror image seen from this far.
pub(crate) fn mirror_footprint(distance: f32, roughness: f32, pixel_angle: f32) -> f32 {
    (distance + 12.0) * (pixel_angle + 0.05 * roughness)
}
