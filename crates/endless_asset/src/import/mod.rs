//! Vehicles, props and buildings from glTF 2.0 files (`.glb`), with a manifest that says what they are.
//!
//! A manifest is TOML: one `[[asset]]` a file, see [`AssetEntry`]. Nothing here touches the disk: the caller reads the
//! manifest's text and the files' bytes. Whatever these bytes are, the answer is an asset or an [`ImportError`].
//!
//! Coordinates of glTF are right-handed with y up; its models look along +z unless [`AssetEntry::forward`] says
//! otherwise. They are turned, scaled to their real length, and set down with the middle of their footprint at the
//! origin.

mod accessor;
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

pub use entry::{AssetEntry, AssetManifest, Forward, LampPlaces, RiderEntry};
pub use error::ImportError;
pub use thing::ImportedThing;

use crate::{Prop, VehicleModel};
use endless_world::ObjectClass;

/// Longest file, bytes.
pub(crate) const MOST_BYTES: usize = 256 << 20;

/// Gives the bytes of a picture by its path as seen from the file; `None` if there is none.
pub type Beside<'a> = &'a dyn Fn(&str) -> Option<Vec<u8>>;

/// What a file has become.
#[derive(Debug, Clone)]
pub enum ImportedAsset {
    /// A vehicle that traffic drives and towns park.
    Vehicle(VehicleModel),
    /// Something that stands in towns where others of its class do.
    Thing(ImportedThing),
}

/// What the class of an entry means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Vehicle(ObjectClass),
    Prop(Prop),
    Building,
}

impl AssetEntry {
    /// Judges what the entry says, before its file is read.
    ///
    /// # Errors
    /// [`ImportError::Entry`].
    pub fn check(&self) -> Result<(), ImportError> {
        self.validate(self.kind()?)
    }

    /// Makes the asset of this entry from its file's bytes and pictures beside it.
    ///
    /// # Errors
    /// Whatever keeps the bytes from being the thing that the entry says.
    pub fn import(&self, bytes: &[u8], beside: Beside<'_>) -> Result<ImportedAsset, ImportError> {
        let kind = self.kind()?;
        self.validate(kind)?;
        if bytes.len() > MOST_BYTES {
            return Err(ImportError::TooLong { most_mib: MOST_BYTES >> 20 });
        }
        let document = container::open(bytes, beside)?;
        let model = model::read(&document, self.forward)?;
        sound::judge(&model)?;
        match kind {
            Kind::Vehicle(class) => vehicle::make(self, class, model).map(ImportedAsset::Vehicle),
            Kind::Prop(_) | Kind::Building => thing::make(self, kind, model).map(ImportedAsset::Thing),
        }
    }
}

#[cfg(test)]
mod tests;
