//! What the samples of a uniform pixel share of what moving things do to their light, found once at the pixel's centre,
//! for up to eight neighbours at a time.

use super::contact_shadow::contact_shadow;
use super::lamp_mask::lamp_sum;
use super::pixel_centre::PixelCentre;
use super::sweep::beams_on_row;
use super::tile_context::TileContext;
use crate::accel::Ray;
use crate::scene::FrameScene;
use crate::shade::Tracer;
use glam::Vec3A;
use std::cell::LazyCell;

/// Light of a uniform pixel that its samples share.
#[derive(Debug, Clone, Copy)]
pub(super) struct CentreLight {
    /// Vehicle light, fog included.
    pub(super) swept: Vec3A,
    /// Share of the ambient light that objects standing near leave.
    pub(super) contact: f32,
    /// Lamp light, fog included, where something that moves blocks a lamp.
    pub(super) direct: Option<Vec3A>,
}

impl CentreLight {
    const NONE: Self = Self { swept: Vec3A::ZERO, contact: 1.0, direct: None };

    /// Nothing that moves does anything to the light.
    pub(super) fn is_nothing(&self) -> bool {
        self.swept == Vec3A::ZERO && self.contact == 1.0 && self.direct.is_none()
    }
}

/// The light of these pixels, seen from `eye`.
pub(super) fn centre_lights(
    context: &TileContext<'_>,
    eye: Vec3A,
    row: &[Option<PixelCentre<'_>>; 8],
) -> [CentreLight; 8] {
    let TileContext { tracer, frame, work, .. } = *context;
    let mut lights = [CentreLight::NONE; 8];
    if row.iter().all(Option::is_none) {
        return lights;
    }
    // Three exponentials a pixel: most rows need none.
    let transmittance = LazyCell::new(|| {
        let fog = &tracer.environment.fog;
        row.map(|place| place.map_or(0.0, |p| fog.transmittance(eye, p.facet.direction, p.facet.distance)))
    });
    if !work.beams.is_empty() {
        let swept = beams_on_row(tracer, frame, &work.beams, row, &transmittance);
        for (light, swept) in lights.iter_mut().zip(swept) {
            light.swept = swept;
        }
    }
    let blocked = lamps_blocked_row(tracer, frame, &work.lamps, row);
    for (i, light) in lights.iter_mut().enumerate() {
        let Some(PixelCentre { facet, bsdf, lamps_free }) = &row[i] else { continue };
        light.contact = contact_shadow(frame, work, facet);
        light.direct = bsdf
            .filter(|_| blocked[i] != 0)
            .map(|bsdf| lamp_sum(tracer, facet, &bsdf.get(), lamps_free & !blocked[i]) * transmittance[i]);
    }
    lights
}

/// Lamps that something that moves hides from each pixel, a bit each of those near it.
fn lamps_blocked_row(
    tracer: &Tracer<'_>,
    frame: &FrameScene,
    lamps: &[u16],
    row: &[Option<PixelCentre<'_>>; 8],
) -> [u32; 8] {
    let mut blocked = [0u32; 8];
    if lamps.is_empty() {
        return blocked;
    }
    let near: [&[u16]; 8] =
        std::array::from_fn(|i| row[i].map_or(&[][..], |p| tracer.still.lamps.indices_near(p.facet.position)));
    let origins: [Vec3A; 8] = std::array::from_fn(|i| row[i].map_or(Vec3A::ZERO, |p| p.facet.ray_origin()));
    for lamp in lamps {
        let mut bits = [0u8; 8];
        let mut active = 0u8;
        for (i, place) in row.iter().enumerate() {
            let Some(place) = place else { continue };
            if let Ok(bit) = near[i].binary_search(lamp) {
                bits[i] = bit as u8;
                active |= ((place.lamps_free >> bit & 1) as u8) << i;
            }
        }
        if active == 0 {
            continue;
        }
        let position = tracer.still.lamps.all()[usize::from(*lamp)].position;
        let rays = origins.map(|origin| Ray { origin, direction: position - origin, tmax: 0.999 });
        let hidden = frame.accel.occluded8(&rays, active);
        for i in 0..8 {
            blocked[i] |= u32::from(hidden >> i & 1) << bits[i];
        }
    }
    blocked
}
