//! Feet of a body: where the ankle is over a foot, and feet in a steady walk.

use super::skeleton::{Bone, Side, Skeleton};
use endless_world::math::UnfusedQuat;
use endless_world::walking::{StepPhase, duty_factor, foot_home};
use endless_world::{FootPlace, math};
use glam::{Quat, Vec3};

/// The ankle of a foot.
pub(crate) fn ankle(foot: &FootPlace, skeleton: &Skeleton) -> Vec3 {
    let a = skeleton.joint(Bone::FootL);
    let pivot = if foot.pitch_rad < 0.0 { -skeleton.heel } else { skeleton.joint(Bone::ToesL).x - a.x };
    // About the heel's edge, or about the ball, whose joint stays.
    let below = if foot.pitch_rad < 0.0 { 0.0 } else { skeleton.joint(Bone::ToesL).z };
    let turned = Quat::from_rotation_y(foot.pitch_rad).rotate_unfused(Vec3::new(-pivot, 0.0, a.z - below));
    let local = Vec3::new(pivot + turned.x, 0.0, turned.z + below + foot.lift_m);
    let (sin, cos) = math::sin_cos(foot.yaw_rad);
    Vec3::new(foot.at[0] + local.x * cos, foot.at[1] + local.x * sin, local.z)
}

/// A foot in a steady walk: `phase` is its own, the speed that of somebody of average height.
pub(crate) fn steady(
    phase: f32,
    side: Side,
    skeleton: &Skeleton,
    speed_mps: f32,
    stride: f32,
    vigour: f32,
) -> FootPlace {
    let duty = duty_factor(speed_mps);
    let step = StepPhase::of(phase, duty);
    let (home, yaw) = foot_home(skeleton.height, side.sign(), speed_mps);
    let reach = 0.5 * duty * stride;
    let x = match step {
        StepPhase::Stance(u) => reach * (1.0 - 2.0 * u),
        StepPhase::Swing(u) => reach * (2.0 * StepPhase::forward(u) - 1.0),
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
