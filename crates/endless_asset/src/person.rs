//! People: a skinned body with clothes, posed by gait.

use crate::Mesh;
use endless_world::WalkerMotion;
use glam::Vec3;

/// One person: mesh, skeleton and skinning of one variant. Proportions, age, sex, clothes, hair and skin follow from the variant's seed.
#[derive(Debug, Clone, PartialEq)]
pub struct PersonModel {
    /// In rest pose, feet on the ground at z = 0, facing +x.
    pub rest: Mesh,
    /// Standing height, metres.
    pub height_m: f32,
    /// Comfortable walking speed, m/s.
    pub walk_mps: f32,
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
    /// The body at an instant, in the person's object frame.
    pub fn pose(&self, _motion: &WalkerMotion) -> BodyPose {
        BodyPose { positions: self.rest.positions.clone(), normals: self.rest.normals.clone() }
    }
}
