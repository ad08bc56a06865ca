//! The still picture: what the pixels of a row show while nothing moves.

use super::gbuffer_row::GBufferRow;
use super::gbuffer_sample::GBufferSample;
use super::primary_hits::PrimaryRow;
use super::still_pixel::sun_share;
use crate::light::Environment;
use crate::rgb9e5::Rgb9e5;
use crate::sampling::SAMPLES;
use crate::vec3x8::{Vec3x8, lane_of};
use glam::Vec3A;
use wide::f32x8;

impl GBufferRow {
    /// Mean radiance of all pixels, kcd/m²: those of [`StillPixel::radiance`](super::still_pixel::StillPixel::radiance).
    pub(super) fn radiance(&self, environment: &Environment, primary: PrimaryRow<'_>, radiance: &mut [Vec3A]) {
        for (k, radiance) in radiance.chunks_mut(8).enumerate() {
            let first = 8 * k;
            if let Some((samples, sun_free)) = self.plain_eight(first).zip(primary.sun_free[first..].first_chunk()) {
                let eight = plain_radiance(environment, samples, sun_free);
                radiance.iter_mut().enumerate().for_each(|(i, radiance)| *radiance = lane_of(&eight, i));
                continue;
            }
            for (x, radiance) in (first..).zip(radiance) {
                let seen = primary.pixel(x);
                *radiance = self.pixel(x, seen.distances, seen.sun_free, seen.uniform).radiance(environment);
            }
        }
    }
}

/// Of eight pixels that one sample each tells, and of whose samples it is known which directions to the sun are free.
fn plain_radiance(environment: &Environment, samples: &[GBufferSample; 8], free: &[[u8; SAMPLES]; 8]) -> Vec3x8 {
    let unpacked = |of: fn(&GBufferSample) -> Rgb9e5| Rgb9e5::unpack8(&samples.each_ref().map(of));
    let (rest, ambient, direct) = (unpacked(|s| s.rest), unpacked(|s| s.ambient), unpacked(|s| s.direct));
    let shares: [f32x8; SAMPLES] =
        std::array::from_fn(|s| f32x8::new(free.map(|free| sun_share(environment, free[s]))));
    std::array::from_fn(|k| {
        let soft = rest[k] + ambient[k];
        let sum = shares.iter().fold(f32x8::ZERO, |sum, &share| sum + (soft + direct[k] * share));
        sum / f32x8::splat(SAMPLES as f32)
    })
}
