//! Rays from surfaces to the sun.

use crate::scene::{ShadingPoint, SurfaceInteraction, ray_origins8};
use crate::vec3x8::{Vec3x8, dot};
use endless_scene::Surface;
use glam::Vec3A;
use wide::f32x8;

/// Where rays to the sun start: leaves lit from behind let light through, so theirs start on the far side.
pub(super) fn sun_origin(facet: &ShadingPoint, sun: Vec3A) -> Vec3A {
    let origin = facet.ray_origin();
    if facet.geometric_normal.dot(sun) < 0.0 { facet.position * 2.0 - origin } else { origin }
}

/// The same for eight points.
pub(super) fn sun_origins8(positions: &Vec3x8, normals: &Vec3x8, distances: f32x8, sun: &Vec3x8) -> Vec3x8 {
    let origins = ray_origins8(positions, normals, distances);
    let from_behind = dot(normals, sun).simd_lt(f32x8::ZERO);
    std::array::from_fn(|k| from_behind.select(positions[k] * f32x8::splat(2.0) - origins[k], origins[k]))
}

/// Whether the sun can light a point at all: from the front, or through a leaf.
pub(super) fn sun_can_light(point: &SurfaceInteraction<'_>, sun: Vec3A) -> bool {
    point.geometric_normal.dot(sun) > 0.0 || point.material.surface == Surface::Foliage
}
