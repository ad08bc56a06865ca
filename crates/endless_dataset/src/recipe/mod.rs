//! The recipe: what decides a dataset's bytes. Users write a [`RecipeDraft`] of options; a [`Recipe`] is complete.

mod counting_lines;
mod option;
mod options;
mod preset;
mod rig;
mod schema;
mod serde_size;
mod user_camera;

pub use option::{OptionDefault, OptionError, OptionKind, RecipeOption, Vocabulary};
pub use options::{MAX_CAMERAS, Recipe, RecipeDraft};
pub use preset::Preset;
pub use rig::{
    CameraSpec, CarrierClass, EventCameraSpec, LidarSpec, ModelSpec, MountSpec, Origin, PanTiltZoomKey,
    PointCloudFormat, SensorSpec, WayPointSpec,
};
pub use schema::recipe_schema;
pub use user_camera::UserCamera;

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
