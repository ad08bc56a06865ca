//! The layer that tells which pixels the sun does not reach. Its rays are those of the picture, so that both agree.

use super::bake::CameraBake;
use super::bake_pass::BakePass;
use super::moving_centre::MovingCentre;
use super::moving_hits::MovingHits;
use super::primary_hits::PrimaryPixel;
use super::still_pixel::StillPixel;
use crate::accel::{Ray, RayStream};
use crate::light::{Environment, SUN_SAMPLES};
use crate::sampling::SAMPLES;
use crate::scene::{FrameScene, StaticScene, SurfaceInteraction};

/// No part of the sun's disc is seen.
const DARK: u8 = 255;
/// Rays that are traced together.
const RAYS: usize = 32;

impl BakePass<'_> {
    /// The shadow of what stands still where nothing moves.
    pub(super) fn still_shadow(&self, primary: &PrimaryPixel<'_>) -> u8 {
        if primary.distances[0] == f32::MAX {
            return 0;
        }
        share(self.tracer.environment, primary.sun_free, primary.uniform, |_| false)
    }
}

/// The share of the directions to the sun that are not free. The samples of a uniform pixel lie on one surface, so all of
/// them tell it but those that are left out; otherwise the centre does.
fn share(environment: &Environment, free: &[u8; SAMPLES], uniform: bool, left_out: impl Fn(usize) -> bool) -> u8 {
    if environment.sun.is_none() {
        return 0;
    }
    let told_by = |sample: &usize| *sample == 0 || uniform && !left_out(*sample);
    let (mut all, mut seen) = (0, 0);
    for sample in (0..SAMPLES).filter(told_by) {
        all += SUN_SAMPLES as u32;
        seen += free[sample].count_ones();
    }
    ((all - seen) * u32::from(DARK) / all) as u8
}

impl CameraBake {
    /// The shadow of what stands still while things move; of no use where one of them covers the centre.
    pub(super) fn shadow(&self, still: &StillPixel<'_>, found: &MovingHits) -> u8 {
        if !self.wanted.shadow || still.is_sky(0) {
            return 0;
        }
        let free = std::array::from_fn(|s| still.sun_free[s] & !found.sun_blocked[s]);
        share(&self.lighting.environment, &free, still.uniform, |s| found.primary[s].is_some())
    }

    /// The ray to the sun of a point on what moves, as the picture asks it, if shadows are wanted.
    pub(super) fn sun_ray(&self, point: &SurfaceInteraction<'_>) -> Option<Ray> {
        self.lighting.environment.sun.as_ref().filter(|_| self.wanted.shadow)?.ray_from(point)
    }

    /// The shadow on what moves, if it is wanted and the sun shines: of each of these centres.
    pub(super) fn moving_shadows(
        &self,
        still: &StaticScene,
        frame: &FrameScene,
        centres: &[MovingCentre],
    ) -> Option<Vec<u8>> {
        self.lighting.environment.sun.as_ref().filter(|_| self.wanted.shadow)?;
        let tracer = self.lighting.tracer(still, Some(frame));
        let mut shadows = Vec::with_capacity(centres.len());
        for centres in centres.chunks(RAYS) {
            let (mut rays, mut asked) = (RayStream::<4>::NONE, 0u32);
            for (lane, ray) in centres.iter().enumerate().filter_map(|(lane, centre)| Some((lane, centre.to_sun?))) {
                rays.set(lane, &ray);
                asked |= 1 << lane;
            }
            let lit = asked & !tracer.occluded32(&rays, asked);
            shadows.extend((0..centres.len()).map(|lane| if lit >> lane & 1 == 1 { 0 } else { DARK }));
        }
        Some(shadows)
    }
}
