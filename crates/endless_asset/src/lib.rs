//! The catalogue: vehicles, people, plants and street furniture, all made by code, and what is imported from files.
//!
//! Meshes are in the object frame (x forward, y left, z up, metres). The origin of things that stand on the ground is
//! on the ground, under the centre of their footprint.

mod carla;
mod catalogue;
mod furniture;
mod import;
mod person;
mod plant;
mod prop;
mod shape;
mod vehicle;

pub use catalogue::Catalogue;
pub use import::{
    AssetEntry, AssetManifest, Beside, Forward, ImportError, ImportedAsset, ImportedThing, LampPlaces, RiderEntry,
};
pub use person::{Anatomy, BodyPart, BodyPose, Bone, PersonModel, PersonTraits, Stance};
pub use prop::Prop;
pub use vehicle::{Trailer, VehicleKind, VehicleModel, Wheel};
