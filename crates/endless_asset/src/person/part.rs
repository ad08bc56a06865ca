//! What can be told of a person: parts of the body, keypoints, and who they are.

use super::appearance::Appearance;
use super::head::Head;
use super::skeleton::{Bone, Side, Skeleton};
use endless_world::{BodyPart, FOOT_KEYPOINT_COUNT, KEYPOINT_COUNT};
use glam::Vec3;

impl Bone {
    /// The part of the body that it moves.
    pub const fn part(self) -> BodyPart {
        match self {
            Self::Pelvis | Self::Spine | Self::Chest => BodyPart::Torso,
            Self::Neck | Self::Head => BodyPart::Head,
            Self::UpperArmL => BodyPart::LeftUpperArm,
            Self::ForearmL => BodyPart::LeftForearm,
            Self::HandL => BodyPart::LeftHand,
            Self::UpperArmR => BodyPart::RightUpperArm,
            Self::ForearmR => BodyPart::RightForearm,
            Self::HandR => BodyPart::RightHand,
            Self::ThighL => BodyPart::LeftThigh,
            Self::ShinL => BodyPart::LeftShin,
            Self::FootL | Self::ToesL => BodyPart::LeftFoot,
            Self::ThighR => BodyPart::RightThigh,
            Self::ShinR => BodyPart::RightShin,
            Self::FootR | Self::ToesR => BodyPart::RightFoot,
            Self::Carried | Self::CarriedFront | Self::CarriedRear => BodyPart::Carried,
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
