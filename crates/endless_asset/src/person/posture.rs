//! From where pelvis, hands and feet are to how every bone stands.

use super::skeleton::{BONES, Bone, Side, Skeleton};
use endless_world::math::UnfusedQuat;
use glam::{Affine3A, Mat3, Quat, Vec3};

/// An arm: where its wrist is, or how it hangs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Arm {
    /// Upper arm turned forward and outward from hanging, elbow bent; radians.
    Swing { forward: f32, outward: f32, elbow: f32 },
    /// Wrist at this place in the object frame.
    Reach(Vec3),
}

/// A leg: where the ankle is, how far the heel is raised, where the knee points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Leg {
    pub(crate) ankle: Vec3,
    /// Heel up is positive, radians.
    pub(crate) pitch: f32,
    /// Direction the knee points to.
    pub(crate) knee: Vec3,
    /// Heading of the toes, positive to the left, radians.
    pub(crate) yaw: f32,
    /// Toes bent upwards, radians.
    pub(crate) toes: f32,
}

/// A whole posture in the object frame; left first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Posture {
    /// The pelvis's joint.
    pub(crate) pelvis: Vec3,
    pub(crate) pelvis_turn: Quat,
    /// Each relative to the bone below it.
    pub(crate) spine: Quat,
    pub(crate) chest: Quat,
    pub(crate) head: Quat,
    pub(crate) arms: [Arm; 2],
    pub(crate) legs: [Leg; 2],
}

/// Turns about a joint.
pub(crate) fn about(joint: Vec3, turn: Quat) -> Affine3A {
    Affine3A::from_rotation_translation(turn, joint - turn.rotate_unfused(joint))
}

/// A frame whose first axis is `along` and whose second lies towards `pole`.
fn frame(along: Vec3, pole: Vec3) -> Mat3 {
    let x = along.normalize_or(-Vec3::Z);
    let y = (pole - x * pole.dot(x)).normalize_or(x.any_orthonormal_vector());
    Mat3::from_cols(x, y, x.cross(y))
}

/// The transform of a limb bone whose rest segment `a → b` (bending towards `pole`) comes to lie on `a2 → b2`.
fn limb(rest: (Vec3, Vec3, Vec3), posed: (Vec3, Vec3, Vec3)) -> Affine3A {
    let turn = frame(posed.1 - posed.0, posed.2) * frame(rest.1 - rest.0, rest.2).transpose();
    Affine3A::from_mat3_translation(turn, posed.0 - turn * rest.0)
}

/// The middle joint of a two-bone chain from `a` that reaches for `b`, bent towards `pole`; and where it truly ends.
fn bend(a: Vec3, b: Vec3, l1: f32, l2: f32, pole: Vec3) -> (Vec3, Vec3) {
    let d = (b - a).length().clamp((l1 - l2).abs() + 1e-3, (l1 + l2) * 0.9995);
    let along = (b - a).normalize_or(-Vec3::Z);
    let x = (l1 * l1 - l2 * l2 + d * d) / (2.0 * d);
    let y = (l1 * l1 - x * x).max(0.0).sqrt();
    let side = (pole - along * pole.dot(along)).normalize_or(along.any_orthonormal_vector());
    (a + along * x + side * y, a + along * d)
}

impl Posture {
    /// The transform of every bone from the rest pose to this posture.
    pub(crate) fn solve(&self, skeleton: &Skeleton) -> [Affine3A; BONES] {
        let j = |b: Bone| skeleton.joint(b);
        let mut out = [Affine3A::IDENTITY; BONES];
        let pelvis =
            Affine3A::from_translation(self.pelvis - j(Bone::Pelvis)) * about(j(Bone::Pelvis), self.pelvis_turn);
        let spine = pelvis * about(j(Bone::Spine), self.spine);
        let chest = spine * about(j(Bone::Chest), self.chest);
        let half = Quat::IDENTITY.slerp_unfused(self.head, 0.5);
        let neck = chest * about(j(Bone::Neck), half);
        let head = neck * about(j(Bone::Head), half);
        for (bone, m) in
            [(Bone::Pelvis, pelvis), (Bone::Spine, spine), (Bone::Chest, chest), (Bone::Neck, neck), (Bone::Head, head)]
        {
            out[bone as usize] = m;
        }
        for (i, side) in Side::BOTH.into_iter().enumerate() {
            let [upper, fore, hand] = side.arm();
            let (s0, e0, w0) = (j(upper), j(fore), j(hand));
            let (l1, l2) = ((e0 - s0).length(), (w0 - e0).length());
            let shoulder = chest.transform_point3(s0);
            let turned = |v: Vec3| chest.transform_vector3(v);
            let (elbow, wrist) = match self.arms[i] {
                Arm::Swing { forward, outward, elbow } => {
                    let out = Quat::from_rotation_x(outward * side.sign());
                    let upper = (out * Quat::from_rotation_y(-forward)).rotate_unfused(-Vec3::Z);
                    let fore = (out * Quat::from_rotation_y(-forward - elbow)).rotate_unfused(-Vec3::Z);
                    let e = shoulder + turned(upper) * l1;
                    (e, e + turned(fore) * l2)
                }
                // Elbows point down and out; forward where the hand is raised.
                Arm::Reach(wrist) => {
                    let ahead = if wrist.z > shoulder.z - 0.05 { 0.7 } else { -0.45 };
                    bend(shoulder, wrist, l1, l2, turned(Vec3::new(ahead, 0.65 * side.sign(), -0.9)))
                }
            };
            let elbow_rest = -Vec3::X;
            let pole = elbow - 0.5 * (shoulder + wrist);
            let pole = if pole.length() > 0.01 { pole } else { turned(elbow_rest) };
            out[upper as usize] = limb((s0, e0, elbow_rest), (shoulder, elbow, pole));
            out[fore as usize] = limb((e0, w0, elbow_rest), (elbow, wrist, pole));
            out[hand as usize] = out[fore as usize];

            let [thigh, shin, foot, toes] = side.leg();
            let (h0, k0, a0) = (j(thigh), j(shin), j(foot));
            let hip = pelvis.transform_point3(h0);
            let leg = self.legs[i];
            let (knee, ankle) = bend(hip, leg.ankle, (k0 - h0).length(), (a0 - k0).length(), leg.knee);
            out[thigh as usize] = limb((h0, k0, Vec3::X), (hip, knee, leg.knee));
            out[shin as usize] = limb((k0, a0, Vec3::X), (knee, ankle, leg.knee));
            let turn = Quat::from_rotation_z(leg.yaw) * Quat::from_rotation_y(leg.pitch);
            out[foot as usize] = Affine3A::from_rotation_translation(turn, ankle - turn.rotate_unfused(a0));
            out[toes as usize] = out[foot as usize] * about(j(toes), Quat::from_rotation_y(-leg.toes));
        }
        out
    }
}
