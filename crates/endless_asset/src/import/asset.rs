//! From an entry of a manifest and the bytes of its file to an asset.

use super::container::{self, ReadExternalFile};
use super::entry::{AssetClass, AssetEntry};
use super::error::ImportError;
use super::static_model::{self, ImportedStaticModel};
use super::{model, surface_check, vehicle};
use crate::VehicleModel;

/// Longest file, bytes.
pub(crate) const MOST_BYTES: usize = 256 << 20;

/// An asset made of a file.
#[derive(Debug, Clone)]
pub enum ImportedAsset {
    /// A vehicle that traffic drives and towns park.
    Vehicle(VehicleModel),
    /// A prop or building that stands in towns in place of others of its class.
    StaticModel(ImportedStaticModel),
}

impl AssetEntry {
    /// Checks the entry before its file is read.
    ///
    /// # Errors
    /// [`ImportError::Entry`].
    pub fn check(&self) -> Result<(), ImportError> {
        self.validate(self.kind()?)
    }

    /// Makes the asset of this entry from its file's bytes and the image files beside it.
    ///
    /// # Errors
    /// What keeps the file from being the asset that the entry describes.
    pub fn import(&self, bytes: &[u8], read_external: ReadExternalFile<'_>) -> Result<ImportedAsset, ImportError> {
        let kind = self.kind()?;
        self.validate(kind)?;
        if bytes.len() > MOST_BYTES {
            return Err(ImportError::TooLong { most_mib: MOST_BYTES >> 20 });
        }
        let document = container::open(bytes, read_external)?;
        let model = model::read(&document, self.forward)?;
        surface_check::check(&model)?;
        match kind {
            AssetClass::Vehicle(class) => vehicle::make(self, class, model).map(ImportedAsset::Vehicle),
            AssetClass::Prop(_) | AssetClass::Building => {
                static_model::make(self, kind, model).map(ImportedAsset::StaticModel)
            }
        }
    }
}
