//! The glow of lamps in the air.

use super::Tracer;
use crate::accel::Ray;
use crate::light::PointLamp;
use crate::vec3x8::{Vec3x8, splat};
use glam::Vec3A;
use wide::f32x8;

/// Lamps farther away do not glow, metres.
const FARTHEST_M: f32 = 140.0;
/// Rays gather glow as far as this, metres.
const REACH_M: f32 = 150.0;

/// Glow of lamps in misty night air along eight view rays from one origin, as far as these distances.
pub(crate) fn halos8(tracer: &Tracer<'_>, origin: Vec3A, directions: &Vec3x8, distances_m: f32x8) -> [Vec3A; 8] {
    let environment = tracer.environment;
    if !environment.halos() {
        return [Vec3A::ZERO; 8];
    }
    let reach = distances_m.fast_min(f32x8::splat(REACH_M));
    let near = |lamp: &&PointLamp| lamp.position.distance_squared(origin) < FARTHEST_M * FARTHEST_M;
    let mut sums = [f32x8::ZERO; 3];
    for lamp in tracer.lamps.all().iter().filter(near) {
        let glow = environment.fog.halo8(origin, directions, reach, lamp.position);
        for (sum, intensity) in sums.iter_mut().zip(lamp.intensity.to_array()) {
            *sum += glow * f32x8::splat(intensity);
        }
    }
    let [r, g, b] = sums.map(f32x8::to_array);
    std::array::from_fn(|i| Vec3A::new(r[i], g[i], b[i]))
}

/// The same along one.
pub(crate) fn halos(tracer: &Tracer<'_>, ray: &Ray, distance_m: f32) -> Vec3A {
    let [glow, ..] = halos8(tracer, ray.origin, &splat(ray.direction), f32x8::splat(distance_m));
    glow
}
