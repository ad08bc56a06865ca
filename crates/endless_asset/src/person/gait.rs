//! From what a person does to how their body stands: trunk, arms and head over the feet.

use super::appearance::{Appearance, Carried};
use super::posture::{Arm, Leg, Posture};
use super::skeleton::{Bone, Side, Skeleton};
use super::step;
use super::{hold, wheeled};
use endless_world::math::UnfusedQuat;
use endless_world::walking::{Mobility, PedestrianSpec, average_speed_mps, foot_home, running_share, stride_m};
use endless_world::{FootPlace, Gait, Stream, WalkerMotion, math};
use glam::{Quat, Vec3};
use std::f32::consts::TAU;

/// A person's way of moving.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GaitStyle {
    pub(crate) walk_mps: f32,
    /// Phase at distance 0, so that a crowd is out of step.
    pub(crate) offset: f32,
    swing: f32,
    elbow: f32,
    /// Forward bend of the upper back, radians; old people stoop.
    pub(crate) slouch: f32,
    /// One of several ways to stand about.
    pub(crate) manner: usize,
    pub(crate) carried: Carried,
}

/// Younger people go with somebody, older ones seldom run.
const JOGGING_AGES: std::ops::Range<f32> = 15.0..66.0;
/// Who carries anything else would have it in the bench, or on their knees; who is smaller does not sit with their feet on the
/// ground, metres.
const HANDS_FREE: [Carried; 3] = [Carried::Nothing, Carried::Phone, Carried::Call];
const SITS_FROM_M: f32 = 1.5;

impl GaitStyle {
    pub(crate) fn new(variant: u64, appearance: &Appearance) -> Self {
        let mut s = Stream::named(variant, "gait", &[]);
        let brisk = (1.0 + 0.1 * s.normal() as f32).clamp(0.8, 1.22);
        let old = math::smoothstep(60.0, 85.0, appearance.age);
        let burden = match appearance.carried {
            Carried::Cane => 0.72,
            Carried::Suitcase | Carried::Pram | Carried::Wheelchair => 0.92,
            _ => 1.0,
        };
        Self {
            walk_mps: 1.36 * brisk * (appearance.height / 1.7).sqrt() * (1.0 - 0.2 * old) * burden,
            offset: s.f32(),
            swing: s.range_f32(0.75, 1.15),
            elbow: s.range_f32(0.16, 0.42),
            slouch: s.range_f32(-0.02, 0.10) + 0.26 * old,
            manner: s.below(6),
            carried: appearance.carried,
        }
    }

    /// What traffic needs to know of somebody of these looks.
    pub(crate) fn spec(&self, appearance: &Appearance) -> PedestrianSpec {
        let mobility = match appearance.carried {
            Carried::Wheelchair => Mobility::Wheelchair,
            Carried::Pram => Mobility::Pram,
            Carried::Cane | Carried::Suitcase => Mobility::Encumbered,
            _ => Mobility::Agile,
        };
        let empty_handed = appearance.carried == Carried::Nothing;
        PedestrianSpec {
            height_m: appearance.height,
            walk_mps: self.walk_mps,
            step_phase: self.offset,
            mobility,
            sits_down: HANDS_FREE.contains(&appearance.carried) && appearance.height > SITS_FROM_M,
            dressed_to_run: appearance.outfit == "sports" && empty_handed && JOGGING_AGES.contains(&appearance.age),
        }
    }

    /// The speed that a gait's stride is for, when no steps are given.
    fn pace(&self, gait: Gait, height: f32) -> f32 {
        match gait {
            Gait::Run => 3.0 * (height / 1.72).sqrt(),
            Gait::Hurry => (1.35 * self.walk_mps).min(1.9 * (height / 1.72).sqrt()),
            Gait::Push => 0.9 * self.walk_mps,
            _ => self.walk_mps,
        }
    }

    /// Length of two steps at a gait, metres.
    pub(crate) fn stride(&self, gait: Gait, height: f32) -> f32 {
        stride_m(height, self.pace(gait, height))
    }
}

/// Phase of the left foot and both feet.
fn feet(motion: &WalkerMotion, skeleton: &Skeleton, habit: &GaitStyle) -> (f32, [FootPlace; 2]) {
    if let Some(footing) = motion.footing {
        return (footing.phase, footing.feet);
    }
    let still = matches!(motion.gait, Gait::Stand | Gait::Idle | Gait::Wait | Gait::Talk | Gait::Sit);
    if still {
        let feet = Side::BOTH.map(|side| {
            let (at, yaw_rad) = foot_home(skeleton.height, side.sign(), 0.0);
            // One foot a little ahead.
            let ahead = 0.022 * skeleton.height * side.sign() * math::sin(habit.offset * TAU);
            FootPlace { at: [at.x + ahead, at.y], yaw_rad, ..FootPlace::default() }
        });
        return (0.0, feet);
    }
    let stride = habit.stride(motion.gait, skeleton.height);
    let cycle = motion.walked_m / stride + habit.offset;
    let pace = habit.pace(motion.gait, skeleton.height);
    let feet = Side::BOTH.map(|side| {
        let phase = cycle + 0.5 * side.index() as f32;
        step::steady(phase - phase.floor(), side, skeleton, average_speed_mps(skeleton.height, pace), stride, 1.0)
    });
    (cycle - cycle.floor(), feet)
}

/// The posture at an instant of who is on their feet, or in a wheelchair.
pub(crate) fn posture(motion: &WalkerMotion, skeleton: &Skeleton, habit: &GaitStyle) -> Posture {
    if habit.carried == Carried::Wheelchair {
        return rolling(motion, skeleton, habit);
    }
    upright(motion, skeleton, habit)
}

/// On both feet.
fn upright(motion: &WalkerMotion, skeleton: &Skeleton, habit: &GaitStyle) -> Posture {
    let (phase, feet) = feet(motion, skeleton, habit);
    let h = skeleton.height;
    let speed = motion.speed_mps;
    // 0 standing, 1 under way.
    let go = math::smoothstep(0.12, 0.75, speed);
    let vigour = (0.45 + 0.55 * speed / habit.walk_mps).clamp(0.45, 1.25) * go;
    let run = running_share(average_speed_mps(h, speed));
    let wave = math::cos(TAU * phase);
    let sway = math::sin(TAU * (phase - 0.06));
    let own = habit.offset * TAU;
    let (shift, breath) = (math::sin(0.31 * motion.time_s + own), math::sin(1.6 * motion.time_s + own));
    let rest = 1.0 - go;
    let turn = math::lerp(0.09, 0.14, run) * vigour;
    let lean = math::lerp(0.02 * vigour, 0.15, run);

    let ankles = feet.map(|f| step::ankle(&f, skeleton));
    let hip = skeleton.joint(Bone::ThighL);
    let pelvis_rest = skeleton.joint(Bone::Pelvis);
    let reach = (hip - skeleton.joint(Bone::ShinL)).length()
        + (skeleton.joint(Bone::ShinL) - skeleton.joint(Bone::FootL)).length();
    let side_shift = (0.013 * sway * go + 0.016 * shift * rest) * h;
    let pelvis_turn = Quat::from_rotation_z(-turn * wave)
        * Quat::from_rotation_x(0.03 * sway * go + 0.035 * shift * rest)
        * Quat::from_rotation_y(0.3 * lean);
    // As high as both legs allow.
    let upright = hip.z * math::lerp(math::lerp(0.994, 0.988, go), 0.945, run);
    let mut pelvis_z = upright + pelvis_rest.z - hip.z;
    for side in Side::BOTH {
        let ankle = ankles[side.index()];
        let joint = pelvis_turn.rotate_unfused(side.flip(hip) - pelvis_rest);
        let (dx, dy) = (ankle.x - joint.x, ankle.y - side_shift - joint.y);
        let r = 0.995 * reach;
        pelvis_z = pelvis_z.min(ankle.z + (r * r - dx * dx - dy * dy).max(0.1 * r * r).sqrt() - joint.z);
    }
    let legs = Side::BOTH.map(|side| {
        let (foot, ankle) = (feet[side.index()], ankles[side.index()]);
        let out = 0.06 * side.sign() + 0.8 * foot.yaw_rad;
        Leg { ankle, pitch: foot.pitch_rad, knee: Vec3::new(1.0, out, 0.0), yaw: foot.yaw_rad, toes: foot.toes_rad }
    });
    let arms = Side::BOTH.map(|side| {
        let ahead = if side == Side::Left { -wave } else { wave };
        let amount = math::lerp(0.40, 0.75, run) * habit.swing * vigour;
        let drift = 0.03 * math::sin(0.4 * motion.time_s + own * (1.5 + side.sign()));
        Arm::Swing {
            forward: amount * ahead + 0.02 + rest * drift,
            outward: 0.10 + 0.03 * rest + 0.06 * run,
            elbow: habit.elbow * (0.5 + 0.5 * go) + 0.08 * rest + 1.35 * run + 0.20 * (1.0 + ahead) * vigour,
        }
    });
    let mut posture = Posture {
        pelvis: Vec3::new(0.0, side_shift, pelvis_z),
        pelvis_turn,
        spine: Quat::from_rotation_z(0.6 * turn * wave)
            * Quat::from_rotation_x(-0.045 * shift * rest)
            * Quat::from_rotation_y(0.5 * lean + 0.5 * habit.slouch),
        chest: Quat::from_rotation_z(1.3 * turn * wave)
            * Quat::from_rotation_y(0.5 * habit.slouch - 0.012 * breath * rest)
            * Quat::from_rotation_x(-0.03 * sway * go),
        head: Quat::from_rotation_z(-0.9 * turn * wave + 0.30 * rest * math::sin(0.17 * motion.time_s + 2.0 * own))
            * Quat::from_rotation_y(0.03 - 0.7 * habit.slouch - 0.6 * lean),
        arms,
        legs,
    };
    act(&mut posture, motion, skeleton, habit, rest);
    hold::hold(&mut posture, &feet, skeleton, habit.carried);
    posture
}

/// What people do with head and arms while they stand.
fn act(posture: &mut Posture, motion: &WalkerMotion, skeleton: &Skeleton, habit: &GaitStyle, rest: f32) {
    if rest < 0.02 {
        return;
    }
    let (t, own) = (motion.time_s, habit.offset * TAU);
    let (h, b) = (skeleton.height, skeleton.body);
    let beat = |rate: f32, k: f32| math::sin(rate * t + k * own);
    let toward = |arm: Arm, wanted: Arm| match (arm, wanted) {
        (Arm::Swing { forward, outward, elbow }, Arm::Swing { forward: f, outward: o, elbow: e }) => Arm::Swing {
            forward: math::lerp(forward, f, rest),
            outward: math::lerp(outward, o, rest),
            elbow: math::lerp(elbow, e, rest),
        },
        (a, b) => {
            if rest > 0.5 {
                b
            } else {
                a
            }
        }
    };
    let hip = |side: Side| Arm::Reach(Vec3::new(0.03 * h, 0.105 * h * side.sign(), 0.585 * b));
    match motion.gait {
        Gait::Talk => {
            let gesture = |k: f32| Arm::Swing {
                forward: 0.30 + 0.16 * beat(1.9, k),
                outward: 0.16 + 0.10 * beat(1.3, k + 1.0),
                elbow: 1.25 + 0.40 * beat(2.3, k),
            };
            posture.arms[0] = toward(posture.arms[0], gesture(1.0));
            if habit.manner.is_multiple_of(2) {
                posture.arms[1] = toward(posture.arms[1], gesture(2.6));
            }
            posture.head *= Quat::from_rotation_y(0.07 * rest * beat(2.1, 1.7));
        }
        Gait::Wait => {
            // Left and right, as before a road.
            posture.head = Quat::from_rotation_z(0.75 * rest * beat(0.55, 1.0)) * posture.head;
            match habit.manner {
                0 => posture.arms = Side::BOTH.map(hip),
                // Hands in pockets.
                1 | 2 => {
                    posture.arms =
                        posture.arms.map(|a| toward(a, Arm::Swing { forward: -0.08, outward: 0.17, elbow: 0.55 }));
                }
                _ => {}
            }
        }
        Gait::Idle | Gait::Stand => match habit.manner {
            0 => posture.arms[1] = hip(Side::Right),
            1 => {
                // Arms folded.
                posture.arms = Side::BOTH.map(|s| {
                    let raised = if s == Side::Left { 0.655 } else { 0.675 };
                    Arm::Reach(Vec3::new(0.098 * h, -0.055 * h * s.sign(), raised * b))
                });
            }
            2 => {
                posture.arms =
                    posture.arms.map(|a| toward(a, Arm::Swing { forward: -0.06, outward: 0.16, elbow: 0.5 }));
            }
            _ => {}
        },
        _ => {}
    }
}

/// In a wheelchair, whose wheels the hands drive.
fn rolling(motion: &WalkerMotion, skeleton: &Skeleton, habit: &GaitStyle) -> Posture {
    let (h, b) = (skeleton.height, skeleton.body);
    let own = habit.offset * TAU;
    let foot = skeleton.joint(Bone::FootL);
    let legs = Side::BOTH.map(|side| Leg {
        ankle: Vec3::new(0.245 * h, 0.055 * h * side.sign(), foot.z + 0.075 * h),
        pitch: 0.0,
        knee: Vec3::new(1.0, 0.12 * side.sign(), 0.8),
        yaw: 0.12 * side.sign(),
        toes: 0.0,
    });
    let push = motion.walked_m / 0.9 + habit.offset;
    let stroke = math::sin(TAU * push) * f32::from(motion.speed_mps > 0.05);
    let arm = |side: Side| Arm::Reach(Vec3::new((0.02 + 0.10 * stroke) * h, 0.165 * h * side.sign(), 0.375 * b));
    Posture {
        pelvis: Vec3::new(-0.02 * h, 0.0, wheeled::SEAT * b + 0.055 * h),
        pelvis_turn: Quat::from_rotation_y(-0.12),
        spine: Quat::from_rotation_y(0.08 + 0.3 * habit.slouch + 0.06 * stroke),
        chest: Quat::from_rotation_y(0.06 + 0.3 * habit.slouch + 0.06 * stroke),
        head: Quat::from_rotation_z(0.35 * math::sin(0.23 * motion.time_s + own)) * Quat::from_rotation_y(-0.02),
        arms: Side::BOTH.map(arm),
        legs,
    }
}
