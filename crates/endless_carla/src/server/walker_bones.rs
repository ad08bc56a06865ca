//! The skeletons of people, as CARLA names their bones.
//!
//! Our bones have joints, but no axes of their own: in the animation all have the axes of the walker. Hands have no fingers here:
//! those that CARLA's have are laid out along the hand.

use crate::frames;
use crate::wire::{BoneTransform, Location, Transform};
use endless_asset::{Anatomy, Bone};
use endless_world::{BodyKeypoints, WalkerMotion};
use glam::Vec3;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// A bone of CARLA's.
struct NamedBone {
    name: String,
    /// By its place in the list.
    parent: Option<usize>,
    spot: Spot,
}

/// Where a bone is found in our skeleton.
#[derive(Clone, Copy)]
enum Spot {
    /// On the ground, under the hips.
    Root,
    Joint(Bone),
    /// Between the neck and the joint of an upper arm.
    Shoulder(Bone),
    /// A keypoint of the body, or of the feet.
    Keypoint(usize),
    FootKeypoint(usize),
    /// So far along a hand, metres of an adult.
    Hand {
        forearm: Bone,
        hand: Bone,
        along_m: f32,
    },
}

/// In the order of CARLA's own list.
static BONES: LazyLock<Vec<NamedBone>> = LazyLock::new(|| {
    let mut bones = vec![NamedBone { name: "crl_root".to_owned(), parent: None, spot: Spot::Root }];
    let mut add = |name: String, parent: usize, spot: Spot| {
        bones.push(NamedBone { name, parent: Some(parent), spot });
        bones.len() - 1
    };
    let hips = add("crl_hips__C".to_owned(), 0, Spot::Joint(Bone::Pelvis));
    let spine = add("crl_spine__C".to_owned(), hips, Spot::Joint(Bone::Spine));
    let chest = add("crl_spine01__C".to_owned(), spine, Spot::Joint(Bone::Chest));
    let arm = |add: &mut dyn FnMut(String, usize, Spot) -> usize, side: char, bones: [Bone; 3]| {
        let [upper, forearm, hand] = bones;
        let mut parent = add(format!("crl_shoulder__{side}"), chest, Spot::Shoulder(upper));
        for (name, bone) in [("arm", upper), ("foreArm", forearm), ("hand", hand)] {
            parent = add(format!("crl_{name}__{side}"), parent, Spot::Joint(bone));
        }
        for (finger, from_m) in [("Thumb", 0.03), ("Index", 0.09), ("Middle", 0.09), ("Ring", 0.09), ("Pinky", 0.08)] {
            let mut parent = parent;
            for (part, along_m) in [("", 0.0), ("01", 0.035), ("02", 0.06), ("End", 0.08)] {
                let spot = Spot::Hand { forearm, hand, along_m: from_m + along_m };
                parent = add(format!("crl_hand{finger}{part}__{side}"), parent, spot);
            }
        }
    };
    arm(&mut add, 'L', [Bone::UpperArmL, Bone::ForearmL, Bone::HandL]);
    let neck = add("crl_neck__C".to_owned(), chest, Spot::Joint(Bone::Neck));
    let head = add("crl_Head__C".to_owned(), neck, Spot::Joint(Bone::Head));
    add("crl_eye__L".to_owned(), head, Spot::Keypoint(1));
    add("crl_eye__R".to_owned(), head, Spot::Keypoint(2));
    arm(&mut add, 'R', [Bone::UpperArmR, Bone::ForearmR, Bone::HandR]);
    let right = ('R', [Bone::ThighR, Bone::ShinR, Bone::FootR, Bone::ToesR], 3);
    let left = ('L', [Bone::ThighL, Bone::ShinL, Bone::FootL, Bone::ToesL], 0);
    for (side, bones, toe) in [right, left] {
        let mut parent = hips;
        for (name, bone) in ["thigh", "leg", "foot", "toe"].into_iter().zip(bones) {
            parent = add(format!("crl_{name}__{side}"), parent, Spot::Joint(bone));
        }
        add(format!("crl_toeEnd__{side}"), parent, Spot::FootKeypoint(toe));
    }
    bones
});

/// A pose that a client gives a walker, and how much it is seen of it.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct WalkerPose {
    /// Of bones by their places in the list, each to its parent.
    set: BTreeMap<usize, Transform>,
    /// From 0, all of the animation, to 1, all of the pose.
    blend: f32,
}

impl WalkerPose {
    /// Sets bones by their names; others stay. Names of none, and what are no places, are passed over.
    pub(super) fn set(&mut self, bones: &[(String, Transform)]) {
        for (name, transform) in bones {
            if let Some(bone) = BONES.iter().position(|bone| bone.name == *name)
                && frames::is_finite(transform)
            {
                self.set.insert(bone, transform.clone());
            }
        }
    }

    pub(super) fn blend(&mut self, blend: f32) {
        self.blend = if blend.is_finite() { blend.clamp(0.0, 1.0) } else { 0.0 };
    }

    /// Takes over how the animation is at an instant.
    pub(super) fn take(&mut self, anatomy: &Anatomy, motion: &WalkerMotion) {
        self.set = animated(anatomy, motion).into_iter().enumerate().collect();
    }

    /// All bones at an instant, of somebody who stands at a place on the ground.
    pub(super) fn bones(&self, anatomy: &Anatomy, motion: &WalkerMotion, ground: &Transform) -> Vec<BoneTransform> {
        let mut bones: Vec<BoneTransform> = Vec::new();
        for (index, (bone, animated)) in BONES.iter().zip(animated(anatomy, motion)).enumerate() {
            let relative = match self.set.get(&index) {
                Some(set) => mixed(&animated, set, self.blend),
                None => animated,
            };
            let parent = bone.parent.and_then(|parent| bones.get(parent));
            let component = parent.map_or_else(|| relative.clone(), |on| frames::attached(&on.component, &relative));
            let world = frames::attached(ground, &component);
            bones.push(BoneTransform { name: bone.name.clone(), world, component, relative });
        }
        bones
    }
}

/// The names of all bones.
pub(super) fn bone_names() -> Vec<String> {
    BONES.iter().map(|bone| bone.name.clone()).collect()
}

/// Bones as the animation has them at an instant, each to its parent.
fn animated(anatomy: &Anatomy, motion: &WalkerMotion) -> Vec<Transform> {
    let (joints, keypoints) = (anatomy.joints(motion), anatomy.keypoints(motion));
    let places: Vec<Vec3> = BONES.iter().map(|bone| place(bone.spot, &joints, &keypoints)).collect();
    let relative = |(bone, place): (&NamedBone, &Vec3)| {
        let parent = bone.parent.map_or(Vec3::ZERO, |parent| places[parent]);
        Transform { location: frames::to_carla(*place - parent), ..Transform::default() }
    };
    BONES.iter().zip(&places).map(relative).collect()
}

/// In the walker, whose feet are at its origin.
fn place(spot: Spot, joints: &[Vec3], keypoints: &BodyKeypoints) -> Vec3 {
    /// Height of an adult's head joint, metres.
    const HEAD_M: f32 = 1.6;
    let joint = |bone: Bone| joints[bone as usize];
    match spot {
        Spot::Root => Vec3::ZERO,
        Spot::Joint(bone) => joint(bone),
        Spot::Shoulder(arm) => joint(Bone::Neck).lerp(joint(arm), 0.35),
        Spot::Keypoint(number) => keypoints.body[number],
        Spot::FootKeypoint(number) => keypoints.feet[number],
        Spot::Hand { forearm, hand, along_m } => {
            let size = (joint(Bone::Head).z / HEAD_M).clamp(0.4, 1.2);
            joint(hand) + (joint(hand) - joint(forearm)).normalize_or_zero() * (along_m * size)
        }
    }
}

fn mixed(a: &Transform, b: &Transform, share: f32) -> Transform {
    let mix = |a: f32, b: f32| a + share * (b - a);
    let (from, to) = (&a.location, &b.location);
    let location = Location { x: mix(from.x, to.x), y: mix(from.y, to.y), z: mix(from.z, to.z) };
    let turn = frames::orientation(&a.rotation).slerp(frames::orientation(&b.rotation), share.into());
    Transform { location, rotation: frames::rotation(turn) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::Rotation;
    use endless_asset::Catalogue;
    use endless_world::{Outfit, PersonRef};

    fn named<'a>(bones: &'a [BoneTransform], name: &str) -> &'a BoneTransform {
        bones.iter().find(|bone| bone.name == name).expect(name)
    }

    #[test]
    fn bones_are_where_the_body_is() {
        let anatomy = Catalogue::builtin().anatomy(PersonRef { outfit: Outfit::Fair, seed: 7 });
        let ground = Transform {
            location: Location { x: 10.0, y: 20.0, z: 0.5 },
            rotation: Rotation { pitch: 0.0, yaw: 90.0, roll: 0.0 },
        };
        let motion = WalkerMotion::default();
        let mut pose = WalkerPose::default();
        let bones = pose.bones(&anatomy, &motion, &ground);
        assert_eq!(bones.len(), 66);
        assert_eq!(bones.iter().map(|bone| &bone.name).collect::<Vec<_>>(), bone_names().iter().collect::<Vec<_>>());
        let height = |name: &str| named(&bones, name).component.location.z;
        assert!(height("crl_foot__L") < height("crl_leg__L") && height("crl_leg__L") < height("crl_thigh__L"));
        assert!(height("crl_hips__C") < height("crl_neck__C") && height("crl_neck__C") < height("crl_eye__R"));
        // The left hand is to the left: CARLA's y is to the right; and here that is the east.
        let left = named(&bones, "crl_hand__L");
        assert!(left.component.location.y < -0.1 && left.world.location.x > 10.1);
        assert!((left.world.location.z - left.component.location.z - 0.5).abs() < 1e-5);
        // An arm that is lifted takes the hand along, as far as the pose is seen.
        let arm = named(&bones, "crl_arm__L").relative.clone();
        let lifted = Transform { rotation: Rotation { pitch: 0.0, yaw: 0.0, roll: 90.0 }, ..arm };
        pose.set(&[("crl_arm__L".to_owned(), lifted), ("no_bone".to_owned(), Transform::default())]);
        assert_eq!(pose.bones(&anatomy, &motion, &ground), bones, "it is not seen yet");
        pose.blend(1.0);
        let posed = pose.bones(&anatomy, &motion, &ground);
        let moved = |bones: &[BoneTransform]| named(bones, "crl_hand__L").component.location.clone();
        assert!((moved(&posed).z - moved(&bones).z).abs() > 0.2);
        assert_eq!(named(&posed, "crl_hand__R").component, named(&bones, "crl_hand__R").component);
        // What is taken over stays while the legs go on.
        pose.take(&anatomy, &motion);
        let later = WalkerMotion { walked_m: 0.4, speed_mps: 1.4, gait: endless_world::Gait::Walk, ..motion };
        let close = |a: &BoneTransform, b: &BoneTransform| {
            frames::from_carla(&a.component.location).distance(frames::from_carla(&b.component.location)) < 1e-4
        };
        assert!(pose.bones(&anatomy, &later, &ground).iter().zip(&bones).all(|(a, b)| close(a, b)));
        pose.blend(f32::NAN);
        assert!(!pose.bones(&anatomy, &later, &ground).iter().zip(&bones).all(|(a, b)| close(a, b)));
    }
}
