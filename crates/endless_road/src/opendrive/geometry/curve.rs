//! The plan view's curves, by arc length (ASAM OpenDRIVE 1.8, chapter 9).
//!
//! Spirals and cubics have no closed form by arc length. A spiral's position is the integral of its heading's unit
//! vector, taken by Gauss and Legendre's rule between knots a quarter of a radian apart at most. A cubic's arc length
//! is tabulated the same way and inverted by Newton's method.

use super::super::document::{GeometryType, PlanViewGeometry};
use endless_world::math::f64::{atan2, sin_cos};
use glam::DVec2;

/// A place on the plan view.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PlanViewPose {
    pub(crate) position: DVec2,
    pub(crate) heading: f64,
}

/// One piece of the reference line, ready to evaluate.
#[derive(Debug, Clone)]
pub(crate) struct PlanViewCurve {
    /// Where it begins on the road.
    pub(crate) s: f64,
    length: f64,
    start: PlanViewPose,
    kind: CurveKind,
}

#[derive(Debug, Clone)]
enum CurveKind {
    Line,
    Arc(f64),
    Spiral { from: f64, rate: f64, knots: Vec<DVec2>, step: f64 },
    Cubic(ParametricCubic),
}

/// Nodes and weights on [0, 1].
const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668, 0.118_463_442_528_094_5),
    (0.230_765_344_947_158_5, 0.239_314_335_249_683_2),
    (0.5, 0.284_444_444_444_444_4),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_2),
    (0.953_089_922_969_332, 0.118_463_442_528_094_5),
];

impl PlanViewCurve {
    pub(crate) fn new(geometry: &PlanViewGeometry) -> Self {
        let length = geometry.length;
        let kind = match geometry.shape {
            GeometryType::Line => CurveKind::Line,
            GeometryType::Arc(curvature) if curvature.abs() < 1e-12 => CurveKind::Line,
            GeometryType::Arc(curvature) => CurveKind::Arc(curvature),
            GeometryType::Spiral(from, to) => spiral(from, to, length),
            GeometryType::Poly3(v) => {
                CurveKind::Cubic(ParametricCubic::new([0.0, 1.0, 0.0, 0.0], v, length, false, length))
            }
            GeometryType::ParamPoly3 { u, v, normalized } => {
                CurveKind::Cubic(ParametricCubic::new(u, v, if normalized { 1.0 } else { length }, true, length))
            }
        };
        let start = PlanViewPose { position: DVec2::new(geometry.x, geometry.y), heading: geometry.heading };
        Self { s: geometry.s, length, start, kind }
    }

    /// Metres of curve for each metre that the file gives it: 1 but for a parametric cubic of another length.
    pub(crate) fn stretch(&self) -> f64 {
        if let CurveKind::Cubic(cubic) = &self.kind { cubic.scale } else { 1.0 }
    }

    /// The place `ds` metres after the piece's beginning, clamped to it.
    pub(crate) fn pose(&self, ds: f64) -> PlanViewPose {
        let ds = ds.clamp(0.0, self.length);
        let (local, turn) = match &self.kind {
            CurveKind::Line => (DVec2::new(ds, 0.0), 0.0),
            CurveKind::Arc(curvature) => {
                let turn = curvature * ds;
                let (sin, cos) = sin_cos(turn);
                (DVec2::new(sin, 1.0 - cos) / *curvature, turn)
            }
            CurveKind::Spiral { from, rate, knots, step } => {
                let knot = ((ds / step) as usize).min(knots.len() - 1);
                let at = knot as f64 * step;
                let turn = |s: f64| (from + 0.5 * rate * s) * s;
                (knots[knot] + heading_integral(turn, at, ds), turn(ds))
            }
            CurveKind::Cubic(cubic) => cubic.local(ds),
        };
        let (sin, cos) = sin_cos(self.start.heading);
        let rotated = DVec2::new(cos * local.x - sin * local.y, sin * local.x + cos * local.y);
        PlanViewPose { position: self.start.position + rotated, heading: self.start.heading + turn }
    }
}

fn spiral(from: f64, to: f64, length: f64) -> CurveKind {
    let rate = (to - from) / length;
    let turn = |s: f64| (from + 0.5 * rate * s) * s;
    let pieces = (from.abs().max(to.abs()) * length / 0.25).ceil().max(1.0) as usize;
    let step = length / pieces as f64;
    let mut knots = vec![DVec2::ZERO];
    for i in 0..pieces {
        let (a, b) = (i as f64 * step, (i + 1) as f64 * step);
        knots.push(knots[i] + heading_integral(turn, a, b));
    }
    CurveKind::Spiral { from, rate, knots, step }
}

/// ∫ (cos turn, sin turn) ds.
fn heading_integral(turn: impl Fn(f64) -> f64, from: f64, to: f64) -> DVec2 {
    let mut sum = DVec2::ZERO;
    for (node, weight) in GAUSS {
        let (sin, cos) = sin_cos(turn(from + (to - from) * node));
        sum += DVec2::new(cos, sin) * weight;
    }
    sum * (to - from)
}

/// A plane cubic with a table from arc length to its parameter.
#[derive(Debug, Clone)]
struct ParametricCubic {
    u: [f64; 4],
    v: [f64; 4],
    /// Parameter between knots.
    step: f64,
    /// Arc length at each knot.
    arc: Vec<f64>,
    /// Arc length for each metre of the road.
    scale: f64,
}

impl ParametricCubic {
    /// `stretched`: the whole range of the parameter is the road's length, whatever the curve's own length.
    fn new(u: [f64; 4], v: [f64; 4], last: f64, stretched: bool, length: f64) -> Self {
        let pieces = length.ceil().clamp(16.0, 4096.0) as usize;
        let mut cubic = Self { u, v, step: last / pieces as f64, arc: vec![0.0], scale: 1.0 };
        for i in 0..pieces {
            let (a, b) = (i as f64 * cubic.step, (i + 1) as f64 * cubic.step);
            cubic.arc.push(cubic.arc[i] + cubic.arc_between(a, b));
        }
        if stretched {
            cubic.scale = cubic.arc[pieces] / length;
        }
        cubic
    }

    fn derivative(&self, p: f64) -> DVec2 {
        let d = |c: &[f64; 4]| c[1] + p * (2.0 * c[2] + p * 3.0 * c[3]);
        DVec2::new(d(&self.u), d(&self.v))
    }

    fn arc_between(&self, from: f64, to: f64) -> f64 {
        GAUSS.iter().map(|(node, weight)| weight * self.derivative(from + (to - from) * node).length()).sum::<f64>()
            * (to - from)
    }

    fn local(&self, ds: f64) -> (DVec2, f64) {
        let p = self.parameter(ds * self.scale);
        let value = |c: &[f64; 4]| c[0] + p * (c[1] + p * (c[2] + p * c[3]));
        let d = self.derivative(p);
        let turn = if d.length_squared() > 1e-18 { atan2(d.y, d.x) } else { 0.0 };
        (DVec2::new(value(&self.u), value(&self.v)), turn)
    }

    fn parameter(&self, arc: f64) -> f64 {
        let knot = self.arc.partition_point(|&a| a <= arc).clamp(1, self.arc.len() - 1) - 1;
        let (low, high) = (knot as f64 * self.step, (knot + 1) as f64 * self.step);
        let span = self.arc[knot + 1] - self.arc[knot];
        if span < 1e-12 {
            return low;
        }
        let mut p = low + (high - low) * (arc - self.arc[knot]) / span;
        for _ in 0..4 {
            let speed = self.derivative(p).length();
            if speed < 1e-9 {
                break;
            }
            let error = self.arc[knot] + self.arc_between(low, p) - arc;
            p = (p - error / speed).clamp(low, high);
        }
        p
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn piece(length: f64, shape: GeometryType) -> PlanViewCurve {
        PlanViewCurve::new(&PlanViewGeometry { s: 0.0, x: 3.0, y: -2.0, heading: FRAC_PI_2, length, shape })
    }

    /// Heading north from (3, −2): local (u, v) is world (3 − v, −2 + u).
    fn world(u: f64, v: f64) -> DVec2 {
        DVec2::new(3.0 - v, -2.0 + u)
    }

    #[test]
    fn lines_and_arcs_are_where_trigonometry_puts_them() {
        let end = piece(12.0, GeometryType::Line).pose(12.0);
        assert!((end.position - world(12.0, 0.0)).length() < 1e-12);
        for radius in [5.0, -40.0, 1e5] {
            let length = 7.0;
            let end = piece(length, GeometryType::Arc(1.0 / radius)).pose(length);
            let turn: f64 = length / radius;
            let (sin, cos) = sin_cos(turn);
            assert!((end.position - world(radius * sin, radius * (1.0 - cos))).length() < 1e-8);
            assert!((end.heading - FRAC_PI_2 - turn).abs() < 1e-12);
        }
    }

    /// Power series of the Fresnel integrals ∫ cos(c s²) and ∫ sin(c s²).
    fn clothoid(c: f64, s: f64) -> (f64, f64) {
        let (mut x, mut y, mut term) = (0.0, 0.0, s);
        for n in 0..60 {
            let k = f64::from(n);
            if n % 2 == 0 {
                x += term / (2.0 * k + 1.0) * if n % 4 == 0 { 1.0 } else { -1.0 };
            } else {
                y += term / (2.0 * k + 1.0) * if n % 4 == 1 { 1.0 } else { -1.0 };
            }
            term *= c * s * s / (k + 1.0);
        }
        (x, y)
    }

    #[test]
    fn spirals_agree_with_the_fresnel_series() {
        for (to, length) in [(0.01, 100.0), (0.1, 60.0), (-0.05, 80.0), (0.2, 30.0)] {
            let spiral = piece(length, GeometryType::Spiral(0.0, to));
            for i in 1..=10 {
                let s = length * f64::from(i) / 10.0;
                let (x, y) = clothoid(to.abs() / (2.0 * length), s);
                let there = spiral.pose(s);
                assert!((there.position - world(x, y * to.signum())).length() < 1e-6, "{to} {length} {s}");
                assert!((there.heading - FRAC_PI_2 - to * s * s / (2.0 * length)).abs() < 1e-12);
            }
        }
        // Without a change of curvature it is an arc.
        let (spiral, arc) = (piece(50.0, GeometryType::Spiral(0.04, 0.04)), piece(50.0, GeometryType::Arc(0.04)));
        assert!((spiral.pose(50.0).position - arc.pose(50.0).position).length() < 1e-9);
        // Backwards it meets its beginning.
        let there = piece(40.0, GeometryType::Spiral(0.02, 0.1)).pose(40.0);
        let back = PlanViewCurve::new(&PlanViewGeometry {
            s: 0.0,
            x: there.position.x,
            y: there.position.y,
            heading: there.heading + PI,
            length: 40.0,
            shape: GeometryType::Spiral(-0.1, -0.02),
        });
        assert!((back.pose(40.0).position - DVec2::new(3.0, -2.0)).length() < 1e-8);
    }

    #[test]
    fn cubics_run_by_arc_length() {
        // v = 0.01 u²: arc length by the closed form of the parabola.
        let arc = |u: f64| {
            let k: f64 = 0.02 * u;
            (k * (1.0 + k * k).sqrt() + endless_world::math::f64::ln(k + (1.0 + k * k).sqrt())) / 0.04
        };
        let poly = piece(arc(40.0), GeometryType::Poly3([0.0, 0.0, 0.01, 0.0]));
        for u in [0.0, 10.0, 25.0, 40.0] {
            let there = poly.pose(arc(u));
            assert!((there.position - world(u, 0.01 * u * u)).length() < 1e-6, "{u}");
        }
        // The same curve as a parametric one, in both ranges of the parameter.
        for (normalized, n) in [(true, 40.0), (false, 40.0 / arc(40.0))] {
            let curve =
                GeometryType::ParamPoly3 { u: [0.0, n, 0.0, 0.0], v: [0.0, 0.0, 0.01 * n * n, 0.0], normalized };
            let there = piece(arc(40.0), curve);
            for u in [0.0, 10.0, 25.0, 40.0] {
                assert!((there.pose(arc(u)).position - world(u, 0.01 * u * u)).length() < 1e-6, "{normalized} {u}");
            }
        }
    }

    #[test]
    fn degenerate_curves_stay_finite() {
        let zero = GeometryType::ParamPoly3 { u: [0.0; 4], v: [0.0; 4], normalized: true };
        for shape in [zero, GeometryType::Poly3([0.0; 4]), GeometryType::Spiral(0.0, 0.0), GeometryType::Arc(0.0)] {
            let p = piece(10.0, shape).pose(5.0);
            assert!(p.position.is_finite() && p.heading.is_finite());
        }
    }
}
