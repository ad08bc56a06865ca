//! How much of its surroundings each vertex of a moving body sees past the body itself and the ground it shades.

use super::{Body, Shape};
use crate::accel::{Accel, Ray};
use crate::sampling::{cosine_direction, hammersley};
use glam::{Affine3A, Vec3A};
use rayon::prelude::*;
use std::sync::Arc;

const RAYS: u32 = 24;

/// Openness of every vertex, 0 to 1: the cosine-weighted share of directions that neither meet the body itself nor
/// the dark ground beneath it. `low` and `high` bound the whole object, wheels included.
pub(crate) fn openness(shape: &Shape, body: &Body, low: Vec3A, high: Vec3A) -> Vec<f32> {
    let accel = Accel::build(vec![(Arc::clone(&body.blas), Affine3A::IDENTITY)]);
    let size = (high - low).max_element();
    debug_assert_eq!(shape.uvs.len(), body.positions.len());
    (0..body.positions.len())
        .into_par_iter()
        .map(|i| {
            let normal = Vec3A::from(body.normals[i]);
            let origin = Vec3A::from(body.positions[i]) + normal * (size * 2e-3);
            let mut open = 0.0;
            for k in 0..RAYS {
                let direction = cosine_direction(normal, hammersley(k, RAYS));
                let ray = Ray { origin, direction, tmax: size };
                if !accel.occluded(&ray) {
                    open += ground_light(origin, direction, low, high);
                }
            }
            open / RAYS as f32
        })
        .collect()
}

/// Ground under the object lies in its shadow: a direction that ends there brings little.
fn ground_light(origin: Vec3A, direction: Vec3A, low: Vec3A, high: Vec3A) -> f32 {
    if direction.z >= -1e-3 {
        return 1.0;
    }
    let end = origin + direction * (origin.z.max(0.0) / -direction.z);
    let outside = (low - end).max(end - high).max(Vec3A::ZERO);
    let distance = (outside.x * outside.x + outside.y * outside.y).sqrt();
    let reach = (high.z - low.z) * 0.6;
    0.12 + 0.88 * (distance / reach).min(1.0)
}
