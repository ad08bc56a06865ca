//! Irradiance of the still picture's samples, gathered by rays over their hemispheres.
//!
//! Pixels take turns at a few patterns of rays (interleaved sampling; Keller and Heidrich 2001): those that share one
//! send their rays side by side, and the denoiser mixes neighbours, which have different ones.

use super::hit_tape::HitTape;
use crate::accel::Ray;
use crate::light::Environment;
use crate::material::noise;
use crate::sampling::{cosine_direction, hammersley, rotated};
use crate::scene::ShadingPoint;
use crate::shade::{Tracer, shade_hit8};
use glam::{Vec2, Vec3A};
use std::f32::consts::PI;

/// Brightest single contribution, in units of the mean sky: keeps rare bright hits from spotting the picture.
const CLAMP: f32 = 12.0;
/// Patterns repeat after this many points along and down.
pub(crate) const PATTERN_SIDE: usize = 8;
const PATTERNS: usize = PATTERN_SIDE * PATTERN_SIDE;

/// How the pattern of rays of a point is turned; points `PATTERN_SIDE` apart share it.
pub(crate) fn turn(x: usize, y: usize, pattern: u32) -> Vec2 {
    let place = (y % PATTERN_SIDE) * PATTERN_SIDE + x % PATTERN_SIDE;
    // An odd factor scatters the turns of neighbours over the square.
    let (index, count) = (place * 37 % PATTERNS, PATTERNS);
    let shift = Vec2::new(noise::cell1(pattern, 11), noise::cell1(pattern, 12));
    rotated(hammersley(index as u32, count as u32), shift)
}

/// The most that one ray may bring, kcd/m²: lenses of lamps, whose light is counted without them, are met by few rays and
/// would be grain.
pub(super) fn brightest(environment: &Environment) -> f32 {
    (environment.sky.mean.max_element() * CLAMP).max(0.05)
}

/// A point where light is gathered.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GatherPoint {
    pub(crate) facet: ShadingPoint,
    /// Unit, interpolated, on the side that it is seen from.
    pub(crate) normal: Vec3A,
}

/// Illuminance from everything but the sun's disc and the lamps, klx, of up to eight points whose patterns are turned
/// alike; noisy, to be denoised. The tape tells where the rays end.
pub(crate) fn gather8(
    tracer: &Tracer<'_>,
    tape: &mut HitTape<'_>,
    points: &[Option<GatherPoint>; 8],
    turn: Vec2,
    rays: u32,
) -> [Vec3A; 8] {
    let active = points.iter().enumerate().fold(0u8, |bits, (i, point)| bits | u8::from(point.is_some()) << i);
    let limit = brightest(tracer.environment);
    let mut sums = [Vec3A::ZERO; 8];
    if active == 0 {
        return sums;
    }
    for k in 0..rays {
        let u = rotated(hammersley(k, rays), turn);
        let towards = std::array::from_fn(|i| match &points[i] {
            Some(point) => Ray { origin: point.facet.ray_origin(), direction: above(point, u), tmax: f32::MAX },
            None => Ray::NONE,
        });
        let struck = tape.closest8(tracer, &towards, active);
        for (sum, light) in sums.iter_mut().zip(shade_hit8(tracer, &towards, &struck, active, &[0.5; 8])) {
            *sum += light.min(Vec3A::splat(limit));
        }
    }
    sums.map(|sum| sum * (PI / rays as f32))
}

/// A direction of the cosine lobe around a point's normal, bent up where it would enter the surface.
fn above(point: &GatherPoint, u: Vec2) -> Vec3A {
    let direction = cosine_direction(point.normal, u);
    let below = direction.dot(point.facet.geometric_normal);
    if below < 0.01 { (direction + point.facet.geometric_normal * (0.01 - below)).normalize() } else { direction }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_have_other_patterns_and_those_farther_on_the_same() {
        let mut all = Vec::new();
        for y in 0..PATTERN_SIDE {
            for x in 0..PATTERN_SIDE {
                assert_eq!(turn(x, y, 5), turn(x + PATTERN_SIDE, y + 2 * PATTERN_SIDE, 5));
                all.push(turn(x, y, 5));
            }
        }
        for (i, a) in all.iter().enumerate() {
            assert!(all[i + 1..].iter().all(|b| a.distance(*b) > 1e-3));
        }
    }
}
