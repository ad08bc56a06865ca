//! Functions given by points with straight lines between them.

use crate::wire::Vector2D;

/// Piecewise linear, constant before the first and after the last point.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curve {
    points: Vec<(f64, f64)>,
}

impl Curve {
    /// Points that are not finite are left out; the others are sorted. Without any the curve is `otherwise` everywhere.
    pub(super) fn new(points: &[Vector2D], otherwise: f64) -> Self {
        let finite = points.iter().filter(|point| point.x.is_finite() && point.y.is_finite());
        let mut points: Vec<_> = finite.map(|point| (f64::from(point.x), f64::from(point.y))).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        if points.is_empty() {
            points.push((0.0, otherwise));
        }
        Self { points }
    }

    /// The value at `x`.
    pub(super) fn at(&self, x: f64) -> f64 {
        let after = self.points.partition_point(|point| point.0 <= x);
        match (after.checked_sub(1).and_then(|before| self.points.get(before)), self.points.get(after)) {
            (Some(a), Some(b)) => a.1 + (b.1 - a.1) * ((x - a.0) / (b.0 - a.0)),
            (Some(end), None) | (None, Some(end)) => end.1,
            (None, None) => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn goes_through_its_points() {
        let point = |x, y| Vector2D { x, y };
        let curve = Curve::new(&[point(10.0, 2.0), point(f32::NAN, 1.0), point(0.0, 1.0), point(10.0, 4.0)], 0.0);
        for (x, y) in [(-5.0, 1.0), (0.0, 1.0), (5.0, 1.5), (10.0, 4.0), (99.0, 4.0)] {
            assert_eq!(curve.at(x), y, "at {x}");
        }
        assert_eq!(Curve::new(&[], 7.0).at(3.0), 7.0);
    }
}
