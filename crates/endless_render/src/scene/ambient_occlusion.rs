//! Ambient occlusion of each vertex of a moving body by the body itself and the ground that it shades.

use super::posed_mesh::PosedMesh;
use crate::accel::Ray;
use crate::sampling::{cosine_direction, hammersley};
use glam::{IVec3, Vec3A};
use rayon::prelude::*;
use std::collections::HashMap;

const RAYS: u32 = 24;
const SPARSE: u32 = 3;
const FIRST: u32 = RAYS / SPARSE;
/// Places that follow each other, which the same things shade.
const NEIGHBOURS: usize = 64;
/// Rays start this far off the surface; of the object's largest measure.
const LIFT: f32 = 2e-3;

/// Ambient occlusion of every vertex, from 0, all hidden, to 1: the cosine-weighted share of directions that neither meet the body itself nor
/// the dark ground beneath it. `low` and `high` bound the whole object, wheels included.
pub(super) fn ambient_occlusion(mesh: &PosedMesh, low: Vec3A, high: Vec3A) -> Vec<f32> {
    let size = (high - low).max_element();
    // About the normal of the surface, which is up; a third of them, well spread, come first.
    let order = |k: u32| SPARSE * (k % FIRST) + k / FIRST;
    let directions: [Vec3A; RAYS as usize] =
        std::array::from_fn(|k| cosine_direction(Vec3A::Z, hammersley(order(k as u32), RAYS)));
    let (places, place_of) = places(mesh, size);
    let open: Vec<f32> = places
        .par_chunks(NEIGHBOURS)
        .flat_map_iter(|places| {
            let mut shadows = mesh.blas.shadows::<{ RAYS as usize }>();
            places.iter().map(move |&vertex| {
                let normal = mesh.normal(vertex);
                let origin = Vec3A::from(mesh.positions()[vertex]) + normal * (size * LIFT);
                let (a, b) = normal.any_orthonormal_pair();
                let mut light = directions.iter().enumerate().map(|(k, d)| {
                    let direction = a * d.x + b * d.y + normal * d.z;
                    let occluded = shadows.occluded(k, &Ray { origin, direction, tmax: size });
                    if occluded { 0.0 } else { ground_light(origin, direction, low, high) }
                });
                let first: f32 = light.by_ref().take(FIRST as usize).sum();
                // Deep inside nothing is seen.
                if first == 0.0 { 0.0 } else { (first + light.sum::<f32>()) / RAYS as f32 }
            })
        })
        .collect();
    place_of.into_iter().map(|place| open[place as usize]).collect()
}

/// Vertices that stand for all: one of those that lie on one small flat piece of surface, where all see about the
/// same. With it, which of them stands for each vertex.
fn places(mesh: &PosedMesh, size: f32) -> (Vec<usize>, Vec<u32>) {
    /// Across the surface, of the object's size and in metres at most.
    const ACROSS: f32 = 0.012;
    const MOST_M: f32 = 0.05;
    /// Along the normal, metres at least.
    const LEAST_M: f32 = 0.006;
    let (across, along) = ((ACROSS * size).min(MOST_M), (LIFT * size).max(LEAST_M));
    let mut known: HashMap<(IVec3, IVec3, i32), u32> = HashMap::with_capacity(mesh.positions().len());
    let mut places = Vec::new();
    let mut place_of = |vertex: usize| {
        let (position, normal) = (Vec3A::from(mesh.positions()[vertex]), mesh.normal(vertex));
        let facing = (normal * 4.0).round();
        let height = (position.dot(facing.normalize_or(Vec3A::Z)) / along).floor();
        let key = ((position / across).floor().as_ivec3(), facing.as_ivec3(), height as i32);
        *known.entry(key).or_insert_with(|| {
            places.push(vertex);
            places.len() as u32 - 1
        })
    };
    let place_of = (0..mesh.positions().len()).map(&mut place_of).collect();
    (places, place_of)
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
