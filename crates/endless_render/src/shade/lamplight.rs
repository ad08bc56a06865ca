//! Street lamps on points that are shaded once a frame: the few strongest, with hard shadows.

use super::Tracer;
use crate::accel::Ray;
use crate::material::Bsdf;
use crate::scene::SurfaceInteraction;
use glam::Vec3A;

/// Most lamps that a point tests.
const MOST: usize = 3;

/// A lamp that may light a point.
#[derive(Clone, Copy)]
struct LampCandidate {
    strength: f32,
    lit: Vec3A,
    lamp: u16,
    /// To the lamp.
    direction: Vec3A,
}

impl LampCandidate {
    const NONE: Self = Self { strength: 0.0, lit: Vec3A::ZERO, lamp: 0, direction: Vec3A::Z };

    fn is_some(&self) -> bool {
        self.strength > 0.0
    }

    /// The ray that must be free for its light to arrive.
    fn ray(&self, tracer: &Tracer<'_>, origin: Vec3A) -> Ray {
        let position = tracer.lamps.all()[usize::from(self.lamp)].position;
        Ray::to_light(origin, position)
    }

    /// Share of the light that the static scene lets through, where the lamp's map knows it.
    fn mapped_share(&self, tracer: &Tracer<'_>, ray: &Ray) -> Option<f32> {
        tracer.lamp_maps.lit(usize::from(self.lamp), self.direction, ray.direction.length())
    }
}

/// Light of the `count` strongest lamps.
pub(super) fn lamp_light(tracer: &Tracer<'_>, point: &SurfaceInteraction<'_>, bsdf: &Bsdf, count: usize) -> Vec3A {
    let origin = point.ray_origin();
    let share = |candidate: &LampCandidate| {
        let ray = candidate.ray(tracer, origin);
        let share = candidate.mapped_share(tracer, &ray);
        let share = share.unwrap_or_else(|| f32::from(!tracer.still.accel.occluded(&ray)));
        if share > 0.0 && tracer.moving.is_some_and(|m| m.accel.occluded(&ray)) { 0.0 } else { share }
    };
    strongest(tracer, point, bsdf, count).iter().filter(|c| c.is_some()).map(|c| c.lit * share(c)).sum()
}

/// The same for up to eight points: rays to lamps of the same rank run side by side.
pub(super) fn lamp_light8(
    tracer: &Tracer<'_>,
    points: &[Option<(&SurfaceInteraction<'_>, &Bsdf)>; 8],
    count: usize,
) -> [Vec3A; 8] {
    let mut sums = [Vec3A::ZERO; 8];
    let best =
        points.map(|p| p.map_or([LampCandidate::NONE; MOST], |(point, bsdf)| strongest(tracer, point, bsdf, count)));
    let origins = points.map(|p| p.map_or(Vec3A::ZERO, |(point, _)| point.ray_origin()));
    for rank in 0..count.min(MOST) {
        let ray = |i: usize| Some(best[i][rank]).filter(LampCandidate::is_some).map(|c| c.ray(tracer, origins[i]));
        let rays: [Ray; 8] = std::array::from_fn(|i| ray(i).unwrap_or(Ray::NONE));
        let (mut shares, mut asked, mut unknown) = ([0.0; 8], 0u8, 0u8);
        for i in (0..8).filter(|&i| best[i][rank].is_some()) {
            let share = best[i][rank].mapped_share(tracer, &rays[i]);
            shares[i] = share.unwrap_or(1.0);
            unknown |= u8::from(share.is_none()) << i;
            asked |= u8::from(shares[i] > 0.0) << i;
        }
        if asked == 0 {
            continue;
        }
        let mut hidden = if unknown == 0 { 0 } else { tracer.still.accel.occluded8(&rays, unknown) };
        let open = asked & !hidden;
        hidden |= tracer.moving.filter(|_| open != 0).map_or(0, |m| m.accel.occluded8(&rays, open));
        for i in (0..8).filter(|i| (asked & !hidden) >> i & 1 == 1) {
            sums[i] += best[i][rank].lit * shares[i];
        }
    }
    sums
}

/// The lamps whose light on a point is strongest, were nothing in its way, by insertion into a short list.
fn strongest(tracer: &Tracer<'_>, point: &SurfaceInteraction<'_>, bsdf: &Bsdf, count: usize) -> [LampCandidate; MOST] {
    let mut best = [LampCandidate::NONE; MOST];
    let count = count.min(MOST);
    for &lamp in tracer.lamps.indices_near(point.position) {
        let (illuminance, direction) = tracer.lamps.all()[usize::from(lamp)].illuminance_at(point.position);
        if point.geometric_normal.dot(direction) <= 0.0 || illuminance.max_element() <= 0.0 {
            continue;
        }
        let lit = bsdf.lit_by(illuminance, direction, -point.direction);
        let strength = lit.max_element();
        if strength <= best[count - 1].strength {
            continue;
        }
        let mut at = count - 1;
        while at > 0 && best[at - 1].strength < strength {
            best[at] = best[at - 1];
            at -= 1;
        }
        best[at] = LampCandidate { strength, lit, lamp, direction };
    }
    best
}
