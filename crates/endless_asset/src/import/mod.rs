//! Vehicles, props and buildings from glTF 2.0 files (`.glb`), with a manifest that says what they are.
//!
//! A manifest is TOML: one `[[asset]]` a file, see [`AssetEntry`]. Nothing here touches the disk: the caller reads the
//! manifest's text and the files' bytes. Whatever these bytes are, the answer is an asset or an [`ImportError`].
//!
//! Coordinates of glTF are right-handed with y up; its models look along +z unless [`AssetEntry::forward`] says
//! otherwise. They are turned, scaled to their real length, and set down with the middle of their footprint at the
//! origin.

mod accessor;
mod asset;
mod coat;
mod container;
mod entry;
mod error;
mod lamp;
mod model;
mod paint;
mod picture;
mod sound;
mod thing;
mod vehicle;

pub use asset::ImportedAsset;
pub use container::Beside;
pub use entry::{AssetEntry, AssetManifest, Forward, LampPlaces, RiderEntry};
pub use error::ImportError;
pub use thing::ImportedThing;

#[cfg(test)]
mod tests;
