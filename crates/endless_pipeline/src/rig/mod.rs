//! Rigs: what a user wrote of sensors becomes what a scene has.
//!
//! ```text
//! [[sensor]], --rig FILE ── SensorSpec ── resolve ──► Recipe::sensor       names, rates, what is not given
//!                                                           │
//!                                        places of a map ── scene ──► SceneSettings::sensors
//! ```

mod resolve;
mod scene;

use crate::{RecipeError, list_file};
use endless_dataset::SensorSpec;
use serde::Deserialize;
use std::path::Path;

pub(crate) use resolve::resolve;
pub(crate) use scene::{RigPlaces, scene_sensors};

/// A file: `[[sensor]]` of TOML, `{"sensor": [...]}` of JSON.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RigFile {
    sensor: Vec<SensorSpec>,
}

/// Reads a rig: JSON if the file's name ends so, else TOML.
///
/// # Errors
/// [`RecipeError::Unreadable`], or [`RecipeError::Malformed`] with the place.
pub fn read_rig(path: &Path) -> Result<Vec<SensorSpec>, RecipeError> {
    list_file::read(path, "rig").map(|file: RigFile| file.sensor)
}
