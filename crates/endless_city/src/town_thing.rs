//! Things of a town that can be taken out of sight.

use endless_render::{Geometry, Instance};
use endless_scene::Mesh;
use endless_world::ClassTag;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// A thing that stands in a town, by its place in the town's list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum TownThing {
    /// Of its placements.
    Placed(u32),
    /// Of its parked vehicles.
    Parked(u32),
}

/// Meshes with parts left out, each made once: things of one kind share it.
#[derive(Default)]
pub(crate) struct Remains(BTreeMap<(*const Mesh, BTreeSet<ClassTag>), Geometry>);

impl Remains {
    /// What is left of an instance without its parts of some classes; `None` if nothing is.
    pub(crate) fn of(&mut self, instance: &Instance, hides: impl Fn(ClassTag) -> bool) -> Option<Instance> {
        if let Some(class) = instance.class() {
            return (!hides(class)).then(|| instance.clone());
        }
        let geometry = instance.geometry();
        let mesh = geometry.mesh();
        let hidden: BTreeSet<ClassTag> =
            mesh.materials.iter().map(|material| material.tag).filter(|tag| hides(*tag)).collect();
        if hidden.is_empty() {
            return Some(instance.clone());
        }
        if mesh.materials.iter().all(|material| hidden.contains(&material.tag)) {
            return None;
        }
        let is_hidden = |tag: ClassTag| hidden.contains(&tag);
        let remains = self
            .0
            .entry((Arc::as_ptr(mesh), hidden.clone()))
            .or_insert_with(|| geometry.without(|material| is_hidden(material.tag)));
        (!remains.is_empty()).then(|| instance.clone().with_geometry(remains))
    }
}
