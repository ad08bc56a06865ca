//! Irradiance of one sample of the still picture, gathered by rays over its hemisphere.

use crate::accel::Ray;
use crate::material::noise;
use crate::sampling::{cosine_direction, hammersley, rotated};
use crate::scene::SurfacePoint;
use crate::shade::{Tracer, shade_secondary};
use glam::{Vec2, Vec3A};
use std::f32::consts::PI;

/// Brightest single contribution, in units of the mean sky: keeps rare bright hits from spotting the picture.
const CLAMP: f32 = 12.0;

/// Illuminance from everything but the sun's disc and the lamps, klx; noisy, to be denoised. `index` names the pattern of rays.
pub(crate) fn gather(tracer: &Tracer<'_>, point: &SurfacePoint<'_>, index: u32, rays: u32) -> Vec3A {
    let origin = point.ray_origin();
    let turn = Vec2::new(noise::cell1(index, 11), noise::cell1(index, 12));
    let limit = (tracer.environment.sky.mean.max_element() * CLAMP).max(0.05);
    let mut sum = Vec3A::ZERO;
    for k in 0..rays {
        let direction = cosine_direction(point.normal, rotated(hammersley(k, rays), turn));
        let below = direction.dot(point.geometric_normal);
        let direction =
            if below < 0.01 { (direction + point.geometric_normal * (0.01 - below)).normalize() } else { direction };
        let ray = Ray { origin, direction, tmax: f32::MAX };
        sum += shade_secondary(tracer, &ray, 0.5).min(Vec3A::splat(limit));
    }
    sum * (PI / rays as f32)
}
