//! What stands in a town, and where.

use endless_asset::Prop;
use endless_world::SignalId;
use glam::Affine3A;

/// The object of a placement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum PlacedObject {
    /// One of the town's own meshes.
    TownMesh(u32),
    /// A prop of the catalogue and its variant.
    Prop(Prop, u32),
}

/// A mesh standing in the town.
#[derive(Debug, Clone, PartialEq)]
pub struct Placement {
    /// The object.
    pub object: PlacedObject,
    /// Where.
    pub world_from_object: Affine3A,
    /// The signal group that lights its lenses.
    pub signal: Option<SignalId>,
}
