//! Single assets as files.

use super::item::{AssetError, find};
use crate::gltf;
use endless_asset::Catalogue;

/// One asset as a binary glTF file; `variant` counts its draws and colours.
///
/// # Errors
/// When there is no such asset, or it is too large.
pub fn asset_gltf(catalogue: &Catalogue, name: &str, variant: u64) -> Result<Vec<u8>, AssetError> {
    let too_large = |_: gltf::TooLarge| AssetError::TooLarge { name: name.to_owned() };
    gltf::write_item(&find(catalogue, name, variant)?, name, variant, catalogue).map_err(too_large)
}
