//! The drawbar equation: how what is towed turns after what tows it.

use endless_world::math::f64::{atan, exp, tan, wrap_angle};

/// Length of the drawbar over the wheelbase: the point that follows a lane is this share of the wheelbase ahead of the
/// rear axle.
pub const DRAWBAR: f64 = 0.85;

/// Who is pushed straight back would turn to neither side, radians.
const MOST_ANGLE: f64 = std::f64::consts::PI - 1e-6;

/// Heading of what is drawn by a bar when the bar's front has come some metres in direction `pull`, radians: the exact solution of
/// the drawbar's equation for a straight piece of way.
pub fn towed_heading(yaw: f64, pull: f64, way_m: f64, drawbar_m: f64) -> f64 {
    let before = wrap_angle(pull - yaw).clamp(-MOST_ANGLE, MOST_ANGLE);
    wrap_angle(pull - 2.0 * atan(tan(0.5 * before) * exp(-way_m / drawbar_m)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is hardly moved hardly turns, wherever it is pulled.
    #[test]
    fn a_small_step_turns_little() {
        for k in -30..=30 {
            let pull = 0.1 * f64::from(k);
            let turned = wrap_angle(towed_heading(0.4, pull, 1e-3, 2.5) - 0.4).abs();
            assert!(turned < 1e-3, "{pull} {turned}");
        }
    }
}
