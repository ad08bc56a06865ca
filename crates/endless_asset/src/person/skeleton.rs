//! Bones and where their joints lie in the rest pose.

use super::appearance::Appearance;
use glam::Vec3;
use strum::{EnumCount as _, VariantArray as _};

/// The bones of a person; each turns about its joint, the end nearer to the pelvis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, strum::EnumCount, strum::VariantArray)]
#[repr(u8)]
pub enum Bone {
    /// Hips; joint between the hip joints.
    Pelvis,
    /// Lumbar spine; joint at the waist.
    Spine,
    /// Rib cage.
    Chest,
    /// Neck; joint at its base.
    Neck,
    /// Skull; joint below the ears.
    Head,
    /// Left upper arm; joint at the shoulder.
    UpperArmL,
    /// Left forearm; joint at the elbow.
    ForearmL,
    /// Left hand; joint at the wrist.
    HandL,
    /// Right upper arm; joint at the shoulder.
    UpperArmR,
    /// Right forearm; joint at the elbow.
    ForearmR,
    /// Right hand; joint at the wrist.
    HandR,
    /// Left thigh; joint at the hip.
    ThighL,
    /// Left shin; joint at the knee.
    ShinL,
    /// Left foot; joint at the ankle.
    FootL,
    /// Left toes; joint at the ball of the foot.
    ToesL,
    /// Right thigh; joint at the hip.
    ThighR,
    /// Right shin; joint at the knee.
    ShinR,
    /// Right foot; joint at the ankle.
    FootR,
    /// Right toes; joint at the ball of the foot.
    ToesR,
    /// What is carried, pushed or led.
    Carried,
    /// A part of it that moves: front wheels, one pair of a dog's legs.
    CarriedFront,
    /// Another: rear wheels, the other pair of legs.
    CarriedRear,
}

/// How many bones there are.
pub(crate) const BONES: usize = Bone::COUNT;

impl Bone {
    /// All of them, in order.
    pub const ALL: [Self; BONES] = match Self::VARIANTS.first_chunk() {
        Some(all) => *all,
        None => unreachable!(),
    };

    /// The bone that it hangs from; `None` for the pelvis and for things.
    pub const fn parent(self) -> Option<Self> {
        Some(match self {
            Self::Pelvis | Self::Carried | Self::CarriedFront | Self::CarriedRear => return None,
            Self::Spine | Self::ThighL | Self::ThighR => Self::Pelvis,
            Self::Chest => Self::Spine,
            Self::Neck | Self::UpperArmL | Self::UpperArmR => Self::Chest,
            Self::Head => Self::Neck,
            Self::ForearmL => Self::UpperArmL,
            Self::HandL => Self::ForearmL,
            Self::ForearmR => Self::UpperArmR,
            Self::HandR => Self::ForearmR,
            Self::ShinL => Self::ThighL,
            Self::FootL => Self::ShinL,
            Self::ToesL => Self::FootL,
            Self::ShinR => Self::ThighR,
            Self::FootR => Self::ShinR,
            Self::ToesR => Self::FootR,
        })
    }
}

/// Left or right.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    Left,
    Right,
}

impl Side {
    pub(crate) const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// +1 on the left, −1 on the right: the sign of y.
    pub(crate) fn sign(self) -> f32 {
        if self == Self::Left { 1.0 } else { -1.0 }
    }

    /// Left is 0.
    pub(crate) fn index(self) -> usize {
        usize::from(self == Self::Right)
    }

    /// Mirrors what is meant for the left.
    pub(crate) fn flip(self, p: Vec3) -> Vec3 {
        Vec3::new(p.x, p.y * self.sign(), p.z)
    }

    /// Upper arm, forearm, hand.
    pub(crate) fn arm(self) -> [Bone; 3] {
        match self {
            Self::Left => [Bone::UpperArmL, Bone::ForearmL, Bone::HandL],
            Self::Right => [Bone::UpperArmR, Bone::ForearmR, Bone::HandR],
        }
    }

    /// Thigh, shin, foot, toes.
    pub(crate) fn leg(self) -> [Bone; 4] {
        match self {
            Self::Left => [Bone::ThighL, Bone::ShinL, Bone::FootL, Bone::ToesL],
            Self::Right => [Bone::ThighR, Bone::ShinR, Bone::FootR, Bone::ToesR],
        }
    }
}

/// Direction in which the left arm points in the rest pose.
pub(crate) const ARM: Vec3 = Vec3::new(0.0, 0.588, -0.809);

/// Joints in the rest pose, and the measures that clothes and gait need.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Skeleton {
    pub(crate) joints: [Vec3; BONES],
    /// Standing height.
    pub(crate) height: f32,
    /// Chin to crown.
    pub(crate) head_height: f32,
    /// Height of the body without its head, so scaled that the base of the neck is at 0.83.
    pub(crate) body: f32,
    /// Tip of the toes ahead of the ankle, and the heel behind it.
    pub(crate) toe: f32,
    pub(crate) heel: f32,
}

/// Lengths of upper arm and forearm, over the body's height.
const ARM_LENGTHS: [f32; 2] = [0.172, 0.146];

impl Skeleton {
    /// Shares of stature after Drillis and Contini (1966); children's heads are larger.
    pub(crate) fn new(appearance: &Appearance) -> Self {
        let h = appearance.height;
        let head_height = 0.145 + 0.048 * h;
        let body = (h - head_height) / 0.87;
        let shoulder = h * if appearance.female { 0.086 } else { 0.096 } * appearance.shoulder;
        let hip = 0.0485 * h;
        let mut joints = [Vec3::ZERO; BONES];
        let mut set = |b: Bone, p: Vec3| joints[b as usize] = p;
        set(Bone::Pelvis, Vec3::new(0.0, 0.0, 0.545 * body));
        set(Bone::Spine, Vec3::new(-0.005 * h, 0.0, 0.60 * body));
        set(Bone::Chest, Vec3::new(-0.008 * h, 0.0, 0.69 * body));
        set(Bone::Neck, Vec3::new(-0.012 * h, 0.0, 0.83 * body));
        set(Bone::Head, Vec3::new(-0.004 * h, 0.0, h - head_height * 0.92));
        let toe = 0.106 * h;
        for side in Side::BOTH {
            let [upper, fore, hand] = side.arm();
            let root = Vec3::new(-0.010 * h, shoulder, 0.795 * body);
            set(upper, side.flip(root));
            set(fore, side.flip(root + ARM * ARM_LENGTHS[0] * body));
            set(hand, side.flip(root + ARM * (ARM_LENGTHS[0] + ARM_LENGTHS[1]) * body));
            let [thigh, shin, foot, toes] = side.leg();
            let ankle = Vec3::new(-0.010 * h, 1.0 * hip, 0.046 * body);
            set(thigh, side.flip(Vec3::new(0.0, hip, 0.525 * body)));
            set(shin, side.flip(Vec3::new(0.004 * h, hip, 0.285 * body)));
            set(foot, side.flip(ankle));
            set(toes, side.flip(Vec3::new(ankle.x + 0.62 * toe, hip, 0.011 * h)));
        }
        Self { joints, height: h, head_height, body, toe, heel: 0.040 * h }
    }

    pub(crate) fn joint(&self, bone: Bone) -> Vec3 {
        self.joints[bone as usize]
    }

    /// Middle of what a closed hand holds, in the rest pose.
    pub(crate) fn grip(&self, side: Side) -> Vec3 {
        self.joint(side.arm()[2]) + side.flip(ARM) * 0.052 * self.height
    }
}
