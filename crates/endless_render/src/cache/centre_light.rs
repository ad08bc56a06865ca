//! What the samples of a uniform pixel share of what moving things do to their light, found once at the pixel's centre,
//! for half a tile of neighbours at a time.

use super::contact_shadow::contact_shadow;
use super::lamp_mask::lamp_sum;
use super::pixel_centre::{BLOCK, CentreBlock, PixelCentre};
use super::sweep::beams_on_block;
use super::tile_context::TileContext;
use crate::accel::{Ray, RayStream, lanes};
use crate::scene::FrameScene;
use crate::shade::Tracer;
use endless_world::PinholeCamera;
use glam::Vec3A;

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

/// The light of these pixels, as a camera sees them.
pub(super) fn centre_lights(
    context: &TileContext<'_>,
    camera: &PinholeCamera,
    block: &CentreBlock<'_>,
) -> [CentreLight; BLOCK] {
    let TileContext { tracer, frame, work, .. } = *context;
    let mut lights = [CentreLight::NONE; BLOCK];
    if block.iter().all(Option::is_none) {
        return lights;
    }
    let origins = ray_origins(block);
    if !work.beams.is_empty() {
        let swept = beams_on_block(tracer, frame, &work.beams, camera, block, &origins);
        for (light, swept) in lights.iter_mut().zip(swept) {
            light.swept = swept;
        }
    }
    let blocked = lamps_blocked_block(tracer, frame, &work.lamps, block, origins);
    for (i, light) in lights.iter_mut().enumerate() {
        let Some(PixelCentre { facet, bsdf, lamps_free }) = &block[i] else { continue };
        light.contact = contact_shadow(frame, work, facet);
        light.direct = bsdf.filter(|_| blocked[i] != 0).map(|bsdf| {
            let eye = camera.eye_for(facet.position.into());
            let transmittance = tracer.environment.fog.transmittance(eye.into(), facet.direction, facet.distance);
            lamp_sum(tracer, facet, &bsdf.get(), lamps_free & !blocked[i]) * transmittance
        });
    }
    lights
}

/// Rays that leave the pixels' surfaces, still without an aim.
fn ray_origins(block: &CentreBlock<'_>) -> RayStream<4> {
    let mut rays = RayStream::NONE;
    for (lane, place) in block.iter().enumerate() {
        let Some(place) = place else { continue };
        rays.set(lane, &Ray { origin: place.facet.ray_origin(), ..Ray::NONE });
    }
    rays
}

/// Lamps that something that moves hides from each pixel, a bit each of those near it.
fn lamps_blocked_block(
    tracer: &Tracer<'_>,
    frame: &FrameScene,
    lamps: &[u16],
    block: &CentreBlock<'_>,
    mut rays: RayStream<4>,
) -> [u32; BLOCK] {
    let mut blocked = [0u32; BLOCK];
    if lamps.is_empty() {
        return blocked;
    }
    let near = block.map(|place| place.map_or(&[][..], |p| tracer.lamps.indices_near(p.facet.position)));
    for lamp in lamps {
        let mut bits = [0u8; BLOCK];
        let mut active = 0u32;
        for (i, place) in block.iter().enumerate() {
            let Some(place) = place else { continue };
            if let Ok(bit) = near[i].binary_search(lamp) {
                bits[i] = bit as u8;
                active |= (place.lamps_free >> bit & 1) << i;
            }
        }
        if active == 0 {
            continue;
        }
        rays.aim_at(tracer.lamps.all()[usize::from(*lamp)].position);
        for i in lanes(frame.accel.occluded32(&rays, active)) {
            blocked[i] |= 1 << bits[i];
        }
    }
    blocked
}
