//! What is stored of a camera.

use crate::{CameraSpec, Layer, Recipe, RgbFormat, SensorSpec};
use endless_world::{CameraLookChoice, ImageSize};

/// What is stored of a camera: as a recipe says of all, or as a sensor of its rig does.
#[derive(Debug, Clone, PartialEq)]
pub struct CameraOutput {
    /// Layers to store, in their canonical order.
    pub layers: Vec<Layer>,
    /// Layers to write as a video, too.
    pub mp4: Vec<Layer>,
    /// How the RGB layer is stored.
    pub rgb_format: RgbFormat,
    /// Effects on the RGB layer.
    pub look: CameraLookChoice,
    /// Image size.
    pub size: ImageSize,
    /// Frames a second of the scene.
    pub scene_fps: f64,
    /// Frames of the scene.
    pub scene_frames: u32,
    /// It films at every so many frames of the scene, from frame 0 on.
    pub every: u32,
    /// Fewest visible pixels of what is labelled.
    pub min_pixels: u32,
}

impl Recipe {
    /// What is stored of each of a scene's cameras.
    pub fn camera_output(&self) -> CameraOutput {
        CameraOutput {
            layers: self.layers.clone(),
            mp4: self.mp4.clone(),
            rgb_format: self.rgb_format,
            look: self.camera_look,
            size: self.size,
            scene_fps: self.fps,
            scene_frames: self.frames(),
            every: 1,
            min_pixels: self.min_pixels,
        }
    }

    /// What is stored of a camera of the rig; what it does not say is as for all.
    pub fn rig_camera_output(&self, sensor: &SensorSpec, camera: &CameraSpec) -> CameraOutput {
        let usual = self.camera_output();
        CameraOutput {
            layers: camera.layers.clone().unwrap_or(usual.layers),
            mp4: camera.mp4.clone().unwrap_or(usual.mp4),
            look: camera.look.unwrap_or(usual.look),
            size: camera.image_size().unwrap_or(usual.size),
            every: self.every(sensor),
            ..usual
        }
    }

    /// At every so many frames a sensor measures.
    pub fn every(&self, sensor: &SensorSpec) -> u32 {
        sensor.rate.map_or(1, |rate| (self.fps / rate).round().max(1.0) as u32)
    }
}

impl CameraOutput {
    /// Numbers of the scene's frames at which it films.
    pub fn frames(&self) -> impl ExactSizeIterator<Item = u32> + Clone + use<> {
        (0..self.scene_frames).step_by(self.every.max(1) as usize)
    }

    /// How many frames it films.
    pub fn count(&self) -> u32 {
        self.frames().len() as u32
    }

    /// Frames a second.
    pub fn fps(&self) -> f64 {
        self.scene_fps / f64::from(self.every)
    }
}
