//! From an entry of a manifest and the bytes of its file to an asset.

use super::container::{self, Beside};
use super::entry::{AssetClass, AssetEntry};
use super::error::ImportError;
use super::thing::{self, ImportedThing};
use super::{model, sound, vehicle};
use crate::VehicleModel;

/// Longest file, bytes.
pub(crate) const MOST_BYTES: usize = 256 << 20;

/// What a file has become.
#[derive(Debug, Clone)]
pub enum ImportedAsset {
    /// A vehicle that traffic drives and towns park.
    Vehicle(VehicleModel),
    /// Something that stands in towns where others of its class do.
    Thing(ImportedThing),
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
            AssetClass::Vehicle(class) => vehicle::make(self, class, model).map(ImportedAsset::Vehicle),
            AssetClass::Prop(_) | AssetClass::Building => thing::make(self, kind, model).map(ImportedAsset::Thing),
        }
    }
}
