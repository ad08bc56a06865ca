//! What one camera recorded of one video.

use endless_dataset::{CameraLayout, CameraOutput, CameraRecord, Layer, VideoEntry};
use std::{path::PathBuf, sync::Arc};

/// The frames of one camera of a complete video.
#[derive(Debug, Clone)]
pub struct Sequence {
    /// Its video.
    pub video: Arc<VideoEntry>,
    /// Place among the cameras of the video, those of a rig after the others.
    pub camera: usize,
    /// Its folder in the video's: `camera_a`, or the name of a rig's camera.
    pub camera_name: String,
    /// Name of its site on the map; of a rig's camera its own name.
    pub site: String,
    /// `camera.json`.
    pub record: CameraRecord,
    /// Whether it moves, so that `poses.jsonl` tells where it is.
    pub moves: bool,
    /// Its files.
    pub files: CameraLayout,
    /// What is stored of it.
    pub output: CameraOutput,
    /// Of its frames every so many are exported.
    pub stride: u32,
}

impl Sequence {
    /// A name that no other sequence of the dataset has: `0000_Town03_rainy_night_camera_a`.
    pub fn name(&self) -> String {
        format!("{}_{}", self.video.name, self.camera_name)
    }

    /// The numbers of the frames that are exported.
    pub fn frames(&self) -> impl ExactSizeIterator<Item = u32> + Clone + use<> {
        self.output.frames().step_by(self.stride.max(1) as usize)
    }

    /// How many they are.
    pub fn len(&self) -> usize {
        self.frames().len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Frames a second of what is exported.
    pub fn fps(&self) -> f64 {
        self.output.fps() / f64::from(self.stride.max(1))
    }

    /// The name of a frame that no other frame of the dataset has, without an ending.
    pub fn frame_name(&self, frame: u32) -> String {
        format!("{}_{frame:06}", self.name())
    }

    /// An image of a frame.
    pub fn image(&self, layer: Layer, frame: u32) -> PathBuf {
        self.files.frame(layer, frame, self.output.rgb_format)
    }

    /// How the files of a layer end: `png` or `jpg`.
    pub fn extension(&self, layer: Layer) -> &'static str {
        layer.format(self.output.rgb_format).name()
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use endless_dataset::{DatasetLayout, RgbFormat, VideoState};
    use endless_world::{CameraLookChoice, Distortion, ImageSize, LensModel, TimeOfDay, Weather};

    /// A sequence of a dataset that is nowhere.
    pub(crate) fn sequence(video: u32, map: &str, camera: usize, site: &str) -> Sequence {
        let name = format!("{video:04}_{map}_rainy_night");
        let size = ImageSize { width: 64, height: 48 };
        let entry = VideoEntry {
            video,
            name: name.clone(),
            state: VideoState::Complete,
            map: map.into(),
            weather: Weather::Rainy,
            time_of_day: TimeOfDay::Night,
            cameras: vec![site.into()],
            frames: 10,
            boxes: None,
            builds: Vec::new(),
        };
        Sequence {
            video: Arc::new(entry),
            camera,
            camera_name: endless_dataset::VideoLayout::camera_name(camera),
            site: site.into(),
            record: CameraRecord::moving(LensModel::Pinhole, 1.0, Distortion::NONE, size, 10.0),
            moves: false,
            files: DatasetLayout::new("nowhere").video_named(&name).camera(camera),
            output: CameraOutput {
                layers: vec![Layer::Rgb],
                mp4: Vec::new(),
                rgb_format: RgbFormat::Png,
                look: CameraLookChoice::Clean,
                size,
                scene_fps: 10.0,
                scene_frames: 10,
                every: 1,
                min_pixels: 1,
            },
            stride: 1,
        }
    }

    #[test]
    fn every_third_of_ten_frames_is_four() {
        let sequence = Sequence { stride: 3, ..sequence(0, "Town01", 0, "a") };
        assert_eq!(sequence.frames().collect::<Vec<_>>(), [0, 3, 6, 9]);
        assert_eq!(sequence.frame_name(9), "0000_Town01_rainy_night_camera_a_000009");
        assert!((sequence.fps() - 10.0 / 3.0).abs() < 1e-12);
    }
}
