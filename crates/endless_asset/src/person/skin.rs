//! Which bones a vertex follows.

use super::skeleton::{BONES, Bone};
use crate::Mesh;
use crate::shape::Sculpt;
use glam::{Affine3A, Mat3A, Vec3, Vec3A};

/// A mixture of up to three bones; weights sum to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Blend(pub(crate) [(Bone, f32); 3]);

impl Blend {
    /// One bone.
    pub(crate) fn one(bone: Bone) -> Self {
        Self([(bone, 1.0), (bone, 0.0), (bone, 0.0)])
    }

    /// From `a` (t = 0) to `b` (t = 1).
    pub(crate) fn two(a: Bone, b: Bone, t: f32) -> Self {
        Self([(a, 1.0 - t), (b, t), (a, 0.0)])
    }

    /// Weights rounded to sixteenths, so that few distinct mixtures exist.
    fn rounded(self) -> Self {
        let [(a, _), (b, v), (c, w)] = self.0;
        let (v, w) = ((v * 16.0).round() / 16.0, (w * 16.0).round() / 16.0);
        Self([(a, 1.0 - v - w), (b, v), (c, w)])
    }

    pub(crate) fn mix(&self, bones: &[Affine3A; BONES]) -> Affine3A {
        let mut matrix = Mat3A::ZERO;
        let mut translation = Vec3A::ZERO;
        for &(bone, weight) in &self.0 {
            let m = &bones[bone as usize];
            matrix += m.matrix3 * weight;
            translation += m.translation * weight;
        }
        Affine3A { matrix3: matrix, translation }
    }
}

/// A mesh under construction with its weights.
#[derive(Debug, Clone, Default)]
pub(crate) struct Skin {
    pub(crate) mesh: Mesh,
    pub(crate) blends: Vec<Blend>,
    pub(crate) vertex_blend: Vec<u16>,
}

impl Skin {
    /// Adds a part whose vertices follow the bones that `blend` says.
    pub(crate) fn add(&mut self, part: Sculpt, blend: impl Fn(Vec3) -> Blend) {
        let part = part.into_mesh_without_seams();
        for &p in &part.positions {
            let wanted = blend(p).rounded();
            let index = self.blends.iter().position(|&b| b == wanted).unwrap_or_else(|| {
                self.blends.push(wanted);
                self.blends.len() - 1
            });
            self.vertex_blend.push(index as u16);
        }
        self.mesh.append(&part, Affine3A::IDENTITY);
    }
}
