//! How the body sits on its wheels: it nods when braked and leans out of bends; two-wheelers lean into them.
//!
//! Springs and dampers of one degree of freedom each about the pitch and the roll axis (Gillespie, "Fundamentals of
//! Vehicle Dynamics", chapter 5), driven by the accelerations. The body's motion does not act back on the wheels.

use super::GRAVITY_MPS2;
use super::parameters::Parameters;
use endless_world::math::f64::atan;
use glam::DVec2;

/// Of the body on its springs, rad/s.
const FREQUENCY: f64 = 8.0;
/// Share of critical damping.
const DAMPING: f64 = 0.5;
/// Radians of pitch per m/s² ahead: a full braking lowers the nose by about two degrees.
const PITCH: f64 = 0.0040;
/// Radians of roll per m/s² aside.
const ROLL: f64 = 0.0055;

/// Turn of the body against the plane of its wheels.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Suspension {
    /// Pitch (nose up) and roll (left side up), radians.
    pub(super) angles: DVec2,
    /// rad/s.
    pub(super) rates: DVec2,
}

impl Suspension {
    /// Goes on by `dt_s` under an acceleration forwards and to the left, m/s².
    pub(super) fn step(&mut self, p: &Parameters, acceleration: DVec2, dt_s: f64) {
        let a = acceleration.clamp(DVec2::splat(-12.0), DVec2::splat(12.0));
        // To the left is a lean to the right, which is positive, but riders lean to where they turn.
        let roll = if p.leans { -atan(a.y / GRAVITY_MPS2) } else { ROLL * p.softness * a.y };
        let target = DVec2::new(PITCH * p.softness * a.x, roll);
        self.rates +=
            ((target - self.angles) * (FREQUENCY * FREQUENCY) - self.rates * (2.0 * DAMPING * FREQUENCY)) * dt_s;
        self.angles += self.rates * dt_s;
    }
}
