//! Parts of people's bodies.

use strum::VariantArray as _;

/// A part of a person's body; clothes belong to what they cover. The numbers are those of DensePose's fourteen parts in COCO
/// (Güler et al.: DensePose, CVPR 2018).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, strum::VariantArray)]
#[repr(u8)]
pub enum BodyPart {
    /// Chest, belly, hips.
    Torso = 1,
    /// Right hand.
    RightHand = 2,
    /// Left hand.
    LeftHand = 3,
    /// Left foot.
    LeftFoot = 4,
    /// Right foot.
    RightFoot = 5,
    /// Right thigh.
    RightThigh = 6,
    /// Left thigh.
    LeftThigh = 7,
    /// Right shin.
    RightShin = 8,
    /// Left shin.
    LeftShin = 9,
    /// Left upper arm.
    LeftUpperArm = 10,
    /// Right upper arm.
    RightUpperArm = 11,
    /// Left forearm.
    LeftForearm = 12,
    /// Right forearm.
    RightForearm = 13,
    /// Head and neck, hair and hats.
    Head = 14,
    /// Something carried, pushed, led or sat in: no part of the body, and none of DensePose's.
    Carried = 15,
}

impl BodyPart {
    /// All of them; the position of each is its value less one.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// The value in images; 0 is what belongs to nobody.
    pub const fn value(self) -> u8 {
        self as u8
    }

    /// The part of a value.
    pub fn from_value(value: u8) -> Option<Self> {
        Self::ALL.get(usize::from(value).checked_sub(1)?).copied()
    }

    /// A colour for people, sRGB: the left side is greener, the right side redder.
    pub const fn color(self) -> [u8; 3] {
        match self {
            Self::Torso => [70, 90, 200],
            Self::RightHand => [255, 200, 170],
            Self::LeftHand => [190, 255, 200],
            Self::LeftFoot => [0, 90, 40],
            Self::RightFoot => [110, 20, 30],
            Self::RightThigh => [230, 110, 40],
            Self::LeftThigh => [120, 210, 40],
            Self::RightShin => [180, 50, 60],
            Self::LeftShin => [20, 150, 70],
            Self::LeftUpperArm => [0, 190, 170],
            Self::RightUpperArm => [220, 70, 170],
            Self::LeftForearm => [120, 230, 230],
            Self::RightForearm => [250, 140, 210],
            Self::Head => [250, 230, 60],
            Self::Carried => [130, 130, 130],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_counted_from_one() {
        assert_eq!((BodyPart::Torso.value(), BodyPart::Head.value(), BodyPart::Carried.value()), (1, 14, 15));
        for &part in BodyPart::ALL {
            assert_eq!(BodyPart::from_value(part.value()), Some(part));
        }
        assert!(BodyPart::from_value(0).is_none() && BodyPart::from_value(16).is_none());
    }
}
