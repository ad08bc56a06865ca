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
    if still.is_sky(sample) {
        return kept.rest.get();
    }
    let environment = tracer.environment;
    let mut contact = centre.map_or(1.0, |c| c.contact);
    let mut direct = centre.and_then(|c| c.direct);
    let point = || Some(SurfaceInteraction::new(&tracer.still.instances, ray, &still.hit(sample)?));
    let transmittance = || environment.fog.transmittance(ray.origin, ray.direction, still.distances[sample]);
    if centre.is_none() && !(work.contacts.is_empty() && work.lamps.is_empty()) {
        let facet = still.facet(ray, sample);
        contact = contact_shadow(frame, work, &facet);
        let lamps_free = still.lamps_free(sample);
        let blocked = lamps_blocked(tracer, frame, &work.lamps, &facet, lamps_free);
        if let Some(point) = (blocked != 0).then(point).flatten() {
            let bsdf = gbuffer_bsdf(&point, environment, sample, pixel_angle);
            let light = lamp_sum(tracer, &facet, &bsdf, lamps_free & !blocked);
            direct = Some(light * transmittance());
        }
    }
    let mirror = mirrored.or_else(|| Some(still.mirror(sample)?.light.get())).unwrap_or(Vec3A::ZERO);
    let lens = (work.lens && still.is_lens(sample)).then(point).flatten();
    let signal = lens.map_or(Vec3A::ZERO, |lens| lens_light(frame, &lens, environment.night) * transmittance());
    let direct = direct.unwrap_or_else(|| kept.direct.get()) * sun_share(environment, sun_free);
    kept.rest.get() + kept.ambient.get() * contact + direct + mirror + signal
}
