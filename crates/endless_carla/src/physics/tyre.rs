//! How tyres grip.
//!
//! Lateral force over slip angle is the sine and arc tangent of Pacejka's magic formula without curvature and offsets
//! ("Tyre and Vehicle Dynamics", 2012, section 4.3), with the stiffness proportional to the load. Force along and across
//! share a friction circle.

use super::GRAVITY_MPS2;
use endless_world::math::f64::{atan, sin};

/// Shape factor of the lateral force: it falls to 0.8 of its peak when the tyre slides straight across.
const SHAPE: f64 = 1.4;
/// A tyre's stiffness per load and radian for one of CARLA's `lat_stiff_value`, for which 17 to 20 are usual.
const STIFFNESS: f64 = 0.75;

/// PhysX's default for CARLA's `long_stiff_value`.
pub(super) const USUAL_LONG_STIFFNESS: f64 = 1000.0;

/// Coefficient of friction of a tyre for CARLA's `tire_friction`.
///
/// CARLA's number is none: 2 is its default and 3.5 that of most of its cars, which brake at hardly more than 1 g. This
/// is nothing at 0, about as much as the number while it is small, 0.97 at 3.5 and never more than 1.25.
pub(super) fn friction_coefficient(tire_friction: f64) -> f64 {
    1.25 * tire_friction / (1.0 + tire_friction)
}

/// Lateral force as a share of the load, at a slip angle in 0 to π/2, radians.
pub(super) fn lateral_share(slip_rad: f64, friction: f64, lat_stiff_value: f64) -> f64 {
    if friction <= 1e-9 {
        return 0.0;
    }
    let steepness = STIFFNESS * lat_stiff_value / (SHAPE * friction);
    friction * sin(SHAPE * atan(steepness * slip_rad))
}

/// Share of an engine's force, newtons a wheel, that a tyre of CARLA's `long_stiff_value` passes on: the softer it is, the faster
/// it must turn than it rolls to do so (PhysX's stiffness, newtons per slip and m/s² of gravity), and the less of the engine's
/// power moves the vehicle. What the usual tyre loses is among the losses of all vehicles.
pub(super) fn passed_on(force_n: f64, long_stiff_value: f64) -> f64 {
    let slip = |stiffness: f64| force_n.abs() / (GRAVITY_MPS2 * stiffness.max(1e-9));
    let more = slip(long_stiff_value) - slip(USUAL_LONG_STIFFNESS);
    1.0 / (1.0 + more.max(0.0))
}

/// What is left across of a limit of which `along` is used.
pub(super) fn left_across(limit: f64, along: f64) -> f64 {
    (limit * limit - along * along).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn soft_tyres_lose_more_of_the_engines_power() {
        assert_eq!([1000.0, 2000.0].map(|stiffness| passed_on(2000.0, stiffness)), [1.0, 1.0]);
        assert_eq!(passed_on(0.0, 100.0), 1.0);
        let [half, tenth] = [500.0, 100.0].map(|stiffness| passed_on(2000.0, stiffness));
        assert!(tenth < half && half < 1.0 && tenth > 0.2, "{half} {tenth}");
        assert!(passed_on(2000.0, 0.0) < 1e-6);
    }

    #[test]
    fn grips_as_tyres_do() {
        let friction = friction_coefficient(3.5);
        assert!((0.95..1.0).contains(&friction));
        assert_eq!(friction_coefficient(0.0), 0.0);
        // A degree of slip gives about a fifth of the load; the peak is at some degrees, and is the friction.
        let share = |degrees: f64| lateral_share(degrees.to_radians(), friction, 17.0);
        assert!((0.18..0.26).contains(&share(1.0)), "{}", share(1.0));
        let peak = (0..90).map(|degrees| share(degrees.into())).fold(0.0, f64::max);
        assert!(peak <= friction && peak > 0.99 * friction);
        assert!(share(90.0) < 0.9 * peak && share(90.0) > 0.75 * peak);
    }
}
