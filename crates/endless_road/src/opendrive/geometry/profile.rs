//! Piecewise cubics: heights, widths, offsets.

use super::super::document::{CubicPolynomial, LateralShape};

/// The value of the last cubic that begins at or before `s`; 0 without any. Before the first, its first value.
pub(crate) fn value_at(cubics: &[CubicPolynomial], s: f64) -> f64 {
    let Some(first) = cubics.first() else { return 0.0 };
    let at = cubics.partition_point(|cubic| cubic.s <= s);
    let cubic = if at == 0 { first } else { &cubics[at - 1] };
    let ds = (s - cubic.s).max(0.0);
    let [a, b, c, d] = cubic.abcd;
    a + ds * (b + ds * (c + ds * d))
}

/// Height of the surface above the reference plane: cubics across the road, linear along it.
pub(crate) fn shape_at(shapes: &[LateralShape], s: f64, t: f64) -> f64 {
    let next = shapes.partition_point(|shape| shape.s <= s);
    if shapes.is_empty() {
        return 0.0;
    }
    let before = if next == 0 { shapes[0].s } else { shapes[next - 1].s };
    let here = across(shapes, before, t);
    match shapes.get(next) {
        Some(after) if after.s > before && s > before => {
            let share = (s - before) / (after.s - before);
            here + share * (across(shapes, after.s, t) - here)
        }
        _ => here,
    }
}

fn across(shapes: &[LateralShape], s: f64, t: f64) -> f64 {
    let first = shapes.partition_point(|shape| shape.s < s);
    let end = shapes.partition_point(|shape| shape.s <= s);
    let row = &shapes[first..end];
    let at = row.partition_point(|shape| shape.t <= t).max(1) - 1;
    let Some(shape) = row.get(at) else { return 0.0 };
    let dt = (t - shape.t).max(0.0);
    let [a, b, c, d] = shape.abcd;
    a + dt * (b + dt * (c + dt * d))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_record_before_counts() {
        let cubics = [
            CubicPolynomial { s: 1.0, abcd: [1.0, 2.0, 0.0, 0.0] },
            CubicPolynomial { s: 3.0, abcd: [0.0, 0.0, 1.0, 1.0] },
        ];
        assert_eq!([0.0, 1.0, 2.0, 3.0, 5.0].map(|s| value_at(&cubics, s)), [1.0, 1.0, 3.0, 0.0, 12.0]);
        assert_eq!(value_at(&[], 3.0), 0.0);
    }

    #[test]
    fn shapes_are_linear_along_the_road() {
        let shape = |s: f64, t: f64, a: f64, b: f64| LateralShape { s, t, abcd: [a, b, 0.0, 0.0] };
        let shapes = [shape(0.0, -5.0, 0.0, 0.0), shape(0.0, 0.0, 0.0, 0.1), shape(10.0, -5.0, 1.0, 0.0)];
        assert!((shape_at(&shapes, 0.0, 2.0) - 0.2).abs() < 1e-12);
        assert!((shape_at(&shapes, 5.0, 2.0) - 0.6).abs() < 1e-12);
        assert!((shape_at(&shapes, 50.0, 2.0) - 1.0).abs() < 1e-12);
    }
}
