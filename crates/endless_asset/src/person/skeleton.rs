//! Bones and where their joints lie in the rest pose.

use super::look::Look;
use glam::Vec3;

/// The bones; each turns about its joint, the end nearer to the pelvis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub(crate) enum Bone {
    Pelvis,
    Spine,
    Chest,
    Neck,
    Head,
    UpperArmL,
    ForearmL,
    HandL,
    UpperArmR,
    ForearmR,
    HandR,
    ThighL,
    ShinL,
    FootL,
    ThighR,
    ShinR,
    FootR,
}

/// How many bones there are.
pub(crate) const BONES: usize = 17;

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

    /// Upper arm, forearm, hand.
    pub(crate) fn arm(self) -> [Bone; 3] {
        match self {
            Self::Left => [Bone::UpperArmL, Bone::ForearmL, Bone::HandL],
            Self::Right => [Bone::UpperArmR, Bone::ForearmR, Bone::HandR],
        }
    }

    /// Thigh, shin, foot.
    pub(crate) fn leg(self) -> [Bone; 3] {
        match self {
            Self::Left => [Bone::ThighL, Bone::ShinL, Bone::FootL],
            Self::Right => [Bone::ThighR, Bone::ShinR, Bone::FootR],
        }
    }
}

/// Joints in the rest pose, and the measures that clothes and gait need.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Skeleton {
    pub(crate) joints: [Vec3; BONES],
    /// Standing height.
    pub(crate) height: f32,
    /// Chin to crown.
    pub(crate) head_height: f32,
    /// Tip of the toes ahead of the ankle, and the heel behind it.
    pub(crate) toe: f32,
    pub(crate) heel: f32,
}

impl Skeleton {
    pub(crate) fn new(look: &Look) -> Self {
        let h = look.height;
        let head_height = 0.145 + 0.048 * h;
        // Up to the base of the neck: children's heads are large, their trunk and legs share the rest.
        let body = (h - head_height) / 0.87;
        let shoulder = h * if look.female { 0.090 } else { 0.102 } * look.shoulder;
        let hip = 0.050 * h;
        let mut joints = [Vec3::ZERO; BONES];
        let mut set = |b: Bone, p: Vec3| joints[b as usize] = p;
        set(Bone::Pelvis, Vec3::new(0.0, 0.0, 0.545 * body));
        set(Bone::Spine, Vec3::new(-0.005 * h, 0.0, 0.60 * body));
        set(Bone::Chest, Vec3::new(-0.008 * h, 0.0, 0.69 * body));
        set(Bone::Neck, Vec3::new(-0.012 * h, 0.0, 0.83 * body));
        set(Bone::Head, Vec3::new(-0.004 * h, 0.0, h - head_height * 0.92));
        let along = Vec3::new(0.0, 0.30, -0.954);
        for side in Side::BOTH {
            let flip = |p: Vec3| Vec3::new(p.x, p.y * side.sign(), p.z);
            let [upper, fore, hand] = side.arm();
            let root = Vec3::new(-0.010 * h, shoulder, 0.793 * body);
            set(upper, flip(root));
            set(fore, flip(root + along * 0.168 * body));
            set(hand, flip(root + along * (0.168 + 0.148) * body));
            let [thigh, shin, foot] = side.leg();
            set(thigh, flip(Vec3::new(0.0, hip, 0.525 * body)));
            set(shin, flip(Vec3::new(0.004 * h, hip, 0.285 * body)));
            set(foot, flip(Vec3::new(-0.012 * h, hip, 0.048 * body)));
        }
        Self { joints, height: h, head_height, toe: 0.112 * h, heel: 0.042 * h }
    }

    pub(crate) fn joint(&self, bone: Bone) -> Vec3 {
        self.joints[bone as usize]
    }
}
