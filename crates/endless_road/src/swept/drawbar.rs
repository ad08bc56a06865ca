//! The drawbar equation: how what is towed turns after what tows it.

use endless_world::math::f64::{atan, exp, tan, wrap_angle};

/// Length of the drawbar over the wheelbase: the point that follows a lane is this share of the wheelbase ahead of the
/// rear axle.
pub const DRAWBAR: f64 = 0.85;

/// Heading of what is drawn by a bar when the bar's front has come some metres in direction `pull`, radians: the exact solution of
/// the drawbar's equation for a straight piece of way.
pub fn towed_heading(yaw: f64, pull: f64, way_m: f64, drawbar_m: f64) -> f64 {
    let before = wrap_angle(pull - yaw).clamp(-1.2, 1.2);
    wrap_angle(pull - 2.0 * atan(tan(0.5 * before) * exp(-way_m / drawbar_m)))
}
