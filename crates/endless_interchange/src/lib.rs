//! Maps and models in and out: towns and road maps by name, files of maps and of models read, and GeoJSON, OpenDRIVE,
//! binary glTF and pictures written. Nothing here simulates.

mod asset;
mod content_hash;
mod geojson;
mod gltf;
mod library;
mod map;

pub use asset::{AssetError, AssetFolder, AssetFolderError, AssetKind, asset_gltf, asset_preview, list_assets};
pub use library::{ImportedMap, MapLibrary, TownSummary};
pub use map::{About, DrivingSide, ImportOptions, MapError, MapFormat, MapStore, StoredMap};
