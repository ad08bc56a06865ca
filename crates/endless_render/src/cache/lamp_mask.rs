//! The lamps that light a point, and those that moving objects hide: a bit for each lamp near it.

use crate::accel::{Ray, RayStream, lanes};
use crate::light::PointLamp;
use crate::material::Bsdf;
use crate::scene::{FrameScene, ShadingPoint};
use crate::shade::Tracer;
use glam::Vec3A;

/// The lamps near a point that light it past the static scene, a bit each.
pub(super) fn lamps_free(tracer: &Tracer<'_>, facet: &ShadingPoint) -> u32 {
    let origin = facet.ray_origin();
    let mut free = 0;
    for (bit, lamp) in tracer.lamps.near(facet.position).enumerate() {
        let ray = Ray::to_light(origin, lamp.position);
        free |= u32::from(lights(lamp, facet) && !tracer.still.accel.occluded(&ray)) << bit;
    }
    free
}

/// The same for those of the points of a bundle whose bit is set in `asked`: rays to the same lamp run side by side.
pub(super) fn lamps_free32(tracer: &Tracer<'_>, facets: &[Option<ShadingPoint>; 32], mut asked: u32) -> [u32; 32] {
    let mut free = [0u32; 32];
    let near = |lane: usize| facets[lane].map_or(&[][..], |facet| tracer.lamps.indices_near(facet.position));
    let mut rays = RayStream::<4>::NONE;
    while asked != 0 {
        // Those that have the same lamps near them.
        let lamps = near(asked.trailing_zeros() as usize);
        let together =
            lanes(asked).filter(|lane| std::ptr::eq(near(*lane), lamps)).fold(0, |bits, lane| bits | 1 << lane);
        asked &= !together;
        for (bit, lamp) in lamps.iter().enumerate() {
            let lamp = &tracer.lamps.all()[usize::from(*lamp)];
            let mut lit = 0u32;
            for lane in lanes(together) {
                let Some(facet) = &facets[lane] else { continue };
                if lights(lamp, facet) {
                    let origin = facet.ray_origin();
                    rays.set(lane, &Ray::to_light(origin, lamp.position));
                    lit |= 1 << lane;
                }
            }
            let open = if lit == 0 { 0 } else { lit & !tracer.still.accel.occluded32(&rays, lit) };
            for lane in lanes(open) {
                free[lane] |= 1 << bit;
            }
        }
    }
    free
}

/// Whether a lamp lights a point if nothing is in its way.
fn lights(lamp: &PointLamp, facet: &ShadingPoint) -> bool {
    let (illuminance, direction) = lamp.illuminance_at(facet.position);
    facet.geometric_normal.dot(direction) > 0.0 && illuminance.max_element() > 0.0
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
    let near = tracer.lamps.indices_near(facet.position);
    let origin = facet.ray_origin();
    let mut blocked = 0;
    for lamp in lamps {
        let Ok(bit) = near.binary_search(lamp) else { continue };
        let position = tracer.lamps.all()[usize::from(*lamp)].position;
        let hidden = free >> bit & 1 == 1 && frame.accel.occluded(&Ray::to_light(origin, position));
        blocked |= u32::from(hidden) << bit;
    }
    blocked
}

/// Light of these lamps near a point, without fog.
pub(super) fn lamp_sum(tracer: &Tracer<'_>, facet: &ShadingPoint, bsdf: &Bsdf, free: u32) -> Vec3A {
    let mut sum = Vec3A::ZERO;
    for (bit, lamp) in tracer.lamps.near(facet.position).enumerate() {
        if free >> bit & 1 == 1 {
            let (illuminance, direction) = lamp.illuminance_at(facet.position);
            sum += bsdf.lit_by(illuminance, direction, -facet.direction);
        }
    }
    sum
}
