//! A road's surface: from (s, t) to the world.

use super::super::document::Road;
use super::curve::{PlanViewCurve, PlanViewPose};
use super::profile::{shape_at, value_at};
use endless_world::math::f64::sin_cos;
use glam::{DVec2, DVec3};

/// A road ready to evaluate.
#[derive(Debug, Clone)]
pub(crate) struct RoadShape<'a> {
    pub(crate) road: &'a Road,
    pieces: Vec<PlanViewCurve>,
}

impl<'a> RoadShape<'a> {
    pub(crate) fn new(road: &'a Road) -> Self {
        Self { road, pieces: road.plan_view.iter().map(PlanViewCurve::new).collect() }
    }

    /// The reference line at `s`, clamped to the road.
    pub(crate) fn pose(&self, s: f64) -> PlanViewPose {
        let at = self.pieces.partition_point(|piece| piece.s <= s).max(1) - 1;
        self.pieces[at].pose(s - self.pieces[at].s)
    }

    /// The surface at (s, t), without the lanes' own heights.
    pub(crate) fn point(&self, s: f64, t: f64) -> DVec3 {
        self.frame(s).point(t, self.height(s, t))
    }

    /// Height of the surface above the plane across the road.
    pub(crate) fn height(&self, s: f64, t: f64) -> f64 {
        shape_at(&self.road.shapes, s, t) - self.fall(s, t)
    }

    /// How much the surface falls to the outside.
    fn fall(&self, s: f64, t: f64) -> f64 {
        let side = usize::from(t < 0.0);
        let of_side = || self.road.crossfalls.iter().filter(|fall| fall.sides[side]);
        let Some(fall) = of_side().take_while(|fall| fall.angle.s <= s).last().or(of_side().next()) else { return 0.0 };
        let (sin, cos) = sin_cos(value_at(&[fall.angle], s).clamp(-1.0, 1.0));
        t.abs() * sin / cos
    }

    /// Superelevation at `s`, radians.
    pub(crate) fn roll(&self, s: f64) -> f64 {
        value_at(&self.road.superelevation, s)
    }

    /// The frame across the road at `s`.
    pub(crate) fn frame(&self, s: f64) -> RoadFrame {
        let pose = self.pose(s);
        let (sin, cos) = sin_cos(pose.heading);
        let (roll_sin, roll_cos) = sin_cos(self.roll(s));
        RoadFrame {
            origin: pose.position.extend(value_at(&self.road.elevation, s)),
            left: DVec2::new(-sin, cos),
            roll_sin,
            roll_cos,
        }
    }

    /// Where pieces of the reference line begin.
    pub(crate) fn joints(&self) -> impl Iterator<Item = f64> {
        self.pieces.iter().map(|piece| piece.s)
    }
}

/// The plane across a road.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RoadFrame {
    origin: DVec3,
    left: DVec2,
    roll_sin: f64,
    roll_cos: f64,
}

impl RoadFrame {
    /// `t` to the left, `height` above the plane.
    pub(crate) fn point(&self, t: f64, height: f64) -> DVec3 {
        let across = t * self.roll_cos - height * self.roll_sin;
        let up = t * self.roll_sin + height * self.roll_cos;
        self.origin + (self.left * across).extend(up)
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::document::{CubicPolynomial, GeometryType, LateralShape, PlanViewGeometry};
    use super::*;

    #[test]
    fn the_left_side_rises_with_positive_superelevation() {
        let road = Road {
            plan_view: vec![PlanViewGeometry {
                s: 0.0,
                x: 1.0,
                y: 2.0,
                heading: 0.0,
                length: 50.0,
                shape: GeometryType::Line,
            }],
            elevation: vec![CubicPolynomial { s: 0.0, abcd: [3.0, 0.1, 0.0, 0.0] }],
            superelevation: vec![CubicPolynomial { s: 0.0, abcd: [0.1, 0.0, 0.0, 0.0] }],
            shapes: vec![LateralShape { s: 0.0, t: 0.0, abcd: [0.0; 4] }],
            ..Road::default()
        };
        let p = RoadShape::new(&road).point(10.0, 4.0);
        let (sin, cos) = sin_cos(0.1);
        assert!((p - DVec3::new(11.0, 2.0 + 4.0 * cos, 4.0 + 4.0 * sin)).length() < 1e-12);
    }
}
