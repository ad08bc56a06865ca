//! The manifest of an imported map, kept beside its file.

use endless_world::DrivingSide;
use serde::{Deserialize, Serialize};

/// Format of a map file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum MapFormat {
    /// ASAM OpenDRIVE.
    OpenDrive,
    /// OpenStreetMap, XML or PBF.
    Osm,
}

/// The manifest of an imported map.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StoredMap {
    /// Its name.
    pub name: String,
    /// Its format.
    pub format: MapFormat,
    /// The driving side, if the user gave it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub driving_side: Option<DrivingSide>,
    /// Name of the file that was imported.
    pub source: String,
    /// BLAKE3 of the file, hexadecimal.
    pub blake3: String,
}

impl StoredMap {
    /// What a dataset's recipe says of the map: its file's hash, and the side of traffic where the user said it. The
    /// same text means the same town.
    pub fn content_hash(&self) -> String {
        match self.driving_side {
            None => self.blake3.clone(),
            Some(side) => format!("{}+{}", self.blake3, side.name()),
        }
    }
}

/// How a file is imported.
#[derive(Debug, Clone, Copy, Default)]
pub struct ImportOptions<'a> {
    /// Name of the map; by default the file's, without its endings.
    pub name: Option<&'a str>,
    /// The driving side; by default that of the file or its country.
    pub driving_side: Option<DrivingSide>,
    /// Replace an imported map of the same name.
    pub replace: bool,
}
