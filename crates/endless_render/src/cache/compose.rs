//! The radiance of a static sample while objects move.

use super::centre_light::CentreLight;
use super::contact_shadow::contact_shadow;
use super::gbuffer_shading::gbuffer_bsdf;
use super::lamp_mask::{lamp_sum, lamps_blocked};
use super::still_pixel::{StillPixel, sun_share};
use super::tile_context::TileContext;
use crate::accel::Ray;
use crate::scene::SurfaceInteraction;
use crate::shade::lens_light;
use glam::Vec3A;

/// Radiance of one of a still pixel's samples, without vehicle lights. `centre` is what is known from the pixel's centre, `sun_free` and
/// `mirrored` what rays towards what moves found.
pub(super) fn compose(
    context: &TileContext<'_>,
    centre: Option<&CentreLight>,
    still: &StillPixel<'_>,
    (sun_free, mirrored): (u8, Option<Vec3A>),
    ray: &Ray,
    sample: usize,
) -> Vec3A {
    let TileContext { tracer, frame, work, pixel_angle } = *context;
    let kept = still.sample(sample);
    let Some(hit) = still.hit(sample) else { return kept.rest.get() };
    let environment = tracer.environment;
    let mut contact = centre.map_or(1.0, |c| c.contact);
    let mut direct = centre.and_then(|c| c.direct);
    let point = || SurfaceInteraction::new(&tracer.still.instances, ray, &hit);
    let transmittance = || environment.fog.transmittance(ray.origin, ray.direction, hit.t);
    if centre.is_none() && !(work.contacts.is_empty() && work.lamps.is_empty()) {
        let facet = still.facet(ray, sample);
        contact = contact_shadow(frame, work, &facet);
        let blocked = lamps_blocked(tracer, frame, &work.lamps, &facet, kept.lamps_free);
        if blocked != 0 {
            let bsdf = gbuffer_bsdf(&point(), environment, sample, pixel_angle);
            let light = lamp_sum(tracer, &facet, &bsdf, kept.lamps_free & !blocked);
            direct = Some(light * transmittance());
        }
    }
    let mirror = mirrored.or_else(|| Some(still.mirror(sample)?.light.get())).unwrap_or(Vec3A::ZERO);
    let signal = if work.lens && still.is_lens(sample) {
        lens_light(frame, &point(), environment.night) * transmittance()
    } else {
        Vec3A::ZERO
    };
    let direct = direct.unwrap_or_else(|| kept.direct.get()) * sun_share(environment, sun_free);
    kept.rest.get() + kept.ambient.get() * contact + direct + mirror + signal
}
