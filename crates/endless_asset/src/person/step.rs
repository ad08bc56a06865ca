//! One foot's way through a step, and the law by which steps lengthen with speed.

use super::skeleton::{Bone, Side, Skeleton};
use endless_world::{FootPlace, math};
use glam::{Quat, Vec2, Vec3};
use std::f32::consts::PI;

/// Where in its cycle a foot is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Step {
    /// On the ground, from strike (0) to push (1).
    Stance(f32),
    /// In the air, from push (0) to strike (1).
    Swing(f32),
}

/// The speed at which somebody of average height moves alike (equal Froude number).
pub(crate) fn alike(height: f32, speed_mps: f32) -> f32 {
    speed_mps * (1.72 / height).sqrt()
}

/// Share of walking (0) and running (1) at a speed; this and what follows are for people of average height.
pub(crate) fn running(speed_mps: f32) -> f32 {
    math::smoothstep(1.95, 2.5, speed_mps)
}

/// Share of the cycle that a foot is on the ground.
pub(crate) fn duty(speed_mps: f32) -> f32 {
    math::lerp(0.62, 0.38, running(speed_mps))
}

/// Two steps, metres: steps grow with the root of speed, as their rate does (the constant walk ratio of Sekiya and
/// Nagasaki 1998), and with stature.
pub(crate) fn stride(height: f32, speed_mps: f32) -> f32 {
    let v = speed_mps.max(0.12);
    2.0 * 0.355 * height * v.sqrt() * (1.75 / height).sqrt().sqrt()
}

impl Step {
    /// Of a phase in 0..1.
    pub(crate) fn of(phase: f32, duty: f32) -> Self {
        if phase < duty { Self::Stance(phase / duty) } else { Self::Swing((phase - duty) / (1.0 - duty)) }
    }

    /// Share of the way forward that is done.
    pub(crate) fn forward(u: f32) -> f32 {
        u * u * (3.0 - 2.0 * u)
    }

    /// Lift over the stature, pitch and toes. `vigour` is 1 at a comfortable speed, 0 at rest.
    pub(crate) fn roll(self, speed_mps: f32, vigour: f32) -> (f32, f32, f32) {
        let run = running(speed_mps);
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

/// The ankle of a foot.
pub(crate) fn ankle(foot: &FootPlace, skeleton: &Skeleton) -> Vec3 {
    let a = skeleton.joint(Bone::FootL);
    let pivot = if foot.pitch_rad < 0.0 { -skeleton.heel } else { skeleton.joint(Bone::ToesL).x - a.x };
    // About the heel's edge, or about the ball, whose joint stays.
    let below = if foot.pitch_rad < 0.0 { 0.0 } else { skeleton.joint(Bone::ToesL).z };
    let turned = Quat::from_rotation_y(foot.pitch_rad) * Vec3::new(-pivot, 0.0, a.z - below);
    let local = Vec3::new(pivot + turned.x, 0.0, turned.z + below + foot.lift_m);
    let (sin, cos) = math::sin_cos(foot.yaw_rad);
    Vec3::new(foot.at[0] + local.x * cos, foot.at[1] + local.x * sin, local.z)
}

/// Where a foot stands at ease: a little outside the hip, toes a little out.
pub(crate) fn home(height: f32, side: Side, speed_mps: f32) -> (Vec2, f32) {
    let wide = math::lerp(0.058, 0.034, math::smoothstep(0.1, 1.0, speed_mps));
    // Under way the middle of the foot, not the ankle, swings about the hip.
    let back = math::lerp(0.006, 0.034, math::smoothstep(0.1, 1.0, speed_mps));
    (Vec2::new(-back, wide * side.sign()) * height, math::lerp(0.16, 0.09, running(speed_mps)) * side.sign())
}

/// A foot in a steady walk: `phase` is its own.
pub(crate) fn steady(
    phase: f32,
    side: Side,
    skeleton: &Skeleton,
    speed_mps: f32,
    stride: f32,
    vigour: f32,
) -> FootPlace {
    let duty = duty(speed_mps);
    let step = Step::of(phase, duty);
    let (home, yaw) = home(skeleton.height, side, speed_mps);
    let reach = 0.5 * duty * stride;
    let x = match step {
        Step::Stance(u) => reach * (1.0 - 2.0 * u),
        Step::Swing(u) => reach * (2.0 * Step::forward(u) - 1.0),
    };
    let (lift, pitch, toes) = step.roll(speed_mps, vigour);
    FootPlace {
        at: [home.x + x, home.y],
        yaw_rad: yaw,
        lift_m: lift * skeleton.height,
        pitch_rad: pitch,
        toes_rad: toes,
    }
}
