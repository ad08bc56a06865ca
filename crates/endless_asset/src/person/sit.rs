//! On a bench, and down to it and up again: feet stay where they are, the body goes back over them and down.

use super::gait::{self, GaitStyle};
use super::hold;
use super::posture::{Arm, Leg, Posture};
use super::skeleton::{Bone, Side, Skeleton};
use super::step;
use endless_world::math::UnfusedQuat;
use endless_world::{BenchSeat, FootPlace, Gait, WalkerMotion, math};
use glam::{Quat, Vec3};
use std::f32::consts::TAU;

/// From the seat up to the joints of the hips, over the stature.
const HIPS: f32 = 0.055;
/// From the seat up to the knees' joints, over the stature, so that thighs lie on the seat and not in it.
const KNEES: f32 = 0.022;
/// Most that heels are raised; who is still too small for the seat has their feet in the air. Radians.
const TIPTOE: f32 = 0.55;
/// Who gets up or sits down leans forward meanwhile, so that they stay over their feet, radians.
const LEAN: f32 = 0.55;

/// On a bench's seat, or as much as they have risen as they stand before it.
pub(crate) fn posture(motion: &WalkerMotion, skeleton: &Skeleton, habit: &GaitStyle) -> Posture {
    let seated = seated(motion, skeleton, habit);
    if motion.risen <= 0.0 {
        return seated;
    }
    let stands = WalkerMotion { speed_mps: 0.0, gait: Gait::Idle, ..*motion };
    between(&seated, &gait::posture(&stands, skeleton, habit), motion.risen.min(1.0), skeleton)
}

fn seated(motion: &WalkerMotion, skeleton: &Skeleton, habit: &GaitStyle) -> Posture {
    let (h, b) = (skeleton.height, skeleton.body);
    let own = habit.offset * TAU;
    let (breath, slow) = (math::sin(1.6 * motion.time_s + own), math::sin(0.23 * motion.time_s + own));
    let feet = Side::BOTH.map(|side| foot(side, skeleton));
    let legs = Side::BOTH.map(|side| {
        let foot = feet[side.index()];
        let knee = Vec3::new(1.0, 0.12 * side.sign(), 0.8);
        let ankle = step::ankle(&foot, skeleton);
        Leg { ankle, pitch: foot.pitch_rad, knee, yaw: foot.yaw_rad, toes: foot.toes_rad }
    });
    // Hands on the thighs, or together.
    let [x, y] = if habit.manner.is_multiple_of(2) { [0.16, 0.065] } else { [0.12, 0.022] };
    let hand = |side: Side| Arm::Reach(Vec3::new(x * h, y * h * side.sign(), BenchSeat::HEIGHT_M + 0.09 * b));
    let mut posture = Posture {
        pelvis: Vec3::new(-0.02 * h, 0.0, BenchSeat::HEIGHT_M + HIPS * h),
        pelvis_turn: Quat::from_rotation_y(-0.14),
        spine: Quat::from_rotation_y(0.06 + 0.3 * habit.slouch),
        chest: Quat::from_rotation_y(0.06 + 0.3 * habit.slouch - 0.012 * breath),
        head: Quat::from_rotation_z(0.35 * slow) * Quat::from_rotation_y(-0.02),
        arms: Side::BOTH.map(hand),
        legs,
    };
    hold::hold(&mut posture, &feet, skeleton, habit.carried);
    posture
}

/// Under the knee: flat where the shin is long enough for the seat, or on the ball.
fn foot(side: Side, skeleton: &Skeleton) -> FootPlace {
    let h = skeleton.height;
    let [knee, ankle, ball] = [Bone::ShinL, Bone::FootL, Bone::ToesL].map(|bone| skeleton.joint(bone));
    let wanted_m = BenchSeat::HEIGHT_M + KNEES * h - (knee - ankle).length();
    let missing_m = (wanted_m - ankle.z).max(0.0);
    let pitch_rad = (missing_m / (ball.x - ankle.x).max(0.01)).min(TIPTOE);
    let yaw_rad = 0.12 * side.sign();
    let at = [BenchSeat::FEET_AHEAD * h, 0.055 * h * side.sign()];
    let on_ball = FootPlace { at, yaw_rad, pitch_rad, toes_rad: pitch_rad, lift_m: 0.0 };
    let raised_m = step::ankle(&on_ball, skeleton).z - ankle.z;
    FootPlace { lift_m: (missing_m - raised_m).max(0.0), ..on_ball }
}

/// `risen`: 0 seated, 1 standing.
fn between(seated: &Posture, standing: &Posture, risen: f32, skeleton: &Skeleton) -> Posture {
    let turn = |a: Quat, b: Quat| a.slerp_unfused(b, risen);
    let mix = |a: f32, b: f32| math::lerp(a, b, risen);
    // Wherever arms are bent to, hands go the straight way.
    let wrists = [seated, standing].map(|posture| {
        let bones = posture.solve(skeleton);
        Side::BOTH.map(|side| {
            let hand = side.arm()[2];
            bones[hand as usize].transform_point3(skeleton.joint(hand))
        })
    });
    let lean = LEAN * 4.0 * risen * (1.0 - risen);
    let arms = Side::BOTH.map(|side| {
        let [from, to] = wrists.map(|wrists| wrists[side.index()]);
        let ahead = Vec3::new(0.35 * lean * skeleton.height, 0.0, 0.0);
        Arm::Reach(from.lerp(to, risen) + ahead)
    });
    let legs = Side::BOTH.map(|side| {
        let [a, b] = [seated, standing].map(|posture| posture.legs[side.index()]);
        Leg {
            ankle: a.ankle.lerp(b.ankle, risen),
            pitch: mix(a.pitch, b.pitch),
            knee: a.knee.lerp(b.knee, risen),
            yaw: mix(a.yaw, b.yaw),
            toes: mix(a.toes, b.toes),
        }
    });
    Posture {
        pelvis: seated.pelvis.lerp(standing.pelvis, risen),
        pelvis_turn: Quat::from_rotation_y(lean) * turn(seated.pelvis_turn, standing.pelvis_turn),
        spine: turn(seated.spine, standing.spine),
        chest: turn(seated.chest, standing.chest),
        head: turn(seated.head, standing.head),
        arms: if risen < 1.0 { arms } else { standing.arms },
        legs,
    }
}
