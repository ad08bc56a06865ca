//! Whether any ray of a bundle can hit a box, by conservative interval arithmetic: yes too often, never no wrongly.

use glam::Vec3A;

/// Rays from anywhere in a box of origins, along any direction in a box of directions.
#[derive(Debug, Clone, Copy)]
pub(super) struct RayBounds {
    origin_low: Vec3A,
    origin_high: Vec3A,
    /// One over the least and the greatest direction, axis by axis.
    over_low: Vec3A,
    over_high: Vec3A,
}

/// No direction is nearer to zero along an axis: one over it stays finite.
const LEAST: f32 = 1e-9;

impl RayBounds {
    /// All rays from a box of origins with directions in another box.
    pub(super) fn new(origins: (Vec3A, Vec3A), directions: (Vec3A, Vec3A)) -> Self {
        // Bounds that are zero move outwards: that only widens the bundle.
        let moved = |d: Vec3A, to: f32| Vec3A::select(d.abs().cmplt(Vec3A::splat(LEAST)), Vec3A::splat(to), d);
        let (low, high) = (moved(directions.0, -LEAST), moved(directions.1, LEAST));
        Self { origin_low: origins.0, origin_high: origins.1, over_low: low.recip(), over_high: high.recip() }
    }

    /// Whether some origin + t × direction with 0 ≤ t ≤ `tmax` may lie in the box.
    ///
    /// At the time t the rays fill, axis by axis, `origin_low + t × direction_low` to `origin_high + t × direction_high`:
    /// the first must not lie above the box, the second not below it. Both are linear in t.
    pub(super) fn may_meet(&self, low: Vec3A, high: Vec3A, tmax: f32) -> bool {
        // A hair of slack for rounding.
        let (ahead, behind) = (high - self.origin_low, low - self.origin_high);
        let slack = (Vec3A::ONE + ahead.abs().max(behind.abs())) * 1e-4;
        let first = (ahead + slack) * self.over_low;
        let second = (behind - slack) * self.over_high;
        // Whoever flies up leaves by the top when its slowest does, and comes in by the bottom when its fastest does.
        let (slowest_rises, fastest_rises) = (self.over_low.cmpgt(Vec3A::ZERO), self.over_high.cmpgt(Vec3A::ZERO));
        let leave = Vec3A::select(slowest_rises, first, Vec3A::INFINITY).min(Vec3A::select(
            fastest_rises,
            Vec3A::INFINITY,
            second,
        ));
        let enter =
            Vec3A::select(slowest_rises, Vec3A::ZERO, first).max(Vec3A::select(fastest_rises, second, Vec3A::ZERO));
        enter.max_element() * 0.9999 <= (leave.min_element() * 1.0001).min(tmax)
    }
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
            let bundle = RayBounds::new((o, o + os), (d, d + ds));
            let point = (o + os * w) + (d + ds * v) * t;
            prop_assert!(bundle.may_meet(point - size, point + size, 30.0));
        }
    }

    #[test]
    fn denies_what_lies_behind_or_aside() {
        let b = RayBounds::new((Vec3A::ZERO, Vec3A::ONE), (Vec3A::new(0.9, -0.1, -0.1), Vec3A::new(1.0, 0.1, 0.1)));
        assert!(b.may_meet(Vec3A::new(10.0, 0.0, 0.0), Vec3A::new(11.0, 1.0, 1.0), f32::MAX));
        assert!(!b.may_meet(Vec3A::new(-11.0, 0.0, 0.0), Vec3A::new(-10.0, 1.0, 1.0), f32::MAX));
        assert!(!b.may_meet(Vec3A::new(10.0, 8.0, 0.0), Vec3A::new(11.0, 9.0, 1.0), f32::MAX));
        assert!(!b.may_meet(Vec3A::new(10.0, 0.0, 0.0), Vec3A::new(11.0, 1.0, 1.0), 5.0));
    }
}
