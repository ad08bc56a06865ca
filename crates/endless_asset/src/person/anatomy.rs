//! A person's skeleton and way of moving: enough to tell where joints and keypoints are, without any mesh.

use super::appearance::{Appearance, Carried};
use super::skeleton::{BONES, Bone, Skeleton};
use super::{gait, hold, part, sit};
use endless_world::{BodyKeypoints, FOOT_KEYPOINT_COUNT, Gait, KEYPOINT_COUNT, PersonRef, WalkerMotion};
use glam::{Affine3A, Vec3};

/// The skeleton of one person, in motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Anatomy {
    pub(crate) skeleton: Skeleton,
    keypoints: [(Bone, Vec3); KEYPOINT_COUNT],
    foot_keypoints: [(Bone, Vec3); FOOT_KEYPOINT_COUNT],
    /// Habits of moving, from the variant.
    pub(crate) habit: gait::GaitStyle,
}

impl Anatomy {
    /// Of a person.
    pub(crate) fn of(person: PersonRef) -> Self {
        Self::with_appearance(person.seed, &Appearance::of(person.seed, person.outfit))
    }

    pub(crate) fn with_appearance(variant: u64, appearance: &Appearance) -> Self {
        let skeleton = Skeleton::new(appearance);
        Self {
            keypoints: part::keypoints(appearance, &skeleton),
            foot_keypoints: part::foot_keypoints(&skeleton),
            skeleton,
            habit: gait::GaitStyle::new(variant, appearance),
        }
    }

    /// The keypoints at an instant, in the person's object frame.
    pub fn keypoints(&self, motion: &WalkerMotion) -> BodyKeypoints {
        self.keypoints_on(&self.bones(motion))
    }

    pub(crate) fn keypoints_on(&self, bones: &[Affine3A; BONES]) -> BodyKeypoints {
        let place = |(bone, p): (Bone, Vec3)| bones[bone as usize].transform_point3(p);
        BodyKeypoints { body: self.keypoints.map(place), feet: self.foot_keypoints.map(place) }
    }

    /// Where the joint of every bone is at an instant, in the order of [`Bone::ALL`], in the person's object frame.
    /// Those of things are of no meaning for who carries none.
    pub fn joints(&self, motion: &WalkerMotion) -> [Vec3; Bone::ALL.len()] {
        let bones = self.bones(motion);
        Bone::ALL.map(|b| bones[b as usize].transform_point3(self.skeleton.joint(b)))
    }

    /// How every bone stands at an instant, from the rest pose.
    pub(crate) fn bones(&self, motion: &WalkerMotion) -> [Affine3A; BONES] {
        let on_bench = motion.gait == Gait::Sit && self.habit.carried != Carried::Wheelchair;
        let posture = if on_bench { sit::posture } else { gait::posture };
        let mut bones = posture(motion, &self.skeleton, &self.habit).solve(&self.skeleton);
        hold::place(&mut bones, motion, &self.skeleton, self.habit.carried);
        bones
    }
}
