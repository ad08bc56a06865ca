//! A triangle under construction.

use endless_scene::Material;
use glam::Vec3;

/// One triangle, counter-clockwise seen from outside.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Face {
    pub(crate) corners: [Vec3; 3],
    pub(crate) normals: [Vec3; 3],
    pub(crate) material: Material,
}

impl Face {
    /// Normal of the plane, its length twice the area.
    pub(crate) fn area_normal(&self) -> Vec3 {
        (self.corners[1] - self.corners[0]).cross(self.corners[2] - self.corners[0])
    }
}
