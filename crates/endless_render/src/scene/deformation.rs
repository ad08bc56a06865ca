//! How meshes deform.

use glam::Vec3;
use std::fmt::Debug;

/// How the vertices of a mesh stand at one instant: by bones and weights, say.
pub trait Deformation: Debug + Send + Sync {
    /// Writes where every vertex is: object frame, metres, in the order of the mesh.
    fn positions(&self, positions: &mut [Vec3]);

    /// The unit normal of a vertex, object frame. Asked only of the vertices around a ray's hit.
    fn normal(&self, vertex: usize) -> Vec3;
}
