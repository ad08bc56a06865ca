//! How meshes deform.

use glam::Vec3;
use std::fmt::Debug;

/// The vertex positions of a mesh at one instant, for example by bones and weights.
pub trait Deformation: Debug + Send + Sync {
    /// Writes where every vertex is: object frame, metres, in the order of the mesh.
    fn positions(&self, positions: &mut [Vec3]);

    /// The unit normal of a vertex, object frame. Asked only of the vertices around a ray's hit.
    fn normal(&self, vertex: usize) -> Vec3;
}
