//! Rays from surfaces to the sun.

use crate::scene::{ShadingPoint, SurfaceInteraction};
use endless_scene::Surface;
use glam::Vec3A;

/// Where rays to the sun start: leaves lit from behind let light through, so theirs start on the far side.
pub(super) fn sun_origin(facet: &ShadingPoint, sun: Vec3A) -> Vec3A {
    let origin = facet.ray_origin();
    if facet.geometric_normal.dot(sun) < 0.0 { facet.position * 2.0 - origin } else { origin }
}

/// Whether the sun can light a point at all: from the front, or through a leaf.
pub(super) fn sun_can_light(point: &SurfaceInteraction<'_>, sun: Vec3A) -> bool {
    point.geometric_normal.dot(sun) > 0.0 || point.material.surface == Surface::Foliage
}
