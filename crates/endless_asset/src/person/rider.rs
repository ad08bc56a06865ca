//! People on two wheels.

use super::appearance::{Appearance, Carried, Hat};
use super::posture::{Arm, Leg, Posture};
use super::skeleton::{BONES, Bone, Side};
use super::{Anatomy, PersonModel, attributes};
use crate::vehicle::{HelmetKind, RiderFit};
use endless_scene::Mesh;
use endless_world::{BodyKeypoints, BodyPart, ClassTag, PersonAttributes, Reid, Stream, fnv1a};
use glam::{Affine3A, Quat, Vec3};
use std::sync::Arc;

/// A person seated on a two-wheeler, in the vehicle's object frame, and the part of the body that each triangle shows.
///
/// Somebody who sits behind them is part of the same mesh: a rider is one object, whose box and pixels are those of all who
/// ride. Keypoints, attributes and skin are told of the one who steers.
pub(crate) fn rider_body(fit: &RiderFit, variant: u64) -> (Mesh, Arc<[BodyPart]>) {
    let (mut mesh, parts) = seated_body(fit, variant);
    let Some((fit, passenger)) = passenger(fit, variant) else { return (mesh, parts) };
    let (behind, their_parts) = seated_body(&fit, passenger);
    mesh.append(&behind, Affine3A::IDENTITY);
    (mesh, parts.iter().chain(&*their_parts).copied().collect())
}

/// The seat behind, and the variant of the person on it; `None` if nobody is.
fn passenger(fit: &RiderFit, variant: u64) -> Option<(RiderFit, u64)> {
    let mut stream = Stream::named(variant, "pillion", &[]);
    let share = fit.pillion?.share;
    if !stream.chance(share) { None } else { Some((fit.behind()?, stream.next_u64())) }
}

fn seated_body(fit: &RiderFit, variant: u64) -> (Mesh, Arc<[BodyPart]>) {
    let appearance = appearance(fit, variant);
    let person = PersonModel::with_appearance(variant, &appearance);
    let pose = person.skinned(&seated(fit, &appearance, person.anatomy()));
    let mut mesh = Mesh { positions: pose.positions, normals: pose.normals, ..Arc::unwrap_or_clone(person.rest) };
    for material in &mut mesh.materials {
        material.tag = ClassTag::Rider;
    }
    mend_normals(&mut mesh);
    (mesh, person.parts)
}

/// Where cloth is squeezed between hip and thigh, normals that only turned with the bones may look inwards: those are
/// taken from the faces around.
fn mend_normals(mesh: &mut Mesh) {
    let mut around = vec![Vec3::ZERO; mesh.positions.len()];
    for t in &mesh.triangles {
        let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
        let normal = (b - a).cross(c - a);
        for &i in t {
            around[i as usize] += normal;
        }
    }
    for (normal, around) in mesh.normals.iter_mut().zip(around) {
        let around = around.normalize_or(*normal);
        if normal.dot(around) < 0.5 {
            *normal = around;
        }
    }
}

/// The keypoints of that person, in the vehicle's object frame.
pub(crate) fn rider_keypoints(fit: &RiderFit, variant: u64) -> BodyKeypoints {
    let appearance = appearance(fit, variant);
    let anatomy = Anatomy::with_appearance(variant, &appearance);
    anatomy.keypoints_on(&seated(fit, &appearance, &anatomy))
}

/// Their skin, 1 to 10 on the Monk scale.
pub(crate) fn rider_skin_tone(fit: &RiderFit, variant: u64) -> u8 {
    Appearance::riding(variant, None, fit.outfit).tone as u8 + 1
}

/// Who they are and what they wear.
pub(crate) fn rider_attributes(fit: &RiderFit, variant: u64) -> PersonAttributes {
    attributes::describe(&appearance(fit, variant), Reid::new("rider", &[variant]))
}

/// The identity of their look: the same on any two-wheeler but for the helmet and who sits behind.
pub(crate) fn rider_reid(fit: &RiderFit, variant: u64) -> Reid {
    let helmet = appearance(fit, variant).hat.word().unwrap_or_default();
    let look = [Some(variant), Some(fnv1a(helmet.bytes())), passenger(fit, variant).map(|p| p.1)];
    Reid::new("rider look", &look.into_iter().flatten().collect::<Vec<_>>())
}

/// What they look like.
fn appearance(fit: &RiderFit, variant: u64) -> Appearance {
    let mut stream = Stream::named(variant, "rider", &[]);
    let wears = stream.chance(fit.helmet);
    let helmet = match fit.helmets {
        HelmetKind::Full => Hat::FullHelmet,
        HelmetKind::Open if stream.chance(0.5) => Hat::OpenHelmet,
        HelmetKind::Open => Hat::FullHelmet,
        HelmetKind::Cycle => Hat::CycleHelmet,
    };
    let mut appearance = Appearance::riding(variant, wears.then_some(helmet), fit.outfit);
    if passenger(fit, variant).is_some() {
        // Whose back somebody leans on has nothing on it.
        appearance.carried = Carried::Nothing;
    }
    appearance
}

fn seated(fit: &RiderFit, appearance: &Appearance, anatomy: &Anatomy) -> [Affine3A; BONES] {
    let skeleton = &anatomy.skeleton;
    let h = appearance.height;
    let ankle_rest = skeleton.joint(Bone::FootL);
    let seat = if fit.standing {
        // Legs nearly straight above the deck.
        fit.seat + Vec3::Z * (skeleton.joint(Bone::Pelvis).z - 0.012 * h)
    } else {
        fit.seat + Vec3::Z * 0.072 * h
    };
    let lean = Quat::from_rotation_y(fit.lean_rad);
    let leg = |side: Side| {
        let sole =
            if side == Side::Left { fit.foot } else { Vec3::new(fit.foot.x, -fit.foot.y, fit.foot.z) + fit.right_foot };
        // The ball of the foot is on the peg; the heel hangs a little.
        Leg {
            ankle: sole + Vec3::new(-0.055 * h, 0.0, ankle_rest.z),
            pitch: 0.0,
            knee: Vec3::new(1.0, 0.16 * side.sign(), 0.35),
            yaw: 0.10 * side.sign(),
            toes: 0.0,
        }
    };
    let arm = |side: Side| {
        let grip = Vec3::new(fit.grip.x, fit.grip.y * side.sign(), fit.grip.z);
        // The hand lies on the grip from behind and above.
        Arm::Reach(grip + Vec3::new(-0.045 * h, 0.0, 0.022 * h))
    };
    let posture = Posture {
        pelvis: Vec3::new(seat.x, 0.0, seat.z),
        pelvis_turn: Quat::from_rotation_y(0.35 * fit.lean_rad - 0.08),
        spine: Quat::from_rotation_y(0.40 * fit.lean_rad + 0.06),
        chest: Quat::from_rotation_y(0.25 * fit.lean_rad + 0.08),
        head: lean.inverse() * Quat::from_rotation_y(-0.02),
        arms: Side::BOTH.map(arm),
        legs: Side::BOTH.map(leg),
    };
    posture.solve(skeleton)
}
