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

/// Pixels in double precision, to hundredths.
pub(crate) fn hundredths_f64(value: f64) -> f64 {
    rounded(value, 1e2)
}

/// Shares and metres in double precision, to 0.0001.
pub(crate) fn ten_thousandths_f64(value: f64) -> f64 {
    rounded(value, 1e4)
}

/// Places, directions and times in double precision, to 0.000001.
pub(crate) fn millionths(value: f64) -> f64 {
    rounded(value, 1e6)
}

fn to(value: f32, parts: f64) -> f64 {
    rounded(value.into(), parts)
}

fn rounded(value: f64, parts: f64) -> f64 {
    // Adding zero turns −0 into 0, which would look odd in a file.
    (value * parts).round() / parts + 0.0
}
