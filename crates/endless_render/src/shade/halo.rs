//! The glow of lamps in the air.

use super::Tracer;
use crate::accel::Ray;
use glam::Vec3A;

/// Glow of lamps in misty night air along a view ray.
pub(crate) fn halos(tracer: &Tracer<'_>, ray: &Ray, distance: f32) -> Vec3A {
    let environment = tracer.environment;
    if !environment.halos() {
        return Vec3A::ZERO;
    }
    let reach = distance.min(150.0);
    tracer
        .still
        .lamps
        .all()
        .iter()
        .filter(|lamp| lamp.position.distance_squared(ray.origin) < 140.0 * 140.0)
        .map(|lamp| environment.fog.halo(ray.origin, ray.direction, reach, lamp.position, lamp.intensity))
        .sum()
}
