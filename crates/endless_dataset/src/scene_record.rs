//! JSON files: the settings of a scene, and its results.

use crate::{DatasetError, write_atomic, write_durable};
use endless_world::{Incident, IncidentKind, SceneSettings};
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use std::{fs, path::Path};

/// Numbers of actors that were placed in a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct SpawnCounts {
    /// Moving vehicles; fewer than the recipe asks for if the map is full.
    pub vehicles: u32,
    /// Pedestrians.
    pub pedestrians: u32,
    /// Parked vehicles.
    pub parked: u32,
}

/// `scene.json` of a video: its settings plus what happened. Written last, so that its presence means "complete".
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneRecord {
    /// The settings, as in `scenes/`.
    #[serde(flatten)]
    pub settings: SceneSettings,
    /// Numbers of actors.
    pub spawned: SpawnCounts,
    /// What happens of the events that the settings ask for.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub incidents: Vec<Incident>,
    /// Events of the settings that could not be had where the cameras look.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub missed_events: Vec<IncidentKind>,
    /// Entries of `actors.json`; none if the simulator does not know its objects, and there is no such file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub actors: Option<u32>,
    /// Lines of `frames.jsonl`; none if the simulator does not tell of frames, and there is no such file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frame_lines: Option<u32>,
    /// How many cameras have a `map.json`; none if the simulator knows no maps.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub camera_maps: Option<u32>,
    /// Frames recorded by each camera.
    pub recorded_frames: u32,
    /// Annotated boxes of each camera, summed over frames.
    pub boxes: Vec<u64>,
    /// The same of each sensor of the rig.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sensor_boxes: Vec<u64>,
}

/// Writes a value as readable JSON.
///
/// # Errors
/// When the disk refuses.
pub fn write_json<T: Serialize>(path: &Path, value: &T) -> Result<(), DatasetError> {
    write_atomic(path, &json_text(path, value)?)
}

/// Writes a value as JSON on one line.
///
/// # Errors
/// When the disk refuses.
pub fn write_json_line<T: Serialize>(path: &Path, value: &T) -> Result<(), DatasetError> {
    let mut text = serde_json::to_vec(value).map_err(|e| DatasetError::malformed(path, e))?;
    text.push(b'\n');
    write_atomic(path, &text)
}

/// Writes a value as readable JSON, which is there after a power failure, too.
///
/// # Errors
/// When the disk refuses.
pub fn write_json_durable<T: Serialize>(path: &Path, value: &T) -> Result<(), DatasetError> {
    write_durable(path, &json_text(path, value)?)
}

/// A value as readable JSON.
pub(crate) fn json_text<T: Serialize>(path: &Path, value: &T) -> Result<Vec<u8>, DatasetError> {
    let mut text = serde_json::to_vec_pretty(value).map_err(|e| DatasetError::malformed(path, e))?;
    text.push(b'\n');
    Ok(text)
}

/// Reads a JSON file.
///
/// # Errors
/// When it is missing or not what it should be.
pub fn read_json<T: DeserializeOwned>(path: &Path) -> Result<T, DatasetError> {
    let text = fs::read(path).map_err(|e| DatasetError::io("cannot read", path, e))?;
    serde_json::from_slice(&text).map_err(|e| DatasetError::malformed(path, format!("is not what it should be ({e})")))
}
