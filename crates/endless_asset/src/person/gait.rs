//! Standing, walking and running.

use super::look::{Carried, Look};
use super::posture::{Arm, Leg, Posture};
use super::skeleton::{Bone, Side, Skeleton};
use endless_world::{Gait, Stream, WalkerMotion, math};
use glam::{Quat, Vec3};
use std::f32::consts::{PI, TAU};

/// A person's way of moving.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Habit {
    pub(crate) walk_mps: f32,
    /// Two steps, metres. It depends on height and habit but not on the speed of the moment: the phase is the distance
    /// walked over the stride, and a stride that changed on the way would make the legs jump.
    walk_stride: f32,
    run_stride: f32,
    /// Phase at distance 0, so that a crowd is out of step.
    pub(crate) offset: f32,
    swing: f32,
    elbow: f32,
    slouch: f32,
    /// Holds a telephone before them while standing.
    phone: bool,
    /// Carries a bag in the left hand: that arm hangs still.
    bag: bool,
}

impl Habit {
    pub(crate) fn new(variant: u64, look: &Look) -> Self {
        let mut s = Stream::named(variant, "gait", &[]);
        let brisk = (1.0 + 0.1 * s.normal() as f32).clamp(0.78, 1.25);
        Self {
            walk_mps: 1.36 * brisk * (look.height / 1.7).sqrt(),
            walk_stride: 0.76 * look.height * (0.5 + 0.5 * brisk),
            run_stride: 1.25 * look.height,
            offset: s.f32(),
            swing: s.range_f32(0.7, 1.15),
            elbow: s.range_f32(0.12, 0.42),
            slouch: s.range_f32(-0.02, 0.10),
            phone: s.chance(0.18),
            bag: matches!(look.carried, Carried::Handbag | Carried::ShoppingBag),
        }
    }

    /// Length of two steps at a gait, metres.
    pub(crate) fn stride(&self, gait: Gait) -> f32 {
        if gait == Gait::Run { self.run_stride } else { self.walk_stride }
    }
}

/// What distinguishes running from walking.
struct Style {
    /// Share of the cycle that a foot is on the ground.
    duty: f32,
    strike: f32,
    push: f32,
    lift: f32,
    crouch: f32,
    lean: f32,
    arms: f32,
    elbow: f32,
}

const WALK: Style =
    Style { duty: 0.62, strike: -0.30, push: 0.72, lift: 0.035, crouch: 0.985, lean: 0.03, arms: 0.42, elbow: 0.0 };
const RUN: Style =
    Style { duty: 0.36, strike: -0.10, push: 0.85, lift: 0.16, crouch: 0.93, lean: 0.14, arms: 0.75, elbow: 1.35 };

/// The posture at an instant.
pub(crate) fn posture(motion: &WalkerMotion, skeleton: &Skeleton, habit: &Habit) -> Posture {
    match motion.gait {
        Gait::Stand => standing(motion.time_s, skeleton, habit),
        Gait::Walk => moving(motion, skeleton, habit, &WALK),
        Gait::Run => moving(motion, skeleton, habit, &RUN),
    }
}

fn standing(time_s: f32, skeleton: &Skeleton, habit: &Habit) -> Posture {
    let h = skeleton.height;
    let phase = habit.offset * TAU;
    let shift = math::sin(0.31 * time_s + phase);
    let breath = math::sin(1.6 * time_s + phase);
    let foot = skeleton.joint(Bone::FootL);
    let leg = |side: Side| Leg {
        ankle: Vec3::new(
            foot.x + 0.012 * h * side.sign() * math::sin(phase),
            (foot.y + 0.012 * h) * side.sign(),
            foot.z,
        ),
        pitch: 0.0,
        knee: Vec3::new(1.0, 0.22 * side.sign(), 0.0),
    };
    let rest = skeleton.joint(Bone::Pelvis);
    let arm = |sign: f32| Arm::Swing {
        forward: 0.04 + 0.03 * math::sin(0.4 * time_s + phase * sign),
        outward: 0.13,
        elbow: 0.5 * habit.elbow + 0.08,
    };
    let right = if habit.phone { Arm::Swing { forward: 0.35, outward: 0.02, elbow: 1.65 } } else { arm(2.0) };
    Posture {
        pelvis: Vec3::new(rest.x, 0.018 * h * shift, rest.z - 0.006 * h),
        pelvis_turn: Quat::from_rotation_x(0.035 * shift),
        spine: Quat::from_rotation_x(-0.045 * shift) * Quat::from_rotation_y(habit.slouch * 0.5),
        chest: Quat::from_rotation_y(0.4 * habit.slouch - 0.012 * breath),
        head: Quat::from_rotation_z(0.35 * math::sin(0.17 * time_s + 2.0 * phase))
            * Quat::from_rotation_y(if habit.phone { 0.42 } else { 0.02 }),
        arms: [arm(1.0), right],
        legs: Side::BOTH.map(leg),
    }
}

/// One foot at its phase: ankle relative to the hip's vertical, ankle height, pitch.
fn foot_at(phase: f32, stride: f32, skeleton: &Skeleton, style: &Style) -> (f32, f32, f32) {
    let ankle = skeleton.joint(Bone::FootL).z;
    let middle = 0.5 * style.duty;
    // On the ground the foot stays where it is in the world: backwards under the body by the distance walked.
    let planted = |u: f32| {
        let x = stride * (middle - style.duty * u);
        let strike = style.strike * (1.0 - math::smoothstep(0.0, 0.16, u));
        let push = style.push * math::smoothstep(0.52, 1.05, u);
        let pitch = strike + push;
        // It rolls over the heel, then over the toes.
        let pivot = if pitch < 0.0 { -skeleton.heel } else { skeleton.toe * 0.82 };
        let (sin, cos) = math::sin_cos(pitch);
        let (px, pz) = (-pivot, ankle);
        (x + pivot + px * cos + pz * sin, -px * sin + pz * cos, pitch)
    };
    if phase < style.duty {
        return planted(phase / style.duty);
    }
    let u = (phase - style.duty) / (1.0 - style.duty);
    let (a, b) = (planted(1.0), planted(0.0));
    let t = u * u * (3.0 - 2.0 * u);
    let arc = math::sin(PI * u);
    let lift = style.lift * skeleton.height * arc * (1.0 + 0.5 * math::cos(PI * u));
    let pitch = math::lerp(a.2, b.2, math::smoothstep(0.0, 0.85, u));
    (math::lerp(a.0, b.0, t), math::lerp(a.1, b.1, t) + lift, pitch)
}

fn moving(motion: &WalkerMotion, skeleton: &Skeleton, habit: &Habit, style: &Style) -> Posture {
    let stride = habit.stride(motion.gait);
    let cycle = motion.walked_m / stride + habit.offset;
    let phase = [cycle - cycle.floor(), (cycle + 0.5) - (cycle + 0.5).floor()];
    let feet = phase.map(|p| foot_at(p, stride, skeleton, style));
    let h = skeleton.height;
    // Slow steps swing less.
    let vigour = (0.55 + 0.45 * motion.speed_mps / habit.walk_mps).clamp(0.55, 1.2);
    let wave = math::cos(TAU * phase[0]);
    let sway = math::sin(TAU * (phase[0] - 0.06));
    let hip = skeleton.joint(Bone::ThighL);
    let pelvis_rest = skeleton.joint(Bone::Pelvis);
    let reach = (hip - skeleton.joint(Bone::ShinL)).length()
        + (skeleton.joint(Bone::ShinL) - skeleton.joint(Bone::FootL)).length();
    let turn = 0.10 * vigour;
    // As high as both legs allow.
    let mut hip_z = hip.z * style.crouch;
    for (i, foot) in feet.iter().enumerate() {
        let ahead = if i == 0 { wave } else { -wave };
        let dx = foot.0 - turn * ahead * hip.y;
        let r = 0.992 * reach;
        hip_z = hip_z.min(foot.1 + (r * r - dx * dx).max(0.1 * r * r).sqrt());
    }
    let leg = |side: Side| {
        let foot = feet[usize::from(side == Side::Right)];
        Leg {
            ankle: Vec3::new(foot.0, 0.72 * hip.y * side.sign(), foot.1),
            pitch: foot.2,
            knee: Vec3::new(1.0, 0.06 * side.sign(), 0.0),
        }
    };
    let arm = |ahead: f32| {
        let forward = style.arms * habit.swing * vigour * ahead;
        Arm::Swing {
            forward: forward + 0.02,
            outward: 0.12,
            elbow: habit.elbow + style.elbow + 0.22 * (1.0 + ahead) * vigour,
        }
    };
    Posture {
        pelvis: Vec3::new(0.0, 0.012 * h * sway, hip_z + pelvis_rest.z - hip.z),
        pelvis_turn: Quat::from_rotation_z(-turn * wave)
            * Quat::from_rotation_x(0.03 * sway)
            * Quat::from_rotation_y(0.3 * style.lean),
        spine: Quat::from_rotation_z(0.6 * turn * wave) * Quat::from_rotation_y(0.5 * style.lean + 0.5 * habit.slouch),
        chest: Quat::from_rotation_z(1.3 * turn * wave)
            * Quat::from_rotation_y(0.4 * habit.slouch)
            * Quat::from_rotation_x(-0.03 * sway),
        head: Quat::from_rotation_z(-0.9 * turn * wave) * Quat::from_rotation_y(-0.5 * habit.slouch - 0.6 * style.lean),
        arms: [
            if habit.bag { Arm::Swing { forward: -0.10 * wave, outward: 0.16, elbow: 0.10 } } else { arm(-wave) },
            arm(wave),
        ],
        legs: Side::BOTH.map(leg),
    }
}
