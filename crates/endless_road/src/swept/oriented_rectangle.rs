//! Bodies seen from above.

use endless_world::VehicleSpec;
use endless_world::math::f64::sin_cos;
use glam::DVec2;

/// An oriented rectangle: the footprint of a body.
#[derive(Debug, Clone, Copy)]
pub struct OrientedRectangle {
    /// Its middle.
    pub center: DVec2,
    /// Unit vector ahead.
    pub axis: DVec2,
    /// Half its length and half its width, metres.
    pub half: DVec2,
}

impl OrientedRectangle {
    /// Of a vehicle at a place, with a margin all round, metres.
    pub fn new(spec: &VehicleSpec, center: DVec2, yaw_rad: f64, margin_m: f64) -> Self {
        let (sin, cos) = sin_cos(yaw_rad);
        let half = 0.5 * DVec2::new(f64::from(spec.length_m), f64::from(spec.width_m)) + DVec2::splat(margin_m);
        Self { center, axis: DVec2::new(cos, sin), half }
    }

    /// Of half sizes, around a place.
    pub fn of(half: DVec2, center: DVec2, yaw_rad: f64) -> Self {
        let (sin, cos) = sin_cos(yaw_rad);
        Self { center, axis: DVec2::new(cos, sin), half }
    }

    /// The same, further on by some metres.
    pub fn moved(self, by_m: f64) -> Self {
        Self { center: self.center + self.axis * by_m, ..self }
    }

    /// A place of its own, ahead of its middle and to the left of it, metres.
    pub fn place(&self, ahead_m: f64, left_m: f64) -> DVec2 {
        self.center + self.axis * ahead_m + self.axis.perp() * left_m
    }

    /// How far a place is ahead of its middle and to the left of it, metres: [`Self::place`] undone.
    pub fn local(&self, at: DVec2) -> DVec2 {
        let away = at - self.center;
        DVec2::new(away.dot(self.axis), away.dot(self.axis.perp()))
    }

    /// The place of it that is nearest to another place, which is itself if it is inside.
    pub fn nearest(&self, at: DVec2) -> DVec2 {
        let inside = self.local(at).clamp(-self.half, self.half);
        self.place(inside.x, inside.y)
    }

    /// How far a place is outside, metres; 0 inside.
    pub fn distance(&self, at: DVec2) -> f64 {
        (self.local(at).abs() - self.half).max(DVec2::ZERO).length()
    }

    /// Whether two of them overlap (separating axes).
    pub fn overlaps(&self, other: &Self) -> bool {
        let apart = other.center - self.center;
        let reach = |f: &Self, n: DVec2| f.half.x * f.axis.dot(n).abs() + f.half.y * f.axis.perp().dot(n).abs();
        [self.axis, self.axis.perp(), other.axis, other.axis.perp()]
            .into_iter()
            .all(|n| reach(self, n) + reach(other, n) > apart.dot(n).abs())
    }
}
