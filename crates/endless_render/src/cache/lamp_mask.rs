//! The lamps that light a point, and those that moving objects hide: a bit for each lamp near it.

use crate::accel::Ray;
use crate::material::Bsdf;
use crate::scene::{FrameScene, ShadingPoint};
use crate::shade::Tracer;
use glam::Vec3A;

/// The lamps near a point that light it past the static scene, a bit each.
pub(super) fn lamps_free(tracer: &Tracer<'_>, facet: &ShadingPoint) -> u32 {
    let origin = facet.ray_origin();
    let mut free = 0;
    for (bit, lamp) in tracer.still.lamps.near(facet.position).enumerate() {
        let (illuminance, direction) = lamp.illuminance_at(facet.position);
        let lit = facet.geometric_normal.dot(direction) > 0.0 && illuminance.max_element() > 0.0;
        let ray = Ray { origin, direction: lamp.position - origin, tmax: 0.999 };
        free |= u32::from(lit && !tracer.still.accel.occluded(&ray)) << bit;
    }
    free
}

/// Those of the free lamps that something that moves hides; only `lamps` (indices) are asked.
pub(super) fn lamps_blocked(
    tracer: &Tracer<'_>,
    frame: &FrameScene,
    lamps: &[u16],
    facet: &ShadingPoint,
    free: u32,
) -> u32 {
    if lamps.is_empty() || free == 0 {
        return 0;
    }
    let near = tracer.still.lamps.indices_near(facet.position);
    let origin = facet.ray_origin();
    let mut blocked = 0;
    for lamp in lamps {
        let Ok(bit) = near.binary_search(lamp) else { continue };
        let position = tracer.still.lamps.all()[usize::from(*lamp)].position;
        let hidden =
            free >> bit & 1 == 1 && frame.accel.occluded(&Ray { origin, direction: position - origin, tmax: 0.999 });
        blocked |= u32::from(hidden) << bit;
    }
    blocked
}

/// Light of these lamps near a point, without fog.
pub(super) fn lamp_sum(tracer: &Tracer<'_>, facet: &ShadingPoint, bsdf: &Bsdf, free: u32) -> Vec3A {
    let mut sum = Vec3A::ZERO;
    for (bit, lamp) in tracer.still.lamps.near(facet.position).enumerate() {
        if free >> bit & 1 == 1 {
            let (illuminance, direction) = lamp.illuminance_at(facet.position);
            sum += bsdf.lit_by(illuminance, direction, -facet.direction);
        }
    }
    sum
}
