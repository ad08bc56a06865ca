//! The path of a foot through a step, and the law by which steps lengthen with speed.

use crate::math;
use glam::Vec2;
use std::f32::consts::PI;

/// The sign of y in the object frame of the left and of the right side of a body, in the order in which feet are listed.
pub const SIDES: [f32; 2] = [1.0, -1.0];

/// Phase of a foot in the step cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StepPhase {
    /// On the ground, from strike (0) to push (1).
    Stance(f32),
    /// In the air, from push (0) to strike (1).
    Swing(f32),
}

/// The speed (m/s) at which somebody of average height moves like a person of a height (metres) at a speed: of equal
/// Froude number.
pub fn average_speed_mps(height_m: f32, speed_mps: f32) -> f32 {
    speed_mps * (1.72 / height_m).sqrt()
}

/// Share of walking (0) and running (1) at a speed, for people of average height.
pub fn running_share(speed_mps: f32) -> f32 {
    math::smoothstep(1.95, 2.5, speed_mps)
}

/// Share of the cycle that a foot is on the ground, for people of average height.
pub fn duty_factor(speed_mps: f32) -> f32 {
    math::lerp(0.62, 0.38, running_share(speed_mps))
}

/// Length of two steps, metres: steps grow with the root of speed, as their rate does (the constant walk ratio of Sekiya
/// and Nagasaki 1998), and with stature.
pub fn stride_m(height_m: f32, speed_mps: f32) -> f32 {
    let v = speed_mps.max(0.12);
    2.0 * 0.355 * height_m * v.sqrt() * (1.75 / height_m).sqrt().sqrt()
}

/// Where a foot stands at ease, metres in the person's object frame, and its heading, radians: a little outside the hip,
/// toes a little out. `side` is the sign of y ([`SIDES`]), the speed that of somebody of average height.
pub fn foot_home(height_m: f32, side: f32, speed_mps: f32) -> (Vec2, f32) {
    let wide = math::lerp(0.058, 0.034, math::smoothstep(0.1, 1.0, speed_mps));
    // Under way the middle of the foot, not the ankle, swings about the hip.
    let back = math::lerp(0.006, 0.034, math::smoothstep(0.1, 1.0, speed_mps));
    (Vec2::new(-back, wide * side) * height_m, math::lerp(0.16, 0.09, running_share(speed_mps)) * side)
}

impl StepPhase {
    /// The phase at a position in the cycle (0 to 1) of a foot that is on the ground for a share of it.
    pub fn of(phase: f32, duty_factor: f32) -> Self {
        if phase < duty_factor {
            Self::Stance(phase / duty_factor)
        } else {
            Self::Swing((phase - duty_factor) / (1.0 - duty_factor))
        }
    }

    /// Share of the way forward that is done at a share of the swing.
    pub fn forward(swing: f32) -> f32 {
        swing * swing * (3.0 - 2.0 * swing)
    }

    /// Lift over the stature, pitch and bend of the toes (radians). `vigour` is 1 at a comfortable speed, 0 at rest.
    pub fn roll(self, speed_mps: f32, vigour: f32) -> (f32, f32, f32) {
        let run = running_share(speed_mps);
        let strike = math::lerp(-0.30, -0.12, run) * vigour;
        let push = math::lerp(0.62, 0.80, run) * vigour;
        match self {
            Self::Stance(u) => {
                let pitch = strike * (1.0 - math::smoothstep(0.0, 0.17, u)) + push * math::smoothstep(0.52, 1.0, u);
                (0.0, pitch, pitch.max(0.0))
            }
            Self::Swing(u) => {
                let height = math::lerp(0.012 + 0.016 * vigour, 0.13, run);
                let lift = height * math::sin(PI * u) * (1.0 + 0.5 * math::cos(PI * u));
                let pitch = math::lerp(push, strike, math::smoothstep(0.0, 0.85, u));
                (lift, pitch, push * (1.0 - math::smoothstep(0.0, 0.4, u)))
            }
        }
    }
}
