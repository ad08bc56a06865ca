//! Import and export: towns and road maps by name, map files and models read, and OpenDRIVE, GeoJSON, binary glTF and
//! previews written. Nothing here simulates.
//!
//! [`MapLibrary`] has all maps by name: the built-in towns, and those that [`MapLibrary::import`] read from files and keeps
//! in a [`MapStore`]. Towns are furnished from its catalogue, which an [`AssetFolder`] of models extends. [`list_assets`],
//! [`asset_preview`] and [`asset_gltf`] list, draw and export the catalogue.
//!
//! A [`TrackFile`] is recorded motion, to be played on a map; a [`TrajectoryWriter`] writes such files, and a [`TopView`] draws
//! road users on the map from above.
//!
//! `docs/maps.md` and `docs/assets.md` describe the formats with their units and frames.
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
mod signal_cycle;
mod top_view;
mod track_file;
mod trajectory;
mod user_folder;

pub use asset::{AssetError, AssetFolder, AssetFolderError, AssetListing, asset_gltf, asset_preview, list_assets};
pub use library::{ImportedMap, MapLibrary, TownSummary};
pub use map::{ImportOptions, MapError, MapFormat, MapStatistics, MapStore, StoredMap};
pub use top_view::TopView;
pub use track_file::{TrackFault, TrackFile, TrackFileError};
pub use trajectory::{TrajectoryFormat, TrajectoryLane, TrajectoryRow, TrajectoryScene, TrajectoryWriter};
pub use user_folder::user_data_folder;
