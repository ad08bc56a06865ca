//! The settings of one scene: what the paper writes as JSON before anything is simulated.

use crate::{CameraLook, CameraSite, ImageSize, TimeOfDay, Weather};
use serde::{Deserialize, Serialize};

/// Everything that decides one video.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneSettings {
    /// The video's place in the shuffled list.
    pub video: u32,
    /// Map name, e.g. `Town03`.
    pub map: String,
    /// Weather.
    pub weather: Weather,
    /// Time of day.
    pub time_of_day: TimeOfDay,
    /// The pair of cameras, filming the same instants.
    pub cameras: [CameraSite; 2],
    /// What lens, sensor and recorder of each do to the picture.
    #[serde(default, skip_serializing_if = "all_clean")]
    pub looks: [CameraLook; 2],
    /// Vehicles asked for (parked ones come on top).
    pub vehicles: u32,
    /// Pedestrians asked for.
    pub pedestrians: u32,
    /// Image size.
    pub size: ImageSize,
    /// Frames a second.
    pub fps: f64,
    /// Frames of each camera: `round(fps × duration)`.
    pub frames: u32,
    /// Seed of everything random in this scene.
    pub seed: u64,
}

fn all_clean(looks: &[CameraLook; 2]) -> bool {
    looks.iter().all(CameraLook::is_clean)
}
