//! Light of vehicle lamps that sweeps the still town.

use super::affected::Sweep;
use super::centre::Place;
use super::still_sample::{StillSample, still_look};
use crate::accel::Ray;
use crate::light::Beam;
use crate::scene::{FrameScene, SurfacePoint};
use crate::shade::{Tracer, beam_light};
use glam::Vec3A;
use wide::f32x8;

/// Illuminance, dimmed by the air before it, below which a vehicle light is not seen, klx.
const UNSEEN_KLX: f32 = 8.0e-4;

/// Whether a light shows on a still surface, seen through the air from the camera.
fn shows(beam: &Beam, position: Vec3A, transmittance: f32) -> bool {
    beam.illuminance_at(position).0.x * transmittance > UNSEEN_KLX
}

/// Light of vehicle lamps on a still sample, fog included.
pub(super) fn beams_on(
    tracer: &Tracer<'_>,
    frame: &FrameScene,
    beams: &[Sweep],
    still: &StillSample,
    ray: &Ray,
    sample: usize,
    pixel_angle: f32,
) -> Vec3A {
    if still.is_sky() || beams.is_empty() {
        return Vec3A::ZERO;
    }
    let position = ray.origin + ray.direction * still.hit.t;
    let transmittance = tracer.environment.fog.transmittance(ray.origin, ray.direction, still.hit.t);
    let shown = |sweep: &&Sweep| shows(&frame.beams[usize::from(sweep.beam)], position, transmittance);
    let mut lights = beams.iter().filter(shown).peekable();
    if lights.peek().is_none() {
        return Vec3A::ZERO;
    }
    let point = SurfacePoint::new(&tracer.still.instances, ray, &still.hit);
    let look = still_look(&point, tracer.environment, sample, pixel_angle);
    let facet = still.facet(ray);
    let mut sum = Vec3A::ZERO;
    for sweep in lights {
        sum += beam_light(tracer, &frame.beams[usize::from(sweep.beam)], &facet, &look);
    }
    sum * transmittance
}

/// The same for the centres of up to eight neighbouring pixels at once: rays to one lamp are traced together.
pub(super) fn beams_on_row(
    tracer: &Tracer<'_>,
    frame: &FrameScene,
    beams: &[Sweep],
    row: &[Option<Place<'_>>; 8],
    transmittance: &[f32; 8],
) -> [Vec3A; 8] {
    let mut sums = [Vec3A::ZERO; 8];
    let origins: [Vec3A; 8] = std::array::from_fn(|i| row[i].map_or(Vec3A::ZERO, |p| p.facet.ray_origin()));
    let axis = |axis: usize| f32x8::new(std::array::from_fn(|i| row[i].map_or(0.0, |p| p.facet.position[axis])));
    let positions = [axis(0), axis(1), axis(2)];
    for sweep in beams {
        let beam = &frame.beams[usize::from(sweep.beam)];
        let mut active = 0u8;
        let strengths = beam.strengths_at(positions);
        for (i, place) in row.iter().enumerate() {
            let Some(Place { facet, .. }) = place else { continue };
            let lit = strengths[i] * transmittance[i] > UNSEEN_KLX
                && facet.geometric_normal.dot(beam.position - facet.position) > 0.0;
            active |= u8::from(lit) << i;
        }
        if active == 0 {
            continue;
        }
        let rays = origins.map(|origin| beam.shadow_ray(origin));
        if sweep.crossed {
            active &= !frame.accel.occluded8(&rays, active);
        }
        if active != 0 {
            active &= !tracer.still.accel.occluded8(&rays, active);
        }
        for (i, place) in row.iter().enumerate() {
            if let (Some(Place { look: Some(look), facet, .. }), 1) = (place, active >> i & 1) {
                let direction = (beam.position - facet.position).normalize();
                sums[i] += look.lit_by(beam.color() * strengths[i], direction, -facet.direction);
            }
        }
    }
    std::array::from_fn(|i| sums[i] * transmittance[i])
}
