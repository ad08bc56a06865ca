//! The geometry of a road: its reference line in plan view, elevation and lateral profiles.

/// A cubic polynomial `a + b ds + c ds² + d ds³` of the distance `ds` from `s`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CubicPolynomial {
    /// Start on the road.
    pub s: f64,
    /// Coefficients.
    pub abcd: [f64; 4],
}

/// A segment of the reference line (OpenDRIVE's `geometry`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanViewGeometry {
    /// Start on the road.
    pub s: f64,
    /// Start in the world.
    pub x: f64,
    /// Start in the world.
    pub y: f64,
    /// Direction at its beginning.
    pub heading: f64,
    /// Length.
    pub length: f64,
    /// Its curve.
    pub shape: GeometryType,
}

/// The curve of one segment of the reference line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GeometryType {
    /// Straight.
    Line,
    /// Constant curvature, 1/m, positive to the left.
    Arc(f64),
    /// Curvature that changes linearly from the first to the second value.
    Spiral(f64, f64),
    /// `v(u) = a + b u + c u² + d u³`.
    Poly3([f64; 4]),
    /// `u(p)` and `v(p)`; `p` runs to 1 if normalised, to the length otherwise.
    ParamPoly3 {
        /// Coefficients of `u`.
        u: [f64; 4],
        /// Coefficients of `v`.
        v: [f64; 4],
        /// `pRange="normalized"`.
        normalized: bool,
    },
}

/// Height across the road at one `s`, cubic in `t` (OpenDRIVE's `lateralProfile/shape`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LateralShape {
    /// Station on the road.
    pub s: f64,
    /// Start across the road.
    pub t: f64,
    /// Coefficients in `t − self.t`.
    pub abcd: [f64; 4],
}

/// Fall of one side or both from a place on (1.4 and 1.5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossfall {
    /// For the left side, and for the right side.
    pub sides: [bool; 2],
    /// Angle, positive downwards to the outside.
    pub angle: CubicPolynomial,
}
