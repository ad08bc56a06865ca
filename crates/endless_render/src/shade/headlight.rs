//! Vehicle lights on points that move themselves.

use super::Tracer;
use crate::accel::Ray;
use crate::material::Bsdf;
use crate::scene::{FrameScene, SurfaceInteraction};
use glam::Vec3A;

/// Light of all vehicle lamps that reach a point, without fog.
pub(super) fn beam_light(
    tracer: &Tracer<'_>,
    moving: &FrameScene,
    point: &SurfaceInteraction<'_>,
    bsdf: &Bsdf,
) -> Vec3A {
    let origin = point.ray_origin();
    let lit = |&beam: &u16| {
        let beam = &moving.beams[usize::from(beam)];
        let (illuminance, direction) = beam.illuminance_at(point.position);
        let faces = point.geometric_normal.dot(direction) > 0.0 && illuminance.max_element() > 0.0;
        let free = faces && !tracer.occluded(&beam.shadow_ray(origin));
        free.then(|| bsdf.lit_by(illuminance, direction, -point.direction))
    };
    moving.beams_on(point.instance).iter().filter_map(lit).sum()
}

/// The same for up to eight points: rays to one lamp run side by side.
pub(super) fn beam_light8(
    tracer: &Tracer<'_>,
    moving: &FrameScene,
    points: &[Option<(&SurfaceInteraction<'_>, &Bsdf)>; 8],
) -> [Vec3A; 8] {
    let mut sums = [Vec3A::ZERO; 8];
    let mut lists: [&[u16]; 8] = points.map(|p| p.map_or(&[][..], |(point, _)| moving.beams_on(point.instance)));
    let origins = points.map(|p| p.map_or(Vec3A::ZERO, |(point, _)| point.ray_origin()));
    // The lists are ascending: the least of their heads is the next lamp of all.
    while let Some(next) = lists.iter().filter_map(|list| list.first()).min().copied() {
        let beam = &moving.beams[usize::from(next)];
        let mut asked = 0u8;
        let mut arriving = [(Vec3A::ZERO, Vec3A::Z); 8];
        for (i, list) in lists.iter_mut().enumerate() {
            let (Some((point, _)), Some((_, rest))) = (points[i], list.split_first().filter(|(b, _)| **b == next))
            else {
                continue;
            };
            *list = rest;
            let (illuminance, direction) = beam.illuminance_at(point.position);
            let faces = point.geometric_normal.dot(direction) > 0.0 && illuminance.max_element() > 0.0;
            arriving[i] = (illuminance, direction);
            asked |= u8::from(faces) << i;
        }
        if asked == 0 {
            continue;
        }
        let rays: [Ray; 8] = origins.map(|origin| beam.shadow_ray(origin));
        let free = asked & !tracer.occluded8(&rays, asked);
        for i in (0..8).filter(|i| free >> i & 1 == 1) {
            if let Some((point, bsdf)) = points[i] {
                let (illuminance, direction) = arriving[i];
                sums[i] += bsdf.lit_by(illuminance, direction, -point.direction);
            }
        }
    }
    sums
}
