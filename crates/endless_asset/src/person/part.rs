//! What can be told of a person: parts of the body, keypoints, and who they are.

use super::appearance::Appearance;
use super::head::Head;
use super::skeleton::{Bone, Side, Skeleton};
use endless_world::{FOOT_KEYPOINT_COUNT, KEYPOINT_COUNT};
use glam::Vec3;

/// A part of the body, as annotations name it; clothes belong to what they cover.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum BodyPart {
    /// Head and neck, hair and hats.
    Head = 1,
    /// Chest, belly, hips.
    Torso = 2,
    /// Left upper arm.
    LeftUpperArm = 3,
    /// Left forearm.
    LeftForearm = 4,
    /// Left hand.
    LeftHand = 5,
    /// Right upper arm.
    RightUpperArm = 6,
    /// Right forearm.
    RightForearm = 7,
    /// Right hand.
    RightHand = 8,
    /// Left thigh.
    LeftThigh = 9,
    /// Left shin.
    LeftShin = 10,
    /// Left foot.
    LeftFoot = 11,
    /// Right thigh.
    RightThigh = 12,
    /// Right shin.
    RightShin = 13,
    /// Right foot.
    RightFoot = 14,
    /// Something carried, pushed, led or sat in.
    Carried = 15,
}

impl BodyPart {
    /// The part that a bone moves.
    pub const fn of(bone: Bone) -> Self {
        match bone {
            Bone::Pelvis | Bone::Spine | Bone::Chest => Self::Torso,
            Bone::Neck | Bone::Head => Self::Head,
            Bone::UpperArmL => Self::LeftUpperArm,
            Bone::ForearmL => Self::LeftForearm,
            Bone::HandL => Self::LeftHand,
            Bone::UpperArmR => Self::RightUpperArm,
            Bone::ForearmR => Self::RightForearm,
            Bone::HandR => Self::RightHand,
            Bone::ThighL => Self::LeftThigh,
            Bone::ShinL => Self::LeftShin,
            Bone::FootL | Bone::ToesL => Self::LeftFoot,
            Bone::ThighR => Self::RightThigh,
            Bone::ShinR => Self::RightShin,
            Bone::FootR | Bone::ToesR => Self::RightFoot,
            Bone::Carried | Bone::CarriedFront | Bone::CarriedRear => Self::Carried,
        }
    }
}

/// Keypoints in the rest pose, and the bone that each follows.
pub(crate) fn keypoints(appearance: &Appearance, skeleton: &Skeleton) -> [(Bone, Vec3); KEYPOINT_COUNT] {
    let head = Head::new(appearance, skeleton);
    let at = |x: f32, y: f32, z: f32| (Bone::Head, head.at(Vec3::new(x, y, z)));
    let joint = |b: Bone| (b, skeleton.joint(b));
    [
        at(0.48, 0.0, 0.37),
        at(0.34, 0.138, 0.502),
        at(0.34, -0.138, 0.502),
        at(-0.03, 0.335, 0.45),
        at(-0.03, -0.335, 0.45),
        joint(Bone::UpperArmL),
        joint(Bone::UpperArmR),
        joint(Bone::ForearmL),
        joint(Bone::ForearmR),
        joint(Bone::HandL),
        joint(Bone::HandR),
        joint(Bone::ThighL),
        joint(Bone::ThighR),
        joint(Bone::ShinL),
        joint(Bone::ShinR),
        joint(Bone::FootL),
        joint(Bone::FootR),
    ]
}

/// Keypoints of the feet in the rest pose, and the bone that each follows.
pub(crate) fn foot_keypoints(skeleton: &Skeleton) -> [(Bone, Vec3); FOOT_KEYPOINT_COUNT] {
    let ankle = skeleton.joint(Bone::FootL);
    let (h, toe, heel) = (skeleton.height, skeleton.toe, skeleton.heel);
    // Of the left foot; the big toe is on the inner side.
    let at = |along: f32, outwards: f32, z: f32| Vec3::new(ankle.x + along, ankle.y + outwards * h, z * h);
    let [big_toe, small_toe, back] =
        [at(0.93 * toe, -0.008, 0.010), at(0.78 * toe, 0.020, 0.010), at(-0.9 * heel, 0.004, 0.015)];
    let foot = |side: Side| {
        let [_, _, foot, toes] = side.leg();
        [(toes, side.flip(big_toe)), (toes, side.flip(small_toe)), (foot, side.flip(back))]
    };
    let [left, right] = [foot(Side::Left), foot(Side::Right)];
    [left[0], left[1], left[2], right[0], right[1], right[2]]
}

/// Who a person is and what they wear, for annotations and for those who choose people.
#[derive(Debug, Clone, PartialEq)]
pub struct PersonTraits {
    /// Years.
    pub age_years: f32,
    /// Female or male.
    pub female: bool,
    /// Standing height, metres.
    pub height_m: f32,
    /// Girth over the average's of that height.
    pub girth: f32,
    /// Monk Skin Tone, 1 (lightest) to 10.
    pub skin_tone: u8,
    /// Kind of outfit: `casual`, `office`, `suit`, `sports`, `high_visibility`, `uniform`, `regional`.
    pub outfit: &'static str,
    /// What is worn, by name, from the inside out, headgear and glasses last.
    pub wears: Vec<&'static str>,
    /// What is carried, pushed, led or sat in; empty for nothing.
    pub carries: &'static str,
}

impl PersonTraits {
    pub(crate) fn new(appearance: &Appearance) -> Self {
        let mut wears = vec![appearance.legs.name];
        wears.extend(appearance.garments.iter().map(|g| g.name));
        wears.extend(appearance.hat.word());
        wears.extend(appearance.glasses.word());
        wears.retain(|name| !name.is_empty());
        Self {
            age_years: appearance.age,
            female: appearance.female,
            height_m: appearance.height,
            girth: appearance.girth,
            skin_tone: appearance.tone as u8 + 1,
            outfit: appearance.outfit,
            wears,
            carries: appearance.carried.word().unwrap_or_default(),
        }
    }
}
