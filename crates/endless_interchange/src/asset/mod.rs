//! The assets of the catalogue: listed, drawn, imported from folders, exported to files.

mod export;
mod folder;
mod item;
mod list;
mod stand_in;
mod turntable;

pub use export::asset_gltf;
pub use folder::{AssetFolder, AssetFolderError};
pub use item::AssetError;
pub(crate) use item::CatalogueItem;
pub use list::{AssetListing, list_assets};
pub(crate) use stand_in::stand_in;
pub use turntable::asset_preview;
