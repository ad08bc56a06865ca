//! Can any ray of a bundle meet a box? Interval arithmetic that may say yes too often, never no wrongly.

use glam::Vec3A;

/// Rays from anywhere in a box of origins, along any direction in a box of directions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bundle {
    pub(super) origin_low: Vec3A,
    pub(super) origin_high: Vec3A,
    pub(super) direction_low: Vec3A,
    pub(super) direction_high: Vec3A,
}

impl Bundle {
    /// Whether some origin + t × direction with 0 ≤ t ≤ `tmax` may lie in the box.
    pub(super) fn may_meet(&self, low: Vec3A, high: Vec3A, tmax: f32) -> bool {
        let (mut from, mut to) = (0.0f32, tmax);
        for axis in 0..3 {
            // Need t d ∈ [a, b] for some d in [d0, d1].
            let a = low[axis] - self.origin_high[axis];
            let b = high[axis] - self.origin_low[axis];
            let (d0, d1) = (self.direction_low[axis], self.direction_high[axis]);
            let (enter, leave) = times(a, b, d0, d1);
            from = from.max(enter);
            to = to.min(leave);
            if from > to {
                return false;
            }
        }
        true
    }
}

/// Bounds of the times t ≥ 0 at which the interval t × [d0, d1] meets [a, b].
fn times(a: f32, b: f32, d0: f32, d1: f32) -> (f32, f32) {
    // A hair of slack for rounding.
    let slack = 1e-4 * (1.0 + a.abs().max(b.abs()));
    let (a, b) = (a - slack, b + slack);
    if a <= 0.0 && b >= 0.0 {
        // Inside at t = 0; leaves when the slowest edge has passed.
        let up = if d0 > 0.0 { b / d0 } else { f32::INFINITY };
        let down = if d1 < 0.0 { a / d1 } else { f32::INFINITY };
        return (0.0, up.min(down) * 1.0001);
    }
    if a > 0.0 {
        // Ahead in the positive direction.
        if d1 <= 0.0 {
            return (f32::INFINITY, 0.0);
        }
        let leave = if d0 > 0.0 { b / d0 } else { f32::INFINITY };
        return (a / d1 * 0.9999, leave * 1.0001);
    }
    let (enter, leave) = times(-b + slack, -a - slack, -d1, -d0);
    (enter, leave)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn vec(range: std::ops::Range<f32>) -> impl Strategy<Value = Vec3A> {
        (range.clone(), range.clone(), range).prop_map(|(x, y, z)| Vec3A::new(x, y, z))
    }

    proptest! {
        #[test]
        fn never_denies_a_meeting(
            o in vec(-20.0..20.0), os in vec(0.0..3.0), d in vec(-1.0..1.0), ds in vec(0.0..0.3),
            w in vec(0.0..1.0), v in vec(0.0..1.0), t in 0.0f32..30.0, size in vec(0.01..2.0),
        ) {
            let bundle = Bundle { origin_low: o, origin_high: o + os, direction_low: d, direction_high: d + ds };
            let point = (o + os * w) + (d + ds * v) * t;
            prop_assert!(bundle.may_meet(point - size, point + size, 30.0));
        }
    }

    #[test]
    fn denies_what_lies_behind_or_aside() {
        let b = Bundle {
            origin_low: Vec3A::ZERO,
            origin_high: Vec3A::ONE,
            direction_low: Vec3A::new(0.9, -0.1, -0.1),
            direction_high: Vec3A::new(1.0, 0.1, 0.1),
        };
        assert!(b.may_meet(Vec3A::new(10.0, 0.0, 0.0), Vec3A::new(11.0, 1.0, 1.0), f32::MAX));
        assert!(!b.may_meet(Vec3A::new(-11.0, 0.0, 0.0), Vec3A::new(-10.0, 1.0, 1.0), f32::MAX));
        assert!(!b.may_meet(Vec3A::new(10.0, 8.0, 0.0), Vec3A::new(11.0, 9.0, 1.0), f32::MAX));
        assert!(!b.may_meet(Vec3A::new(10.0, 0.0, 0.0), Vec3A::new(11.0, 1.0, 1.0), 5.0));
    }
}
