//! Errors of imported maps. Every message is one line that says what to do.

use endless_dataset::DatasetError;
use endless_road::{opendrive::OpenDriveError, osm::OsmError};
use endless_town::TownError;
use endless_world::TooManyInstances;
use std::path::PathBuf;

/// A map that cannot be imported or read.
#[derive(Debug, thiserror::Error)]
pub enum MapError {
    /// A file cannot be read.
    #[error("cannot read the map: {cause}: {}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why not.
        cause: std::io::Error,
    },
    /// A file of which nobody needs the whole.
    #[error("the map's file is longer than 2 GiB: cut the part out of it that is to be filmed: {}", path.display())]
    TooLong {
        /// The file.
        path: PathBuf,
    },
    /// Neither of the formats.
    #[error("this is neither OpenDRIVE (.xodr) nor OpenStreetMap (.osm, .osm.pbf): {}", path.display())]
    Format {
        /// The file.
        path: PathBuf,
    },
    /// An OpenDRIVE file that is no map.
    #[error("{}: {cause}", path.display())]
    OpenDrive {
        /// The file.
        path: PathBuf,
        /// What is wrong, and where.
        cause: OpenDriveError,
    },
    /// An extract that is no map.
    #[error("{}: {cause}", path.display())]
    Osm {
        /// The file.
        path: PathBuf,
        /// What is wrong, and where.
        cause: OsmError,
    },
    /// The file itself says on which side people drive.
    #[error("the file says that traffic keeps to the {side}: leave out --driving-side: {}", path.display())]
    DrivingSide {
        /// The file.
        path: PathBuf,
        /// What it says.
        side: &'static str,
    },
    /// More vehicles stand parked than can be told apart.
    #[error(transparent)]
    TooManyInstances(#[from] TooManyInstances),
    /// A map that cannot be a town.
    #[error(transparent)]
    Town(#[from] TownError),
    /// A map on which no pair of cameras finds a place.
    #[error("map '{name}' has room for {cameras} cameras, a video needs two: import a larger part")]
    FewCameras {
        /// The map.
        name: String,
        /// How many there are.
        cameras: usize,
    },
    /// A name that a map cannot have.
    #[error("'{name}' cannot be a map's name: give one of letters, digits, _ and - with --name")]
    Name {
        /// The name.
        name: String,
    },
    /// A name that is taken.
    #[error("there is a map '{name}' already: give another name with --name{}", if *.imported { ", or --replace it" } else { "" })]
    Taken {
        /// The name.
        name: String,
        /// Whether it was imported.
        imported: bool,
    },
    /// Nowhere to keep maps.
    #[error("there is no folder for maps: set ENDLESS_MAPS to one")]
    NoFolder,
    /// The store's files do not fit together.
    #[error("the imported map is damaged ({reason}): import it again: {}", path.display())]
    Damaged {
        /// The manifest.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// A town that no `.glb` can hold.
    #[error("map '{name}' is larger than a .glb file can be (4 GiB): import a smaller part")]
    TooLarge {
        /// The map.
        name: String,
    },
    /// A file cannot be written.
    #[error(transparent)]
    Dataset(#[from] DatasetError),
    /// A folder cannot be made.
    #[error("cannot make the folder for maps: {cause}: {}", path.display())]
    Folder {
        /// The folder.
        path: PathBuf,
        /// Why not.
        cause: std::io::Error,
    },
}
