//! How things are held: what arms do for them, and where they then are.

use super::appearance::Carried;
use super::posture::{Arm, Posture, about};
use super::skeleton::{BONES, Bone, Side, Skeleton};
use super::{dog, wheeled};
use endless_world::math::UnfusedQuat;
use endless_world::{FootPlace, WalkerMotion, math};
use glam::{Affine3A, Quat, Vec3};

/// Length of a cane below the hand, and from the handle of a suitcase to its wheels; over the stature.
pub(crate) const CANE: f32 = 0.485;
pub(crate) const TROLLEY: f32 = 0.60;

/// Bends arms and head to what is carried.
pub(crate) fn hold(posture: &mut Posture, feet: &[FootPlace; 2], skeleton: &Skeleton, carried: Carried) {
    let (h, b) = (skeleton.height, skeleton.body);
    let hang = |arm: Arm, outward: f32| match arm {
        Arm::Swing { forward, .. } => Arm::Swing { forward: 0.25 * forward, outward, elbow: 0.10 },
        reach @ Arm::Reach(_) => reach,
    };
    let [left, right] = &mut posture.arms;
    match carried {
        Carried::Nothing | Carried::Backpack | Carried::ShoulderBag | Carried::Wheelchair => {}
        Carried::Handbag | Carried::Briefcase => {
            *left = hang(*left, 0.13);
        }
        Carried::ShoppingBag => *left = hang(*left, 0.17),
        Carried::Phone => {
            *right = Arm::Swing { forward: 0.45, outward: -0.02, elbow: 1.72 };
            posture.head = Quat::from_rotation_z(-0.10) * Quat::from_rotation_y(0.42);
        }
        Carried::Call => {
            let ear = skeleton.height - 0.55 * skeleton.head_height;
            *right = Arm::Reach(
                Vec3::new(0.035 * h, -0.085 * h, ear - 0.055 * h) + Vec3::Z * (posture.pelvis.z - 0.545 * b),
            );
            posture.head *= Quat::from_rotation_x(0.10);
        }
        Carried::Umbrella => *right = Arm::Reach(Vec3::new(0.13 * h, -0.075 * h, 0.685 * b)),
        Carried::Suitcase => *right = Arm::Swing { forward: -0.34, outward: 0.13, elbow: 0.08 },
        Carried::Cane => {
            let x = 0.05 * h + 0.35 * feet[0].at[0];
            *right = Arm::Reach(Vec3::new(x, -0.135 * h, (CANE + 0.035) * h));
        }
        Carried::Dog => *left = Arm::Swing { forward: 0.28, outward: 0.12, elbow: 0.55 },
        Carried::Pram => {
            let handle = wheeled::pram_handle(skeleton);
            posture.arms = Side::BOTH.map(|s| {
                let grip = Vec3::new(handle.x, 0.105 * h * s.sign(), handle.z);
                // The wrist is behind and above what the hand holds.
                Arm::Reach(grip + Vec3::new(-0.040, 0.006 * s.sign(), 0.022) * h)
            });
        }
    }
}

/// Moves things to where hands and ground want them.
pub(crate) fn place(bones: &mut [Affine3A; BONES], motion: &WalkerMotion, skeleton: &Skeleton, carried: Carried) {
    let h = skeleton.height;
    let grips = Side::BOTH.map(|side| {
        let rest = skeleton.grip(side);
        (rest, bones[side.arm()[2] as usize].transform_point3(rest))
    });
    let left_foot = bones[Bone::FootL as usize].transform_point3(skeleton.joint(Bone::FootL));
    let grip = |side: Side| grips[side.index()];
    // Bags of who sits stand on the ground.
    let moved = |side: Side| {
        let (rest, held) = grip(side);
        let way = held - rest;
        Affine3A::from_translation(way.with_z(way.z.max(-0.03)))
    };
    let mut set = |bone: Bone, m: Affine3A| bones[bone as usize] = m;
    match carried {
        Carried::Handbag | Carried::Briefcase | Carried::ShoppingBag => {
            let (_, held) = grip(Side::Left);
            let swing = 0.07 * math::sin(4.0 * motion.walked_m) * math::smoothstep(0.1, 1.0, motion.speed_mps);
            let m = about(held, Quat::from_rotation_y(swing)) * moved(Side::Left);
            set(Bone::Carried, m);
        }
        Carried::Umbrella => {
            let (_, held) = grip(Side::Right);
            let m = about(held, Quat::from_rotation_y(0.10) * Quat::from_rotation_x(-0.08)) * moved(Side::Right);
            set(Bone::Carried, m);
        }
        Carried::Suitcase | Carried::Cane => {
            let (rest, held) = grip(Side::Right);
            let length = if carried == Carried::Cane { CANE } else { TROLLEY } * h;
            let (x, y) = if carried == Carried::Cane {
                (left_foot.x + 0.10 * h, held.y - 0.015 * h)
            } else {
                (held.x - (length * length - held.z * held.z).max(0.0).sqrt(), held.y)
            };
            let wanted = Vec3::new(x, y, 0.0) - held;
            let turn = Quat::from_rotation_arc(-Vec3::Z, wanted.normalize_or(-Vec3::Z));
            // The tip stays on the ground: what is missing slides through the hand.
            let slack = wanted.length() - length;
            let m = Affine3A::from_rotation_translation(
                turn,
                held + wanted.normalize_or(-Vec3::Z) * slack - turn.rotate_unfused(rest),
            );
            set(Bone::Carried, m);
        }
        Carried::Pram | Carried::Wheelchair => {
            for (bone, axle, radius) in wheeled::axles(skeleton, carried) {
                set(bone, about(axle, Quat::from_rotation_y(motion.walked_m / radius)));
            }
        }
        Carried::Dog => {
            for (bone, m) in [Bone::Carried, Bone::CarriedFront, Bone::CarriedRear].into_iter().zip(dog::trot(motion)) {
                set(bone, m);
            }
        }
        Carried::Nothing | Carried::Backpack | Carried::ShoulderBag | Carried::Phone | Carried::Call => {}
    }
}
