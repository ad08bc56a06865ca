//! Upright boxes: rectangles in the plane with a range of heights.

use glam::{DVec2, DVec3};

/// An upright box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrientedBox {
    /// In the world, metres.
    pub centre: DVec2,
    /// Half of its length and half of its width, metres.
    pub half: DVec2,
    /// Unit vector along its length.
    pub along: DVec2,
    /// Height of its bottom, metres.
    pub low_m: f64,
    /// Height of its top, metres.
    pub high_m: f64,
}

/// How two boxes are in each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Overlap {
    /// From the first to the second, the way that takes them apart.
    pub(super) normal: DVec2,
    /// How far, metres.
    pub(super) depth_m: f64,
    /// In the middle of what they share.
    pub(super) point: DVec2,
    /// Height of that.
    pub(super) height_m: f64,
}

/// Less than this in height is passing over or under, metres.
const BRUSH_M: f64 = 0.05;
/// Added to speeds along axes, so that slow bodies part where they overlap least, m/s.
const SLOW_MPS: f64 = 0.5;

impl OrientedBox {
    /// Whether it and another share any room.
    pub fn touches(&self, other: &Self) -> bool {
        self.overlap(other, DVec2::ZERO).is_some()
    }

    /// Its corners, counter-clockwise.
    pub(super) fn corners(&self) -> [DVec2; 4] {
        let (x, y) = (self.along * self.half.x, self.along.perp() * self.half.y);
        [self.centre + x + y, self.centre - x + y, self.centre - x - y, self.centre + x - y]
    }

    /// The smallest box along the axes that holds it in the plane: its low and its high corner.
    pub(crate) fn bounds(&self) -> (DVec2, DVec2) {
        let reach = self.along.abs() * self.half.x + self.along.perp().abs() * self.half.y;
        (self.centre - reach, self.centre + reach)
    }

    /// How far a point is from it, metres; 0 within it.
    pub(crate) fn distance_m(&self, point: DVec3) -> f64 {
        let from = point.truncate() - self.centre;
        let beside = DVec2::new(from.dot(self.along), from.dot(self.along.perp())).abs() - self.half;
        let above = (point.z - self.high_m).max(self.low_m - point.z);
        beside.extend(above).max(DVec3::ZERO).length()
    }

    /// Whether the smallest box along the axes that holds it meets a rectangle.
    pub(crate) fn comes_into(&self, low: DVec2, high: DVec2) -> bool {
        let (own_low, own_high) = self.bounds();
        own_low.cmple(high).all() && low.cmple(own_high).all()
    }

    fn reach(&self, axis: DVec2) -> f64 {
        self.half.x * self.along.dot(axis).abs() + self.half.y * self.along.perp().dot(axis).abs()
    }

    /// How it and another are in each other, by the axes that separate rectangles (Gottschalk, Lin, Manocha 1996, "OBBTree",
    /// in the plane). Bodies that move at `velocity` (of the other against this one) part along the axis on which they met
    /// last: fast ones are deep in each other along it before anybody looks.
    pub(super) fn overlap(&self, other: &Self, velocity: DVec2) -> Option<Overlap> {
        let (low_m, high_m) = (self.low_m.max(other.low_m), self.high_m.min(other.high_m));
        if high_m - low_m < BRUSH_M {
            return None;
        }
        let apart = other.centre - self.centre;
        let mut best: Option<(f64, DVec2, f64)> = None;
        for axis in [self.along, self.along.perp(), other.along, other.along.perp()] {
            let distance = apart.dot(axis);
            let depth_m = self.reach(axis) + other.reach(axis) - distance.abs();
            if depth_m <= 0.0 {
                return None;
            }
            let axis = if distance < 0.0 { -axis } else { axis };
            let met_s = depth_m / ((-velocity.dot(axis)).max(0.0) + SLOW_MPS);
            // Axes of parallel boxes are the same but for rounding: the first of them is the one.
            if best.is_none_or(|(known_s, ..)| met_s < known_s * (1.0 - 1e-6)) {
                best = Some((met_s, axis, depth_m));
            }
        }
        let (_, normal, depth_m) = best?;
        let point = self.shared(other).unwrap_or(self.centre + 0.5 * apart);
        Some(Overlap { normal, depth_m, point, height_m: 0.5 * (low_m + high_m) })
    }

    /// The mean corner of what both cover (Sutherland and Hodgman's clipping).
    fn shared(&self, other: &Self) -> Option<DVec2> {
        let mut polygon = other.corners().to_vec();
        let corners = self.corners();
        for (from, to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            let inside = |point: DVec2| (*to - *from).perp_dot(point - *from);
            let mut clipped = Vec::with_capacity(8);
            for (index, &a) in polygon.iter().enumerate() {
                let Some(&b) = polygon.get((index + 1) % polygon.len()) else { continue };
                let (in_a, in_b) = (inside(a), inside(b));
                if in_a >= 0.0 {
                    clipped.push(a);
                }
                if (in_a > 0.0 && in_b < 0.0) || (in_a < 0.0 && in_b > 0.0) {
                    clipped.push(a + (b - a) * (in_a / (in_a - in_b)));
                }
            }
            polygon = clipped;
        }
        let count = polygon.len();
        (count > 0).then(|| polygon.into_iter().sum::<DVec2>() / count as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::vehicle_body::direction;
    use proptest::prelude::*;

    fn upright() -> impl Strategy<Value = OrientedBox> {
        (-4.0..4.0f64, -4.0..4.0f64, 0.2..3.0f64, 0.2..3.0f64, -3.2..3.2f64).prop_map(|(x, y, length, width, yaw)| {
            let (centre, half) = (DVec2::new(x, y), DVec2::new(length, width));
            OrientedBox { centre, half, along: direction(yaw), low_m: 0.0, high_m: 1.0 }
        })
    }

    /// Whether any of many points of one is in the other.
    fn touches(a: &OrientedBox, b: &OrientedBox) -> bool {
        let steps = || (0..=40).map(|step| f64::from(step) / 20.0 - 1.0);
        steps().any(|u| {
            steps().any(|v| {
                let point = a.centre + a.along * (a.half.x * u) + a.along.perp() * (a.half.y * v);
                let there = point - b.centre;
                there.dot(b.along).abs() < b.half.x && there.dot(b.along.perp()).abs() < b.half.y
            })
        })
    }

    proptest! {
        #[test]
        fn overlaps_are_those_of_points(a in upright(), b in upright()) {
            let overlap = a.overlap(&b, DVec2::ZERO);
            if touches(&a, &b) {
                prop_assert!(overlap.is_some());
            }
            if let Some(overlap) = overlap {
                let apart = OrientedBox { centre: b.centre + overlap.normal * (overlap.depth_m + 1e-9), ..b };
                prop_assert!(a.overlap(&apart, DVec2::ZERO).is_none());
                prop_assert!((overlap.normal.length() - 1.0).abs() < 1e-9);
                let (low, high) = a.bounds();
                prop_assert!(overlap.point.cmpge(low - 1e-9).all() && overlap.point.cmple(high + 1e-9).all());
            }
        }
    }

    #[test]
    fn what_passes_over_does_not_meet() {
        let a = OrientedBox { centre: DVec2::ZERO, half: DVec2::ONE, along: DVec2::X, low_m: 0.0, high_m: 1.5 };
        assert!(a.overlap(&a, DVec2::ZERO).is_some());
        assert!(a.overlap(&OrientedBox { low_m: 1.5, high_m: 3.0, ..a }, DVec2::ZERO).is_none());
    }
}
