//! The resolved recipe: everything that decides a dataset's bytes.

use crate::{Layer, RgbFormat};
use endless_world::{CameraLookChoice, CameraSite, ImageSize, TimeOfDay, Weather};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Everything that decides a dataset's bytes, complete and validated. Lists are in their canonical order, without
/// repetition.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Recipe {
    /// How many videos.
    pub videos: u32,
    /// Vehicles asked for in each (parked ones come on top).
    pub vehicles: u32,
    /// Pedestrians asked for in each.
    pub pedestrians: u32,
    /// Maps to choose from.
    pub maps: Vec<String>,
    /// Hash of the content of each map among them that was imported from a file, by its name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub map_files: BTreeMap<String, String>,
    /// Hash of the manifest and of each file of imported models, by its name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub asset_files: BTreeMap<String, String>,
    /// Cameras that film in place of a map's own, by its name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub cameras: BTreeMap<String, Vec<CameraSite>>,
    /// Cameras that film each scene, 1 to [`crate::MAX_CAMERAS`].
    #[serde(default = "pair")]
    pub cameras_per_scene: u32,
    /// Weathers to choose from.
    pub weathers: Vec<Weather>,
    /// Times of day to choose from.
    pub times: Vec<TimeOfDay>,
    /// Image size.
    #[serde(with = "size_as_text")]
    pub size: ImageSize,
    /// Frames a second.
    pub fps: f64,
    /// Seconds of each video.
    pub duration: f64,
    /// Seed of everything random.
    pub seed: u64,
    /// Layers that are stored.
    pub layers: Vec<Layer>,
    /// What lens, sensor and recorder do to the RGB layer.
    #[serde(default = "clean", skip_serializing_if = "is_clean")]
    pub camera_look: CameraLookChoice,
    /// How the RGB layer is stored.
    pub rgb_format: RgbFormat,
    /// Objects with fewer visible pixels are not annotated.
    pub min_pixels: u32,
    /// Layers of which a video file is made.
    pub mp4: Vec<Layer>,
    /// What simulates: `builtin`.
    pub simulator: String,
}

/// As in the paper.
fn pair() -> u32 {
    2
}

fn clean() -> CameraLookChoice {
    CameraLookChoice::Clean
}

fn is_clean(look: &CameraLookChoice) -> bool {
    *look == CameraLookChoice::Clean
}

impl Recipe {
    /// Frames of each camera of each video: `round(fps × duration)`.
    pub fn frames(&self) -> u32 {
        (self.fps * self.duration).round() as u32
    }

    /// The first field in which two recipes differ and its two values, `videos` left out.
    pub fn first_difference(&self, other: &Self) -> Option<(String, String, String)> {
        let fields = |recipe: &Self| match serde_json::to_value(recipe) {
            Ok(serde_json::Value::Object(map)) => map,
            _ => unreachable!("a recipe is a plain struct"),
        };
        let (mine, theirs) = (fields(self), fields(other));
        // Some fields are left out where they say nothing: those of both are looked at.
        let value = |of: &serde_json::Map<_, _>, name: &String| of.get(name).map(plain).unwrap_or_default();
        mine.keys()
            .chain(theirs.keys())
            .find(|name| *name != "videos" && mine.get(*name) != theirs.get(*name))
            .map(|name| (name.clone(), value(&mine, name), value(&theirs, name)))
    }
}

/// A value as one would write it on the command line.
fn plain(value: &serde_json::Value) -> String {
    match value {
        serde_json::Value::String(text) => text.clone(),
        serde_json::Value::Array(items) => items.iter().map(plain).collect::<Vec<_>>().join(","),
        other => other.to_string(),
    }
}

mod size_as_text {
    use endless_world::ImageSize;
    use serde::{Deserialize, Deserializer, Serializer, de::Error};

    pub(super) fn serialize<S: Serializer>(size: &ImageSize, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(size)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<ImageSize, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(D::Error::custom)
    }
}
