//! Rays from surfaces to the sun.

use crate::light::Sun;
use crate::scene::{ShadingPoint, SurfaceInteraction, ray_origins8};
use crate::vec3x8::{Vec3x8, dot, splat};
use endless_scene::Surface;
use glam::Vec3A;
use wide::f32x8;

/// Where rays to the sun start: leaves lit from behind let light through, so theirs start on the far side.
pub(super) fn sun_origin(facet: &ShadingPoint, sun: Vec3A) -> Vec3A {
    let origin = facet.ray_origin();
    if facet.geometric_normal.dot(sun) < 0.0 { facet.position * 2.0 - origin } else { origin }
}

/// Where eight samples lie.
pub(super) struct LitPlaces {
    pub(super) positions: Vec3x8,
    /// Of their triangles.
    pub(super) normals: Vec3x8,
    /// From where they are seen.
    pub(super) distances: f32x8,
    /// On leaves, a bit each.
    pub(super) is_leaf: u32,
}

impl LitPlaces {
    /// Those that the sun can light at all, a bit each: from the front, or through a leaf.
    pub(super) fn can_be_lit_by(&self, sun: &Sun) -> u32 {
        faces8(&self.normals, sun) | self.is_leaf
    }

    /// Where their rays to the sun start, as [`sun_origin`] has it.
    pub(super) fn ray_origins(&self, sun: &Sun) -> Vec3x8 {
        let Self { positions, normals, distances, .. } = self;
        let origins = ray_origins8(positions, normals, *distances);
        let from_behind = dot(normals, &splat(sun.direction)).simd_lt(f32x8::ZERO);
        std::array::from_fn(|k| from_behind.select(positions[k] * f32x8::splat(2.0) - origins[k], origins[k]))
    }
}

/// Which of eight normals face the sun, a bit each.
pub(super) fn faces8(normals: &Vec3x8, sun: &Sun) -> u32 {
    dot(normals, &splat(sun.direction)).simd_gt(f32x8::ZERO).to_bitmask()
}

/// Whether the sun can light a point at all: from the front, or through a leaf.
pub(super) fn sun_can_light(point: &SurfaceInteraction<'_>, sun: Vec3A) -> bool {
    point.geometric_normal.dot(sun) > 0.0 || point.material.surface == Surface::Foliage
}
