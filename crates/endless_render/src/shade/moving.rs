//! Shading of moving objects: no random numbers, so no grain. Direct light by shadow rays to the lights that matter,
//! indirect light from the probes, one mirror ray for paint and glass.

use super::{
    Tracer,
    secondary::{direct, moving_mirror_light},
};
use crate::light::Beam;
use crate::material::{Look, look};
use crate::scene::{Facet, SurfacePoint};
use glam::Vec3A;

/// Lamps whose shadows a moving point tests.
const LAMPS: usize = 3;

/// Radiance of a moving surface towards the camera, fog included. `sample` is the pixel's sample that saw it.
pub(crate) fn shade_moving(tracer: &Tracer<'_>, point: &SurfacePoint<'_>, sample: usize, pixel_angle: f32) -> Vec3A {
    let environment = tracer.environment;
    let view = -point.direction;
    let footprint = footprint_m(point, pixel_angle);
    let look = look(point, environment, footprint, sample as f32 / 4.0);
    let ambient = tracer.ambient(point.position + point.geometric_normal * 0.3, look.normal) * point.openness;
    let mut radiance = look.emission + look.lit_by_ambient(ambient, view);
    radiance += direct(tracer, point, &look, view, LAMPS);
    radiance += moving_mirror_light(tracer, point, &look, pixel_angle);
    if environment.night
        && let Some(moving) = tracer.moving
    {
        let facet = point.facet();
        for &beam in moving.beams_on(point.instance) {
            radiance += beam_light(tracer, &moving.beams[usize::from(beam)], &facet, &look);
        }
    }
    environment.fog.through(radiance, point.direction, point.distance)
}

/// Light of one vehicle lamp on a point towards its viewer, without fog.
pub(crate) fn beam_light(tracer: &Tracer<'_>, beam: &Beam, point: &Facet, look: &Look) -> Vec3A {
    let (illuminance, direction) = beam.illuminance_at(point.position);
    if point.geometric_normal.dot(direction) <= 0.0 || illuminance.max_element() <= 0.0 {
        return Vec3A::ZERO;
    }
    if tracer.occluded(&beam.shadow_ray(point.ray_origin())) {
        return Vec3A::ZERO;
    }
    look.lit_by(illuminance, direction, -point.direction)
}

/// Width of a pixel on a surface.
pub(crate) fn footprint_m(point: &SurfacePoint<'_>, pixel_angle: f32) -> f32 {
    point.distance * pixel_angle / point.geometric_normal.dot(point.direction).abs().max(0.08)
}
