//! `dataset.json`.

use crate::{BuildIdentity, DatasetError, LabelSchema, Recipe, read_json};
use endless_world::{TimeOfDay, Weather};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// State of a video.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum VideoState {
    /// Not complete yet.
    Planned,
    /// Complete.
    Complete,
}

/// One video in `dataset.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct VideoEntry {
    /// Its number in the plan.
    pub video: u32,
    /// Its folder below `videos`.
    pub name: String,
    /// Its state.
    pub state: VideoState,
    /// Map.
    pub map: String,
    /// Weather.
    pub weather: Weather,
    /// Time of day.
    pub time_of_day: TimeOfDay,
    /// Names of the camera sites.
    pub cameras: Vec<String>,
    /// Frames of each camera.
    pub frames: u32,
    /// Annotated boxes of each camera, summed over frames; once complete.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub boxes: Option<Vec<u64>>,
    /// Which of the manifest's `builds` have worked on it, as its `builds.json` says; none before it is begun.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub builds: Vec<usize>,
}

/// The whole of `dataset.json`: an index which can be made again of the recipe, its plan and what lies in `videos`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Manifest {
    /// Version of the layout on disk.
    pub format: u32,
    /// The program's name.
    pub tool: String,
    /// The builds of the program that were at work, in the order of the videos that they worked on; where none is begun, the
    /// one that planned them.
    pub builds: Vec<BuildIdentity>,
    /// The recipe's seed, repeated where one looks for it.
    pub seed: u64,
    /// The resolved recipe.
    pub recipe: Recipe,
    /// Label schema.
    pub labels: LabelSchema,
    /// One a video, by number.
    pub videos: Vec<VideoEntry>,
}

impl Manifest {
    /// Version of the layout that this build writes.
    pub const FORMAT: u32 = 3;

    /// The oldest that it reads. Before 3, no video had a `builds.json`, and this file alone said which builds made it.
    pub const OLDEST_FORMAT: u32 = 2;

    /// Whether this build reads a version of the layout.
    pub fn reads(format: u32) -> bool {
        (Self::OLDEST_FORMAT..=Self::FORMAT).contains(&format)
    }

    /// The manifest of a planned dataset.
    pub fn new(recipe: Recipe, builds: Vec<BuildIdentity>, videos: Vec<VideoEntry>) -> Self {
        let mut labels = LabelSchema::current();
        if recipe.traffic_file.is_some() {
            labels.actors = labels.actors.with_tracks();
        }
        Self { format: Self::FORMAT, tool: "endless".into(), builds, seed: recipe.seed, recipe, labels, videos }
    }

    /// Reads `dataset.json`.
    ///
    /// # Errors
    /// [`DatasetError::OtherFormat`] if another format is written there; when it is missing or not a manifest.
    pub fn read(path: &Path) -> Result<Self, DatasetError> {
        // A manifest of another format need not have the fields of this one.
        #[derive(Deserialize)]
        struct FormatOnly {
            format: u32,
        }
        let FormatOnly { format } = read_json(path)?;
        if !Self::reads(format) {
            return Err(DatasetError::OtherFormat {
                found: format,
                oldest: Self::OLDEST_FORMAT,
                expected: Self::FORMAT,
                path: path.to_owned(),
            });
        }
        read_json(path)
    }
}
