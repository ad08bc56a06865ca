//! What of a mesh is solid.

use crate::physics::OrientedBox;
use endless_scene::{Material, Mesh, Surface};
use endless_world::ClassTag;
use glam::Vec3;

/// A solid part of a thing, in the thing's own frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Part {
    pub(super) tag: ClassTag,
    /// All classes that it has anything of, a bit each.
    pub(super) classes: u32,
    pub(super) outline: OrientedBox,
}

/// The bit of a class.
pub(super) fn bit(class: ClassTag) -> u32 {
    1 << class.value()
}

/// Whether bodies stop at it: leaves and water do not stop them, and on ground they stand.
fn is_solid(material: &Material) -> bool {
    use ClassTag::{Ground, RailTrack, RoadLines, Roads, Sidewalks, Sky, Terrain, Water};
    !matches!(material.surface, Surface::Foliage | Surface::Water | Surface::Grass)
        && !matches!(material.tag, Ground | RailTrack | RoadLines | Roads | Sidewalks | Sky | Terrain | Water)
}

/// The solid triangles of a mesh.
pub(super) fn solid_triangles(mesh: &Mesh) -> impl Iterator<Item = ([Vec3; 3], ClassTag)> {
    mesh.triangles.iter().zip(&mesh.triangle_materials).filter_map(|(corners, &material)| {
        let material = mesh.materials.get(usize::from(material)).filter(|material| is_solid(material))?;
        let [a, b, c] = corners.map(|corner| mesh.positions.get(corner as usize).copied());
        Some(([a?, b?, c?], material.tag))
    })
}
