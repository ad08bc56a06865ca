//! Light of vehicle lamps that sweeps the still town.

use super::still_sample::{StillSample, still_look};
use crate::accel::Ray;
use crate::light::Beam;
use crate::material::Look;
use crate::scene::{FrameScene, SurfacePoint};
use crate::shade::{Tracer, beam_light};
use glam::Vec3A;

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
    beams: &[u16],
    still: &StillSample,
    ray: &Ray,
    sample: usize,
    pixel_angle: f32,
) -> Vec3A {
    if still.is_sky() || beams.is_empty() {
        return Vec3A::ZERO;
    }
    let position = ray.origin + ray.direction * still.hit.t;
    let transmittance = tracer.environment.fog.transmittance(still.hit.t);
    let shown = |i: &&u16| shows(&frame.beams[usize::from(**i)], position, transmittance);
    let mut lights = beams.iter().filter(shown).peekable();
    if lights.peek().is_none() {
        return Vec3A::ZERO;
    }
    let point = SurfacePoint::new(&tracer.still.instances, ray, &still.hit);
    let look = still_look(&point, tracer.environment, sample, pixel_angle);
    let origin = point.ray_origin();
    let mut sum = Vec3A::ZERO;
    for &i in lights {
        sum += beam_light(tracer, &frame.beams[usize::from(i)], &point, &look, origin);
    }
    sum * transmittance
}

/// A uniform pixel's centre.
#[derive(Clone, Copy)]
pub(super) struct Centre<'a> {
    pub(super) still: &'a StillSample,
    pub(super) ray: Ray,
    pub(super) look: &'a Look,
}

/// The same for the centres of up to eight neighbouring pixels at once: rays to one lamp are traced together. Gives
/// each the bits that [`beams_on`] would.
pub(super) fn beams_on_row(
    tracer: &Tracer<'_>,
    frame: &FrameScene,
    beams: &[u16],
    row: &[Option<Centre<'_>>; 8],
) -> [Vec3A; 8] {
    let mut sums = [Vec3A::ZERO; 8];
    let mut transmittance = [0.0f32; 8];
    let points: [Option<SurfacePoint<'_>>; 8] = std::array::from_fn(|i| {
        let centre = row[i].as_ref().filter(|c| !c.still.is_sky())?;
        transmittance[i] = tracer.environment.fog.transmittance(centre.still.hit.t);
        Some(SurfacePoint::new(&tracer.still.instances, &centre.ray, &centre.still.hit))
    });
    let origins: [Vec3A; 8] = std::array::from_fn(|i| points[i].as_ref().map_or(Vec3A::ZERO, SurfacePoint::ray_origin));
    for &b in beams {
        let beam = &frame.beams[usize::from(b)];
        let mut active = 0u8;
        for (i, point) in points.iter().enumerate() {
            let Some(point) = point else { continue };
            let (_, direction) = beam.illuminance_at(point.position);
            let lit = shows(beam, point.position, transmittance[i]) && point.geometric_normal.dot(direction) > 0.0;
            active |= u8::from(lit) << i;
        }
        if active == 0 {
            continue;
        }
        let rays = origins.map(|origin| beam.shadow_ray(origin));
        active &= !frame.accel.occluded8(&rays, active);
        if active != 0 {
            active &= !tracer.still.accel.occluded8(&rays, active);
        }
        for (i, point) in points.iter().enumerate() {
            if let (Some(point), Some(centre), 1) = (point, &row[i], active >> i & 1) {
                let (illuminance, direction) = beam.illuminance_at(point.position);
                sums[i] += centre.look.lit_by(illuminance, direction, -point.direction);
            }
        }
    }
    std::array::from_fn(|i| sums[i] * transmittance[i])
}
