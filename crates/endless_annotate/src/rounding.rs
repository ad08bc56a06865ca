//! Numbers as they are written: no more digits than the simulation means.

/// Millimetres, thousandths of a second.
pub(crate) fn thousandths(value: f32) -> f64 {
    to(value, 1e3)
}

/// Hundredths of a pixel.
pub(crate) fn hundredths(value: f32) -> f64 {
    to(value, 1e2)
}

/// Angles in radians, shares.
pub(crate) fn ten_thousandths(value: f32) -> f64 {
    to(value, 1e4)
}

/// Parts of unit quaternions.
pub(crate) fn hundred_thousandths(value: f32) -> f64 {
    to(value, 1e5)
}

fn to(value: f32, parts: f64) -> f64 {
    // Adding zero turns −0 into 0, which would look odd in a file.
    (f64::from(value) * parts).round() / parts + 0.0
}
