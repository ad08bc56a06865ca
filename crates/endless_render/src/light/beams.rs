//! Lights that move with vehicles: headlights with a low-beam cut-off, and the red glow behind.

use crate::accel::Ray;
use glam::Vec3A;

/// What kind of light.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BeamKind {
    /// Both headlights of a vehicle as one, low beam.
    Head,
    /// Tail lights.
    Tail,
    /// Tail and brake lights.
    Brake,
}

/// A vehicle's light in the world.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Beam {
    pub(crate) kind: BeamKind,
    /// Slightly in front of the lenses, so that they do not shadow themselves.
    pub(crate) position: Vec3A,
    /// Horizontal direction that it shines.
    pub(crate) forward: Vec3A,
    pub(crate) left: Vec3A,
}

impl Beam {
    /// Beyond this the light is nothing, metres.
    pub(crate) fn range_m(&self) -> f32 {
        match self.kind {
            BeamKind::Head => 45.0,
            BeamKind::Tail => 5.0,
            BeamKind::Brake => 8.0,
        }
    }

    /// Illuminance of a surface facing the light, klx, and the unit direction to it.
    #[inline]
    pub(crate) fn illuminance_at(&self, point: Vec3A) -> (Vec3A, Vec3A) {
        let offset = point - self.position;
        let distance_squared = offset.length_squared().max(0.05);
        let range = self.range_m();
        let ahead = offset.dot(self.forward);
        if distance_squared > range * range || ahead <= 0.05 {
            return (Vec3A::ZERO, Vec3A::Z);
        }
        let distance = distance_squared.sqrt();
        let q = distance_squared / (range * range);
        let window = (1.0 - q) * (1.0 - q);
        let direction = -offset / distance;
        let intensity = match self.kind {
            BeamKind::Head => {
                // Tangents of the angles aside and up; UN ECE R112's pattern in broad strokes: hot spot just below
                // the horizon, wide foreground, little above the cut-off.
                let aside = offset.dot(self.left) / ahead;
                let up = offset.z / ahead;
                let lateral = 1.0 / (1.0 + (aside * aside) * 9.0);
                let below = (-up).max(0.0);
                let vertical = if up > 0.0 { 0.03 + 0.97 * (1.0 - up / 0.03).max(0.0) } else { 1.0 };
                let spread = 1.0 / (1.0 + below * below * 60.0);
                Vec3A::new(1.0, 0.94, 0.84) * (14.0 * lateral * lateral * vertical * spread)
            }
            BeamKind::Tail => Vec3A::new(0.02, 0.0006, 0.0004) * (ahead / distance),
            BeamKind::Brake => Vec3A::new(0.10, 0.003, 0.002) * (ahead / distance),
        };
        (intensity * (window / distance_squared), direction)
    }

    /// Whether any of its light can reach a box.
    pub(crate) fn reaches(&self, low: Vec3A, high: Vec3A) -> bool {
        let nearest = self.position.clamp(low, high);
        if nearest.distance_squared(self.position) > self.range_m() * self.range_m() {
            return false;
        }
        // Some corner of the box must lie ahead.
        let corner = Vec3A::select(self.forward.cmpge(Vec3A::ZERO), high, low);
        (corner - self.position).dot(self.forward) > 0.0
    }

    /// The ray that must be free for its light to reach a point.
    pub(crate) fn shadow_ray(&self, origin: Vec3A) -> Ray {
        Ray { origin, direction: self.position - origin, tmax: 0.999 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn low_beam_lights_the_road_not_the_sky() {
        let beam =
            Beam { kind: BeamKind::Head, position: Vec3A::new(0.0, 0.0, 0.7), forward: Vec3A::X, left: Vec3A::Y };
        let at = |x: f32, y: f32, z: f32| beam.illuminance_at(Vec3A::new(x, y, z)).0.x;
        assert!(at(20.0, 0.0, 0.0) > 10.0 * at(20.0, 0.0, 3.0));
        assert!(at(10.0, 0.0, 0.0) > at(10.0, 8.0, 0.0));
        assert_eq!(at(-5.0, 0.0, 0.0), 0.0);
        assert_eq!(at(60.0, 0.0, 0.5), 0.0);
        assert!(beam.reaches(Vec3A::new(10.0, -1.0, 0.0), Vec3A::new(12.0, 1.0, 1.0)));
        assert!(!beam.reaches(Vec3A::new(-12.0, -1.0, 0.0), Vec3A::new(-10.0, 1.0, 1.0)));
    }
}
