//! The radiance of a still sample in a world where things move.

use super::affected::Work;
use super::centre::CentreLight;
use super::contact::contact_left;
use super::still_sample::{StillSample, lamp_sum, lamps_blocked, still_look, sun_share};
use crate::accel::Ray;
use crate::scene::{Facet, FrameScene, SurfacePoint};
use crate::shade::Tracer;
use endless_scene::{LensAspect, Surface};
use endless_world::SignalAspect;
use glam::Vec3A;

/// Radiance of a still sample, without vehicle lights. `tracer.moving` must be set; `work` says what can matter,
/// `centre` what is known from the pixel's centre, `sun_free` and `mirrored` what rays towards what
/// moves found.
pub(super) fn compose(
    tracer: &Tracer<'_>,
    frame: &FrameScene,
    work: &Work,
    centre: Option<&CentreLight>,
    still: &StillSample,
    (sun_free, mirrored): (u8, Option<Vec3A>),
    ray: &Ray,
    sample: usize,
    pixel_angle: f32,
) -> Vec3A {
    if still.is_sky() {
        return Vec3A::from(still.rest);
    }
    let environment = tracer.environment;
    let mut contact = centre.map_or(1.0, |c| c.contact);
    let mut direct = centre.and_then(|c| c.direct);
    let point = || SurfacePoint::new(&tracer.still.instances, ray, &still.hit);
    let transmittance = || environment.fog.transmittance(ray.origin, ray.direction, still.hit.t);
    if centre.is_none() && !(work.contacts.is_empty() && work.lamps.is_empty()) {
        let facet = still.facet(ray);
        contact = contact_left(frame, work, &facet);
        let blocked = lamps_blocked(tracer, frame, &work.lamps, &facet, still.lamps_free);
        if blocked != 0 {
            let look = still_look(&point(), environment, sample, pixel_angle);
            let light = lamp_sum(tracer, &facet, &look, still.lamps_free & !blocked);
            direct = Some(light * transmittance());
        }
    }
    let mirror = mirrored.unwrap_or(Vec3A::from(still.mirror));
    let signal = if work.lens && still.flags & StillSample::LENS != 0 {
        lens_light(frame, &point(), environment.night) * transmittance()
    } else {
        Vec3A::ZERO
    };
    let direct = direct.unwrap_or(Vec3A::from(still.direct)) * sun_share(environment, sun_free);
    Vec3A::from(still.rest) + Vec3A::from(still.ambient) * contact + direct + mirror + signal
}

/// Where rays to the sun start: leaves lit from behind let light through, so theirs start on the far side.
pub(super) fn sun_origin(facet: &Facet, sun: Vec3A) -> Vec3A {
    let origin = facet.ray_origin();
    if facet.geometric_normal.dot(sun) < 0.0 { facet.position * 2.0 - origin } else { origin }
}

/// Whether the sun can light a point at all: from the front, or through a leaf.
pub(super) fn sun_can_light(point: &SurfacePoint<'_>, sun: Vec3A) -> bool {
    point.geometric_normal.dot(sun) > 0.0 || point.material.surface == Surface::Foliage
}

/// Light of a traffic light's lens in the state that its group is in.
fn lens_light(frame: &FrameScene, point: &SurfacePoint<'_>, night: bool) -> Vec3A {
    let (Surface::SignalLens(lens), Some(signal)) = (point.material.surface, point.instance.signal) else {
        return Vec3A::ZERO;
    };
    let Some(aspect) = frame.signals.get(usize::from(signal.0)) else { return Vec3A::ZERO };
    let lit = match lens {
        LensAspect::Red => matches!(aspect, SignalAspect::Red | SignalAspect::RedYellow),
        LensAspect::Yellow => matches!(aspect, SignalAspect::Yellow | SignalAspect::RedYellow),
        LensAspect::Green => matches!(aspect, SignalAspect::Green),
    };
    if !lit {
        return Vec3A::ZERO;
    }
    let color = match lens {
        LensAspect::Red => Vec3A::new(1.0, 0.04, 0.02),
        LensAspect::Yellow => Vec3A::new(1.0, 0.46, 0.02),
        LensAspect::Green => Vec3A::new(0.02, 1.0, 0.42),
    };
    color * if night { 0.3 } else { 11.0 }
}
