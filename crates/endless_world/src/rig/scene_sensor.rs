//! One sensor of a scene's rig.

use super::SensorMount;
use crate::{CameraLook, ImageSize};
use serde::{Deserialize, Serialize};

/// A sensor of a scene besides its fixed pair or network of cameras.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneSensor {
    /// Its folder; unique in the rig.
    pub name: String,
    /// It measures at every so many frames of the video, from frame 0 on.
    pub every: u32,
    /// What decides where it is.
    pub mount: SensorMount,
    /// What it is.
    #[serde(flatten)]
    pub model: SensorModel,
}

/// What a sensor is, and its settings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum SensorModel {
    /// A camera.
    Camera(RigCamera),
}

/// A camera of a rig.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RigCamera {
    /// Image size.
    pub size: ImageSize,
    /// Horizontal field of view, radians; of a lens that zooms the mount's way-points have others.
    pub horizontal_fov_rad: f64,
    /// Effects of its lens, sensor and recorder on the picture.
    pub look: CameraLook,
}

impl SceneSensor {
    /// Whether it measures at a frame of the video.
    pub fn measures_at(&self, frame: u32) -> bool {
        frame.is_multiple_of(self.every)
    }
}
