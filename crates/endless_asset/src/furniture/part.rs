//! Parts of which carts, heaps and scaffolds are put together.

use crate::shape::Sculpt;
use endless_scene::Material;
use glam::Vec3;

pub(super) const fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A box with sharp edges.
pub(super) fn block(low: Vec3, high: Vec3, material: Material) -> Sculpt {
    Sculpt::cuboid(low, high, 0.0, material)
}

/// A round bar of a radius.
pub(super) fn rod(a: Vec3, b: Vec3, r: f32, material: Material) -> Sculpt {
    Sculpt::tube(&[(a, r), (b, r)], 8, material)
}
