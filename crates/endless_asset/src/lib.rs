//! The catalogue: procedural vehicles, people, plants and street furniture, and models imported from files.
//!
//! Meshes are in the object frame (x forward, y left, z up, metres). The origin lies on the ground, under the
//! centre of the footprint.
//!
//! A [`Catalogue`] has [`VehicleModel`]s, drawn from designs or read from files; people by seed ([`PersonModel`],
//! [`Anatomy`]); and [`Prop`]s by kind and variant. [`AssetManifest`] and [`AssetEntry`] import models from files.
//!
//! ```
//! use endless_asset::{Catalogue, Prop};
//! use endless_world::{Gait, WalkerMotion};
//!
//! let catalogue = Catalogue::builtin();
//! // Sizes are known at once, meshes are made when they are first needed.
//! let model = catalogue.vehicles().iter().find(|v| v.name() == "car.hatchback").expect("a design");
//! assert!((3.0..5.0).contains(&model.spec.length_m));
//! assert_eq!(model.wheels().len(), 4);
//!
//! // A seed gives a person, a motion gives their pose.
//! let person = catalogue.person(7);
//! let walking = WalkerMotion { speed_mps: person.walk_mps, gait: Gait::Walk, ..WalkerMotion::default() };
//! assert_eq!(person.pose(&walking).positions.len(), person.rest.positions.len());
//!
//! assert!(!catalogue.prop(Prop::Bench, 0).triangles.is_empty());
//! ```

mod carla;
mod catalogue;
mod color_key;
mod furniture;
mod import;
mod person;
mod plant;
mod prop;
mod prop_mesh;
mod shape;
mod vehicle;

pub use catalogue::Catalogue;
pub use furniture::{SignPlate, SignalHead};
pub use import::{
    AssetEntry, AssetManifest, ForwardAxis, ImportError, ImportedAsset, ImportedStaticModel, LampPlaces,
    ReadExternalFile, RiderEntry,
};
pub use person::{Anatomy, BodyPose, Bone, PersonModel, PersonTraits, Stance};
pub use prop::Prop;
pub use vehicle::{Trailer, VehicleDesignSummary, VehicleModel, Wheel};
