//! `dataset.json`.

use crate::{LabelSchema, Recipe};
use endless_world::{TimeOfDay, Weather};
use serde::{Deserialize, Serialize};

/// What made the dataset.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Tool {
    /// `endless`.
    pub name: String,
    /// Its version: another version may make other bytes of the same recipe.
    pub version: String,
}

impl Tool {
    /// This build.
    pub fn current() -> Self {
        Self { name: "endless".into(), version: env!("CARGO_PKG_VERSION").into() }
    }
}

/// How far a video is.
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
    /// Its place in the shuffled list.
    pub video: u32,
    /// Its folder below `videos`.
    pub name: String,
    /// How far it is.
    pub state: VideoState,
    /// Map.
    pub map: String,
    /// Weather.
    pub weather: Weather,
    /// Time of day.
    pub time_of_day: TimeOfDay,
    /// Names of the two camera sites.
    pub cameras: [String; 2],
    /// Frames of each camera.
    pub frames: u32,
    /// Annotated boxes of each camera, summed over frames; once complete.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub boxes: Option<[u64; 2]>,
}

/// The whole of `dataset.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Manifest {
    /// Version of the layout on disk.
    pub format: u32,
    /// What made it.
    pub tool: Tool,
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
    /// Version of the layout that this build writes and reads.
    pub const FORMAT: u32 = 1;

    /// The manifest of a planned dataset.
    pub fn new(recipe: Recipe, videos: Vec<VideoEntry>) -> Self {
        Self {
            format: Self::FORMAT,
            tool: Tool::current(),
            seed: recipe.seed,
            recipe,
            labels: LabelSchema::current(),
            videos,
        }
    }
}
