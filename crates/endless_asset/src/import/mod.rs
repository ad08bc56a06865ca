//! Vehicles, props and buildings from glTF 2.0 files (`.glb`), described by a manifest.
//!
//! A manifest is TOML: one `[[asset]]` a file, see [`AssetEntry`]. Nothing here touches the disk: the caller reads the
//! manifest's text and the files' bytes. Whatever these bytes are, the answer is an asset or an [`ImportError`].
//!
//! Coordinates of glTF are right-handed with y up; its models look along +z unless [`AssetEntry::forward`] says
//! otherwise. They are turned, scaled to their real length, and set down with the middle of their footprint at the
//! origin.

mod accessor;
mod asset;
mod container;
mod entry;
mod error;
mod lamp;
mod model;
mod source_material;
mod static_model;
mod surface_check;
mod texture;
mod texture_bake;
mod vehicle;

pub use asset::ImportedAsset;
pub use container::ReadExternalFile;
pub use entry::{AssetEntry, AssetManifest, ForwardAxis, LampPlaces, RiderEntry};
pub use error::ImportError;
pub use static_model::ImportedStaticModel;

#[cfg(test)]
mod tests;
