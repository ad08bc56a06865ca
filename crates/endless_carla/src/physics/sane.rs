//! Numbers from clients made fit for use: a client may send infinities, NaN and anything else that a float can be.

use glam::DVec3;

/// `x` between `low` and `high`; `otherwise` where it is not a number.
pub(super) fn within(x: f64, low: f64, high: f64, otherwise: f64) -> f64 {
    if x.is_nan() { otherwise } else { x.max(low).min(high) }
}

/// The same for what comes as `f32`.
pub(super) fn within_f32(x: f32, low: f64, high: f64, otherwise: f64) -> f64 {
    within(f64::from(x), low, high, otherwise)
}

/// Each component at most `limit` in size; 0 where it is not a number.
pub(super) fn vector(v: DVec3, limit: f64) -> DVec3 {
    let one = |x: f64| within(x, -limit, limit, 0.0);
    DVec3::new(one(v.x), one(v.y), one(v.z))
}

/// Not longer than `limit`; each component that is no number counts as 0.
pub(super) fn at_most(v: DVec3, limit: f64) -> DVec3 {
    let v = vector(v, limit);
    let length = v.length();
    if length > limit { v * (limit / length) } else { v }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_but_numbers_comes_through() {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e308, -1e308, 0.5] {
            let y = within(x, -1.0, 2.0, 0.25);
            assert!((-1.0..=2.0).contains(&y), "{x} became {y}");
            assert!(at_most(DVec3::new(x, 1.0, x), 3.0).length() <= 3.0 + 1e-12);
        }
        assert_eq!(within(f64::NAN, -1.0, 2.0, 0.25), 0.25);
    }
}
