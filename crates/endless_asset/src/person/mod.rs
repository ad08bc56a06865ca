//! People: a skinned body with clothes, posed by gait.

mod anatomy;
mod appearance;
mod attributes;
mod body;
mod cage;
mod carried;
mod choice;
mod climate;
mod clothes;
mod collar;
mod dog;
mod figure;
mod gait;
mod garment_mesh;
mod garments;
mod hair;
mod head;
mod hold;
mod limbs;
mod palette;
mod part;
mod posture;
mod rider;
mod seeded;
mod sit;
mod skeleton;
mod skin;
mod step;
mod wardrobe;
mod wheeled;
mod word;

use endless_scene::Mesh;
use endless_world::walking::PedestrianSpec;
use endless_world::{BodyKeypoints, BodyPart, Outfit, PersonAttributes, PersonRef, Reid, WalkerMotion};
use glam::{Affine3A, Vec3};
use std::sync::Arc;

pub use anatomy::Anatomy;
pub(crate) use appearance::{Appearance, Carried};
pub use part::PersonTraits;
pub(crate) use rider::{rider_attributes, rider_body, rider_keypoints, rider_reid, rider_skin_tone};
pub(crate) use seeded::skin_tone;
use skeleton::BONES;
pub use skeleton::Bone;
use skin::Blend;

/// One person: mesh, skeleton and skinning of one variant. Proportions, age, sex, clothes, hair and skin follow from
/// the variant's seed.
#[derive(Debug, Clone, PartialEq)]
pub struct PersonModel {
    /// In rest pose, feet on the ground at z = 0, facing +x, arms a little away from the body.
    pub rest: Arc<Mesh>,
    /// Standing height without hair and headgear, metres.
    pub height_m: f32,
    /// Comfortable walking speed, m/s.
    pub walk_mps: f32,
    /// Who they are and what they wear.
    pub traits: PersonTraits,
    /// Which part of the body each triangle of the mesh shows.
    pub parts: Arc<[BodyPart]>,
    anatomy: Anatomy,
    /// Distinct mixtures of bones, and which one each vertex follows.
    blends: Vec<Blend>,
    vertex_blend: Vec<u16>,
}

/// What traffic needs to know of the person of a seed.
pub(crate) fn pedestrian_spec(seed: u64) -> PedestrianSpec {
    let appearance = Appearance::of(seed, Outfit::Fair);
    gait::GaitStyle::new(seed, &appearance).spec(&appearance)
}

/// Who a person is, what they wear and carry, as drawn.
pub(crate) fn attributes(person: PersonRef) -> PersonAttributes {
    attributes::describe(&appearance(person), Reid::new("person", &[person.seed]))
}

/// The identity of a person's look: the same in two outfits that differ in nothing.
pub(crate) fn reid(person: PersonRef) -> Reid {
    let fair = PersonRef { outfit: Outfit::Fair, ..person };
    let same = appearance(person) == appearance(fair);
    Reid::new("person look", &[person.seed, if same { 0 } else { person.outfit as u64 }])
}

fn appearance(person: PersonRef) -> Appearance {
    Appearance::of(person.seed, person.outfit)
}

/// Thickness of cloth on the ground, metres.
const HEM_M: f32 = 0.004;

/// A deformed mesh: same triangles and materials as the rest mesh, new vertices.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BodyPose {
    /// One a vertex of the rest mesh.
    pub positions: Vec<Vec3>,
    /// One a vertex of the rest mesh.
    pub normals: Vec<Vec3>,
}

/// How a person's bones stand at an instant, mixed as vertices follow them.
#[derive(Debug, Clone, Default)]
pub struct Stance(Vec<Affine3A>);

impl PersonModel {
    /// A person, dressed for the weather.
    pub(crate) fn new(person: PersonRef) -> Self {
        Self::with_appearance(person.seed, &appearance(person))
    }

    fn with_appearance(variant: u64, appearance: &Appearance) -> Self {
        let anatomy = Anatomy::with_appearance(variant, appearance);
        let skin = figure::build(appearance, &anatomy.skeleton);
        let leader = |i: u32| skin.blends[usize::from(skin.vertex_blend[i as usize])].leader();
        // A triangle shows the part that two of its corners follow.
        let part = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|i| leader(i).part());
            if b == c { b } else { a }
        };
        Self {
            traits: PersonTraits::new(appearance),
            parts: skin.mesh.triangles.iter().map(part).collect(),
            rest: skin.mesh.into(),
            height_m: appearance.height,
            walk_mps: anatomy.habit.walk_mps,
            anatomy,
            blends: skin.blends,
            vertex_blend: skin.vertex_blend,
        }
    }

    /// The body at an instant, in the person's object frame. Feet on the ground are at z = 0.
    pub fn pose(&self, motion: &WalkerMotion) -> BodyPose {
        self.skinned(&self.anatomy.bones(motion))
    }

    /// How the bones stand at an instant: what [`Self::place`] and [`Self::normal`] need.
    pub fn stance(&self, motion: &WalkerMotion) -> Stance {
        self.mixed(&self.anatomy.bones(motion))
    }

    /// Puts the vertices where they are in a stance.
    pub fn place(&self, stance: &Stance, positions: &mut [Vec3]) {
        let rest = self.rest.positions.iter().zip(&self.vertex_blend);
        for (position, (rest, &blend)) in positions.iter_mut().zip(rest) {
            let p = stance.0[usize::from(blend)].transform_point3(*rest);
            // Hems that reach the ground lie on it.
            *position = if p.z < HEM_M && rest.z > 10.0 * HEM_M { p.with_z(HEM_M) } else { p };
        }
    }

    /// The unit normal of a vertex in a stance: it turns with the blended bones.
    pub fn normal(&self, stance: &Stance, vertex: usize) -> Vec3 {
        let follows = &stance.0[usize::from(self.vertex_blend[vertex])];
        follows.transform_vector3(self.rest.normals[vertex]).normalize_or(Vec3::Z)
    }

    /// The skeleton, which tells where joints are.
    pub fn anatomy(&self) -> &Anatomy {
        &self.anatomy
    }

    /// The keypoints at an instant, in the person's object frame.
    pub fn keypoints(&self, motion: &WalkerMotion) -> BodyKeypoints {
        self.anatomy.keypoints(motion)
    }

    /// Where the joint of every bone is at an instant: see [`Anatomy::joints`].
    pub fn joints(&self, motion: &WalkerMotion) -> [Vec3; Bone::ALL.len()] {
        self.anatomy.joints(motion)
    }

    fn mixed(&self, bones: &[Affine3A; BONES]) -> Stance {
        Stance(self.blends.iter().map(|b| b.mix(bones)).collect())
    }

    /// Linear-blend skinning.
    fn skinned(&self, bones: &[Affine3A; BONES]) -> BodyPose {
        let stance = self.mixed(bones);
        let mut positions = vec![Vec3::ZERO; self.rest.positions.len()];
        self.place(&stance, &mut positions);
        let normals = (0..positions.len()).map(|vertex| self.normal(&stance, vertex)).collect();
        BodyPose { positions, normals }
    }
}

#[cfg(test)]
mod tests;
