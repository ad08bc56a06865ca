//! People: a skinned body with clothes, posed by gait.

mod clothes;
mod figure;
mod gait;
mod head;
mod look;
mod posture;
mod rider;
mod skeleton;
mod skin;

use crate::Mesh;
use endless_world::WalkerMotion;
use glam::{Affine3A, Vec3};
pub(crate) use look::Look;
pub(crate) use rider::rider;
use skeleton::{BONES, Skeleton};
use skin::Blend;

/// One person: mesh, skeleton and skinning of one variant. Proportions, age, sex, clothes, hair and skin follow from
/// the variant's seed.
#[derive(Debug, Clone, PartialEq)]
pub struct PersonModel {
    /// In rest pose, feet on the ground at z = 0, facing +x, arms a little away from the body.
    pub rest: Mesh,
    /// Standing height without hair and headgear, metres.
    pub height_m: f32,
    /// Comfortable walking speed, m/s.
    pub walk_mps: f32,
    skeleton: Skeleton,
    /// Distinct mixtures of bones, and which one each vertex follows.
    blends: Vec<Blend>,
    vertex_blend: Vec<u16>,
    /// Habits of moving, from the variant.
    habit: gait::Habit,
}

/// A deformed mesh: same triangles and materials as the rest mesh, new vertices.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BodyPose {
    /// One a vertex of the rest mesh.
    pub positions: Vec<Vec3>,
    /// One a vertex of the rest mesh.
    pub normals: Vec<Vec3>,
}

impl PersonModel {
    /// The person of a variant.
    pub(crate) fn new(variant: u64) -> Self {
        Self::with_look(variant, &Look::of(variant))
    }

    fn with_look(variant: u64, look: &Look) -> Self {
        let skeleton = Skeleton::new(look);
        let skin::Skin { mesh, blends, vertex_blend } = figure::build(look, &skeleton);
        let habit = gait::Habit::new(variant, look);
        Self { rest: mesh, height_m: look.height, walk_mps: habit.walk_mps, skeleton, blends, vertex_blend, habit }
    }

    /// The body at an instant, in the person's object frame. The lowest point is on the ground.
    pub fn pose(&self, motion: &WalkerMotion) -> BodyPose {
        let posture = gait::posture(motion, &self.skeleton, &self.habit);
        let mut pose = self.skinned(&posture.solve(&self.skeleton));
        let lowest = pose.positions.iter().map(|p| p.z).fold(f32::INFINITY, f32::min);
        for p in &mut pose.positions {
            p.z -= lowest;
        }
        pose
    }

    /// Linear-blend skinning; normals turn with the blended bones.
    fn skinned(&self, bones: &[Affine3A; BONES]) -> BodyPose {
        let mixed: Vec<Affine3A> = self.blends.iter().map(|b| b.mix(bones)).collect();
        let n = self.rest.positions.len();
        let mut pose = BodyPose { positions: Vec::with_capacity(n), normals: Vec::with_capacity(n) };
        for i in 0..n {
            let m = &mixed[usize::from(self.vertex_blend[i])];
            pose.positions.push(m.transform_point3(self.rest.positions[i]));
            pose.normals.push(m.transform_vector3(self.rest.normals[i]).normalize_or(Vec3::Z));
        }
        pose
    }
}

#[cfg(test)]
mod tests;
