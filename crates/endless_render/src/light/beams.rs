//! Lights that move with vehicles: headlights with a low-beam cut-off, and the red glow behind.

use crate::accel::Ray;
use glam::Vec3A;
use wide::f32x8;

/// A fraction of what street lamps give: less is hardly seen beside them.
const FAINT_KLX: f32 = 4.0e-3;
/// Nothing is lit nearer than this in front of a light, metres.
const NEAREST_M: f32 = 0.05;

/// What kind of light.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BeamKind {
    /// Both headlights of a vehicle as one, low beam.
    Head,
    /// Tail lights.
    Tail,
    /// Tail and brake lights.
    Brake,
}

/// A vehicle's light in the world.
#[derive(Debug, Clone, Copy)]
pub struct VehicleBeam {
    /// Its distribution.
    pub kind: BeamKind,
    /// World frame, metres. Slightly in front of the lenses, so that they do not shadow themselves.
    pub position: Vec3A,
    /// Unit direction that it shines.
    pub forward: Vec3A,
    /// Unit direction to its left.
    pub left: Vec3A,
}

impl VehicleBeam {
    /// Beyond this the light is nothing, metres.
    pub(crate) fn range_m(&self) -> f32 {
        match self.kind {
            BeamKind::Head => 34.0,
            BeamKind::Tail => 5.0,
            BeamKind::Brake => 8.0,
        }
    }

    /// Illuminance of a surface facing the light, klx, and the unit direction to it. Light below [`FAINT_KLX`] is
    /// none; it fades in from there, so that its edge cannot be seen.
    #[inline]
    pub(crate) fn illuminance_at(&self, point: Vec3A) -> (Vec3A, Vec3A) {
        let offset = point - self.position;
        let distance_squared = offset.length_squared().max(0.05);
        let range = self.range_m();
        let ahead = offset.dot(self.forward);
        if distance_squared > range * range || ahead <= NEAREST_M {
            return (Vec3A::ZERO, Vec3A::Z);
        }
        let (aside, up) = (offset.dot(self.left) / ahead, offset.z / ahead);
        let strength =
            self.intensity(aside * aside, up, (-up).max(0.0)) * self.window(distance_squared) / distance_squared;
        let seen = (strength - FAINT_KLX).max(0.0);
        (self.color() * seen, -offset / distance_squared.sqrt())
    }

    /// Strengths of this light at eight points: the illuminance of [`Self::illuminance_at`] in units of its colour.
    #[inline]
    pub(crate) fn strengths_at(&self, [x, y, z]: [f32x8; 3]) -> [f32; 8] {
        let splat = f32x8::splat;
        let offset = [x - splat(self.position.x), y - splat(self.position.y), z - splat(self.position.z)];
        let dot = |a: Vec3A| offset[0] * splat(a.x) + offset[1] * splat(a.y) + offset[2] * splat(a.z);
        let distance_squared = (offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]).max(splat(0.05));
        let range_squared = splat(self.range_m() * self.range_m());
        let ahead = dot(self.forward);
        let reached = distance_squared.simd_le(range_squared) & ahead.simd_gt(splat(NEAREST_M));
        if reached.none() {
            return [0.0; 8];
        }
        let one = f32x8::ONE;
        let window = one - distance_squared / range_squared;
        let (aside, up) = (dot(self.left) / ahead, offset[2] / ahead);
        let lateral = one / (one + aside * aside * splat(9.0));
        let intensity = match self.kind {
            BeamKind::Head => {
                let above = splat(0.03) + splat(0.97) * (one - up / splat(0.03)).max(f32x8::ZERO);
                let vertical = up.simd_gt(f32x8::ZERO).select(above, one);
                let below = (-up).max(f32x8::ZERO);
                splat(14.0) * lateral * lateral * vertical / (one + below * below * splat(60.0))
            }
            BeamKind::Tail => splat(0.02) * lateral,
            BeamKind::Brake => splat(0.10) * lateral,
        };
        let strength = intensity * window * window / distance_squared - splat(FAINT_KLX);
        reached.select(strength.max(f32x8::ZERO), f32x8::ZERO).to_array()
    }

    pub(crate) fn color(&self) -> Vec3A {
        match self.kind {
            BeamKind::Head => Vec3A::new(1.0, 0.94, 0.84),
            BeamKind::Tail | BeamKind::Brake => Vec3A::new(1.0, 0.03, 0.02),
        }
    }

    /// Luminous intensity, kcd, by the squared tangent aside and the tangents up and down from its axis; falls with
    /// each of them. UN ECE R112's low beam in broad strokes: a hot spot just below the horizon, a wide foreground,
    /// little above the cut-off.
    fn intensity(&self, aside_squared: f32, up: f32, below: f32) -> f32 {
        let lateral = 1.0 / (1.0 + aside_squared * 9.0);
        match self.kind {
            BeamKind::Head => {
                let vertical = if up > 0.0 { 0.03 + 0.97 * (1.0 - up / 0.03).max(0.0) } else { 1.0 };
                14.0 * lateral * lateral * vertical / (1.0 + below * below * 60.0)
            }
            BeamKind::Tail => 0.02 * lateral,
            BeamKind::Brake => 0.10 * lateral,
        }
    }

    /// Whether any of its light can reach a box: its strength at the nearest distance and the least angles.
    pub(crate) fn reaches(&self, low: Vec3A, high: Vec3A) -> bool {
        let distance_squared = self.position.clamp(low, high).distance_squared(self.position).max(0.05);
        if distance_squared >= self.range_m() * self.range_m() {
            return false;
        }
        // Extent of the box along an axis, from the light.
        let extent = |axis: Vec3A| {
            let (centre, half) = ((low + high) * 0.5 - self.position, (high - low) * 0.5);
            let (middle, radius) = (centre.dot(axis), half.dot(axis.abs()));
            (middle - radius, middle + radius)
        };
        let (_, ahead) = extent(self.forward);
        if ahead <= NEAREST_M {
            return false;
        }
        let (right, left) = extent(self.left);
        let (bottom, top) = extent(Vec3A::Z);
        let aside = right.max(-left).max(0.0) / ahead;
        let (up, below) = (bottom.max(0.0) / ahead, (-top).max(0.0) / ahead);
        let strength = self.intensity(aside * aside, up, below) * self.window(distance_squared) / distance_squared;
        strength * 1.001 > FAINT_KLX
    }

    /// Fades the light out towards the end of its range.
    fn window(&self, distance_squared: f32) -> f32 {
        let q = distance_squared / (self.range_m() * self.range_m());
        (1.0 - q) * (1.0 - q)
    }

    /// The ray that must be free for its light to reach a point.
    pub(crate) fn shadow_ray(&self, origin: Vec3A) -> Ray {
        Ray::to_light(origin, self.position)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn what_is_lit_is_reached(x in -10.0f32..45.0, y in -30.0f32..30.0, z in -2.0f32..6.0, turn in 0.0f32..6.2, size in 0.0f32..3.0, brake: bool) {
            let forward = Vec3A::new(endless_world::math::cos(turn), endless_world::math::sin(turn), 0.0);
            let left = Vec3A::new(-forward.y, forward.x, 0.0);
            let kind = if brake { BeamKind::Brake } else { BeamKind::Head };
            let beam = VehicleBeam { kind, position: Vec3A::new(0.0, 0.0, 0.7), forward, left };
            let point = Vec3A::new(x, y, z);
            prop_assert!(beam.illuminance_at(point).0 == Vec3A::ZERO || beam.reaches(point - size, point + size * 0.3));
            let one = beam.illuminance_at(point).0.x;
            let eight = beam.strengths_at([x, y, z].map(f32x8::splat));
            prop_assert!(eight.iter().all(|s| (s - one).abs() <= 1e-4 * one.max(0.01)), "{} {}", eight[0], one);
        }
    }

    #[test]
    fn low_beam_lights_the_road_not_the_sky() {
        let beam = VehicleBeam {
            kind: BeamKind::Head,
            position: Vec3A::new(0.0, 0.0, 0.7),
            forward: Vec3A::X,
            left: Vec3A::Y,
        };
        let at = |x: f32, y: f32, z: f32| beam.illuminance_at(Vec3A::new(x, y, z)).0.x;
        assert!(at(20.0, 0.0, 0.0) > 5.0 * at(20.0, 0.0, 3.0));
        assert!(at(10.0, 0.0, 0.0) > at(10.0, 8.0, 0.0));
        assert_eq!(at(-5.0, 0.0, 0.0), 0.0);
        assert_eq!(at(60.0, 0.0, 0.5), 0.0);
        assert!(beam.reaches(Vec3A::new(10.0, -1.0, 0.0), Vec3A::new(12.0, 1.0, 1.0)));
        assert!(!beam.reaches(Vec3A::new(-12.0, -1.0, 0.0), Vec3A::new(-10.0, 1.0, 1.0)));
    }
}
