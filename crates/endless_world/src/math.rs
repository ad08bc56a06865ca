//! Elementary functions that give the same bits on every machine (`libm`, in Rust, instead of the system's library).
//!
//! The standard library's versions are banned by `clippy.toml`. `sqrt`, `abs`, `floor` and the four operations are
//! exact everywhere and need no wrapper.

pub mod segment;
mod unfused;

pub use unfused::{UnfusedMatrix, UnfusedQuat, UnfusedVec3A};

macro_rules! same_everywhere {
    ($($(#[$doc:meta])* $name:ident($($arg:ident),*) = $f32:ident, $f64:ident;)*) => {
        $($(#[$doc])* #[inline] pub fn $name($($arg: f32),*) -> f32 { libm::$f32($($arg),*) })*
        /// The same functions in double precision, for roads and traffic.
        pub mod f64 {
            $($(#[$doc])* #[inline] pub fn $name($($arg: f64),*) -> f64 { libm::$f64($($arg),*) })*

            /// Sine and cosine of an angle in radians.
            #[inline]
            pub fn sin_cos(angle_rad: f64) -> (f64, f64) { libm::sincos(angle_rad) }

            /// The same angle in (−π, π].
            #[inline]
            pub fn wrap_angle(angle_rad: f64) -> f64 {
                use std::f64::consts::{PI, TAU};
                let wrapped = angle_rad - TAU * (angle_rad / TAU).round();
                if wrapped <= -PI { wrapped + TAU } else { wrapped }
            }
        }
    };
}

same_everywhere! {
    /// Sine of an angle in radians.
    sin(x) = sinf, sin;
    /// Cosine of an angle in radians.
    cos(x) = cosf, cos;
    /// Tangent of an angle in radians.
    tan(x) = tanf, tan;
    /// Arc sine, radians.
    asin(x) = asinf, asin;
    /// Arc cosine, radians.
    acos(x) = acosf, acos;
    /// Arc tangent, radians.
    atan(x) = atanf, atan;
    /// Angle of the vector (x, y) from the x axis, radians in (−π, π].
    atan2(y, x) = atan2f, atan2;
    /// e to the power of x.
    exp(x) = expf, exp;
    /// 2 to the power of x.
    exp2(x) = exp2f, exp2;
    /// Natural logarithm.
    ln(x) = logf, log;
    /// Logarithm to base 2.
    log2(x) = log2f, log2;
    /// x to the power of y.
    pow(x, y) = powf, pow;
}

/// Sine and cosine of an angle in radians.
#[inline]
pub fn sin_cos(angle_rad: f32) -> (f32, f32) {
    libm::sincosf(angle_rad)
}

/// Cubic Hermite step: 0 below `from`, 1 above `to`, smooth between.
#[inline]
pub fn smoothstep(from: f32, to: f32, x: f32) -> f32 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Linear interpolation from `a` (t = 0) to `b` (t = 1).
#[inline]
pub fn lerp(a: f32, b: f32, t: f32) -> f32 {
    a + (b - a) * t
}

/// [`atan2`] within 2e-5 radians, several times as fast: for looking up directions in tables, not for geometry.
#[inline]
pub fn atan2_approx(y: f32, x: f32) -> f32 {
    use std::f32::consts::{FRAC_PI_2, PI};
    let (ax, ay) = (x.abs(), y.abs());
    let t = ax.min(ay) / ax.max(ay).max(f32::MIN_POSITIVE);
    // Abramowitz and Stegun 4.4.49.
    let t2 = t * t;
    let poly = 0.999_866 + t2 * (-0.330_299_5 + t2 * (0.180_141 + t2 * (-0.085_133 + t2 * 0.020_835_1)));
    let octant = t * poly;
    let quadrant = if ay > ax { FRAC_PI_2 - octant } else { octant };
    let half = if x < 0.0 { PI - quadrant } else { quadrant };
    if y < 0.0 { -half } else { half }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_quick_angle_is_close() {
        for i in 0..2000 {
            let angle = (i as f32 / 1000.0 - 1.0) * 3.1;
            let (sin, cos) = sin_cos(angle);
            assert!((atan2_approx(3.0 * sin, 3.0 * cos) - angle).abs() < 2e-5, "{angle}");
        }
        assert_eq!(atan2_approx(0.0, 0.0), 0.0);
    }
}
