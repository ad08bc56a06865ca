//! Maps and models in and out: towns and road maps by name, files of maps and of models read, and OpenDRIVE, GeoJSON,
//! binary glTF and pictures written. Nothing here simulates.
//!
//! [`MapLibrary`] knows every map there is: the built-in towns, and those that [`MapLibrary::import`] made of files and
//! keeps in a [`MapStore`]. Towns are furnished from its catalogue, which an [`AssetFolder`] of models extends.
//! [`list_assets`], [`asset_preview`] and [`asset_gltf`] show what a catalogue holds.
//!
//! What the formats hold, and in which units and frames, is in `docs/maps.md` and `docs/assets.md`.
//!
//! ```
//! use endless_interchange::MapLibrary;
//!
//! let library = MapLibrary::builtin();
//! let summary = library.summary("Town02")?;
//! assert!(summary.cameras.len() > 1, "a video is filmed by cameras of the map");
//! let roads = library.opendrive("Town02")?;
//! assert!(roads.contains("<OpenDRIVE"));
//! # Ok::<(), endless_interchange::MapError>(())
//! ```

mod asset;
mod content_hash;
mod geojson;
mod gltf;
mod library;
mod map;

pub use asset::{AssetError, AssetFolder, AssetFolderError, AssetListing, asset_gltf, asset_preview, list_assets};
pub use library::{ImportedMap, MapLibrary, TownSummary, details_near};
pub use map::{ImportOptions, MapError, MapFormat, MapStatistics, MapStore, StoredMap};
