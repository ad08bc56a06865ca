//! A curve in the world as a chain of segments, parametrised by arc length.

use endless_world::math::f64::atan2;
use glam::{DVec2, DVec3};

/// A chain of at least two points with its arc length.
#[derive(Debug, Clone, PartialEq)]
pub struct Polyline {
    points: Vec<DVec3>,
    /// Arc length at each point, metres; starts at 0.
    s: Vec<f64>,
}

/// A point of a polyline, with the line's direction there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PolylinePoint {
    /// Position in the world.
    pub position: DVec3,
    /// Counter-clockwise from east, radians.
    pub heading_rad: f64,
    /// Rise over run of the line here.
    pub grade: f64,
}

impl Polyline {
    /// Through these points; points closer than 1 mm to the one before are dropped.
    ///
    /// # Panics
    /// If fewer than two distinct points are left.
    pub fn new(points: impl IntoIterator<Item = DVec3>) -> Self {
        let mut kept: Vec<DVec3> = Vec::new();
        for p in points {
            if kept.last().is_none_or(|last| last.distance(p) > 1e-3) {
                kept.push(p);
            }
        }
        assert!(kept.len() >= 2, "a line needs two distinct points");
        let mut s = vec![0.0];
        for pair in kept.windows(2) {
            s.push(s[s.len() - 1] + pair[0].distance(pair[1]));
        }
        Self { points: kept, s }
    }

    /// The points.
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// Arc length at a point, metres.
    ///
    /// # Panics
    /// If there are fewer points.
    pub fn station(&self, point: usize) -> f64 {
        self.s[point]
    }

    /// Metres.
    pub fn length(&self) -> f64 {
        self.s[self.s.len() - 1]
    }

    /// The place at arc length `s`, clamped to the ends. Heading is interpolated between segment mid-points, so that
    /// what drives along turns smoothly.
    pub fn at(&self, s: f64) -> PolylinePoint {
        let s = s.clamp(0.0, self.length());
        let i = self.segment_of(s);
        let (a, b) = (self.points[i], self.points[i + 1]);
        let span = self.s[i + 1] - self.s[i];
        let t = (s - self.s[i]) / span;
        let direction = |k: usize| (self.points[k + 1] - self.points[k]).normalize();
        let here = direction(i);
        // Blend with the neighbouring segment towards the nearer end.
        let blended = if t < 0.5 && i > 0 {
            direction(i - 1).lerp(here, 0.5 + t)
        } else if t > 0.5 && i + 2 < self.points.len() {
            here.lerp(direction(i + 1), t - 0.5)
        } else {
            here
        };
        PolylinePoint {
            position: a.lerp(b, t),
            heading_rad: atan2(blended.y, blended.x),
            grade: blended.z / blended.truncate().length().max(1e-9),
        }
    }

    /// The position at arc length `s`, clamped to the ends: [`Self::at`] without the direction.
    pub fn position(&self, s: f64) -> DVec3 {
        let s = s.clamp(0.0, self.length());
        let i = self.segment_of(s);
        self.points[i].lerp(self.points[i + 1], (s - self.s[i]) / (self.s[i + 1] - self.s[i]))
    }

    /// The direction of the segment at arc length `s`, seen from above; a unit vector.
    pub fn direction(&self, s: f64) -> DVec2 {
        let i = self.segment_of(s.clamp(0.0, self.length()));
        (self.points[i + 1] - self.points[i]).truncate().normalize_or(DVec2::X)
    }

    /// Arc length of the nearest point, seen from above, and the signed distance to it (`t`, positive to the left).
    pub fn project(&self, point: DVec2) -> (f64, f64) {
        let mut best = (f64::INFINITY, 0.0, 0.0);
        for (i, pair) in self.points.windows(2).enumerate() {
            let (a, b) = (pair[0].truncate(), pair[1].truncate());
            let along = b - a;
            let t = ((point - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
            let offset = point - (a + along * t);
            let distance = offset.length_squared();
            if distance < best.0 {
                let side = along.perp_dot(offset).signum();
                best = (distance, self.s[i] + t * (self.s[i + 1] - self.s[i]), side * distance.sqrt());
            }
        }
        (best.1, best.2)
    }

    /// The same line moved to its left by `t` metres, at the same height.
    pub fn offset(&self, t: f64) -> Self {
        let n = self.points.len();
        Self::new((0..n).map(|i| {
            let before = (i > 0).then(|| (self.points[i] - self.points[i - 1]).truncate().normalize_or_zero());
            let after = (i + 1 < n).then(|| (self.points[i + 1] - self.points[i]).truncate().normalize_or_zero());
            let (u, v) = (before.or(after).unwrap_or(DVec2::X), after.or(before).unwrap_or(DVec2::X));
            let mitre = (u.perp() + v.perp()).normalize_or(u.perp());
            let stretch = 1.0 / mitre.dot(u.perp()).max(0.35);
            self.points[i] + (mitre * (t * stretch)).extend(0.0)
        }))
    }

    fn segment_of(&self, s: f64) -> usize {
        self.s.partition_point(|&x| x <= s).clamp(1, self.points.len() - 1) - 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_projections_agree() {
        let line = Polyline::new([DVec3::ZERO, DVec3::new(10.0, 0.0, 1.0), DVec3::new(10.0, 10.0, 1.0)]);
        let place = line.at(5.0);
        let (s, t) = line.project(place.position.truncate());
        assert!((s - 5.0).abs() < 1e-9 && t.abs() < 1e-9);
        assert!((place.grade - 0.1).abs() < 1e-9);
        let (_, left) = line.project(DVec2::new(5.0, 2.0));
        assert!((left - 2.0).abs() < 1e-9);
        assert!((line.offset(1.0).points()[0] - DVec3::new(0.0, 1.0, 0.0)).length() < 1e-9);
        assert!((line.at(1e9).position - DVec3::new(10.0, 10.0, 1.0)).length() < 1e-9);
    }
}
