//! Which bones a vertex follows.

use super::skeleton::{BONES, Bone};
use crate::shape::Sculpt;
use endless_scene::Mesh;
use glam::{Affine3A, Mat3A, Vec3, Vec3A};
use std::collections::BTreeMap;

/// Shares of all bones.
pub(crate) type Weights = [f32; BONES];

/// Weights of one bone.
pub(crate) fn one(bone: Bone) -> Weights {
    let mut w = [0.0; BONES];
    w[bone as usize] = 1.0;
    w
}

/// From `a` (t = 0) to `b` (t = 1).
pub(crate) fn two(a: Bone, b: Bone, t: f32) -> Weights {
    let mut w = [0.0; BONES];
    w[a as usize] += 1.0 - t;
    w[b as usize] += t;
    w
}

/// Mixtures are rounded to this many parts, so that few distinct ones exist.
const PARTS: f32 = 16.0;

/// A mixture of up to four bones; weights sum to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Blend(pub(crate) [(Bone, f32); 4]);

impl Blend {
    /// The four largest shares, rounded.
    fn new(weights: &Weights) -> (Self, [u8; 8]) {
        let mut order = [0usize; BONES];
        for (i, o) in order.iter_mut().enumerate() {
            *o = i;
        }
        order.sort_by(|&a, &b| weights[b].total_cmp(&weights[a]).then(a.cmp(&b)));
        let sum: f32 = order[..4].iter().map(|&i| weights[i]).sum();
        let mut parts = [0u8; 4];
        for k in 1..4 {
            parts[k] = (weights[order[k]] / sum * PARTS).round() as u8;
        }
        parts[0] = PARTS as u8 - parts[1..].iter().sum::<u8>();
        let mut key = [0u8; 8];
        let mut blend = [(Bone::Pelvis, 0.0); 4];
        for k in 0..4 {
            if parts[k] > 0 {
                key[2 * k] = order[k] as u8;
                key[2 * k + 1] = parts[k];
                blend[k] = (Bone::ALL[order[k]], f32::from(parts[k]) / PARTS);
            }
        }
        (Self(blend), key)
    }

    pub(crate) fn mix(&self, bones: &[Affine3A; BONES]) -> Affine3A {
        let mut matrix = Mat3A::ZERO;
        let mut translation = Vec3A::ZERO;
        for &(bone, weight) in &self.0 {
            if weight > 0.0 {
                let m = &bones[bone as usize];
                matrix += m.matrix3 * weight;
                translation += m.translation * weight;
            }
        }
        Affine3A { matrix3: matrix, translation }
    }

    /// The bone that it follows most.
    pub(crate) fn leader(&self) -> Bone {
        self.0.iter().fold((Bone::Pelvis, 0.0), |best, &b| if b.1 > best.1 { b } else { best }).0
    }
}

/// A mesh under construction with its weights.
#[derive(Debug, Clone, Default)]
pub(crate) struct Skin {
    pub(crate) mesh: Mesh,
    pub(crate) blends: Vec<Blend>,
    pub(crate) vertex_blend: Vec<u16>,
    known: BTreeMap<[u8; 8], u16>,
}

impl Skin {
    /// Number of the mixture nearest to these weights.
    fn blend(&mut self, weights: &Weights) -> u16 {
        let (blend, key) = Blend::new(weights);
        *self.known.entry(key).or_insert_with(|| {
            self.blends.push(blend);
            (self.blends.len() - 1) as u16
        })
    }

    /// Adds a mesh with the weights of its vertices.
    pub(crate) fn add_mesh(&mut self, part: &Mesh, weights: impl Fn(usize, Vec3) -> Weights) {
        for (i, &p) in part.positions.iter().enumerate() {
            let index = self.blend(&weights(i, p));
            self.vertex_blend.push(index);
        }
        self.mesh.append(part, Affine3A::IDENTITY);
    }

    /// Adds a part whose vertices follow the bones that `weights` says.
    pub(crate) fn add(&mut self, part: Sculpt, weights: impl Fn(Vec3) -> Weights) {
        self.add_mesh(&part.into_mesh_without_seams(), |_, p| weights(p));
    }

    /// Adds a part that follows one bone.
    pub(crate) fn add_rigid(&mut self, part: Sculpt, bone: Bone) {
        self.add(part, |_| one(bone));
    }
}
