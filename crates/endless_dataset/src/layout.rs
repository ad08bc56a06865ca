//! The paths of all files of a dataset.

use crate::{
    DatasetError, Layer, MAX_CAMERAS, RgbFormat,
    durable::{sync_folder, sync_tree},
    listing::list,
    temporary::is_temporary,
};
use endless_world::SceneSettings;
use std::{
    fs,
    path::{Path, PathBuf},
};

/// Paths of one dataset.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DatasetLayout {
    root: PathBuf,
}

impl DatasetLayout {
    /// The dataset in this folder.
    pub fn new(root: impl Into<PathBuf>) -> Self {
        Self { root: root.into() }
    }

    /// The folder itself.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// `dataset.json`.
    pub fn manifest(&self) -> PathBuf {
        self.root.join("dataset.json")
    }

    /// The lock that keeps a second process out.
    pub fn lock(&self) -> PathBuf {
        self.root.join(".lock")
    }

    /// The lock of one part of several, of `3-of-8` `.lock-3-of-8`.
    pub fn shard_lock(&self, shard: &str) -> PathBuf {
        self.root.join(format!(".lock-{shard}"))
    }

    /// The lock of whoever takes or leaves one of the other locks, for that moment.
    pub fn lock_gate(&self) -> PathBuf {
        self.root.join(".lock-gate")
    }

    /// `scenes`.
    pub fn scenes(&self) -> PathBuf {
        self.root.join("scenes")
    }

    /// Settings of one video: `scenes/0000.json`.
    pub fn scene(&self, video: u32) -> PathBuf {
        self.scenes().join(format!("{video:04}.json"))
    }

    /// `videos`.
    pub fn videos(&self) -> PathBuf {
        self.root.join("videos")
    }

    /// One video.
    pub fn video(&self, settings: &SceneSettings) -> VideoLayout {
        VideoLayout { folder: self.videos().join(VideoLayout::name(settings)) }
    }

    /// A video by the name of its folder.
    pub fn video_named(&self, name: &str) -> VideoLayout {
        VideoLayout { folder: self.videos().join(name) }
    }
}

/// Paths of one video.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct VideoLayout {
    folder: PathBuf,
}

impl VideoLayout {
    /// The name of a video's folder, e.g. `0000_Town03_rainy_night`.
    pub fn name(settings: &SceneSettings) -> String {
        let SceneSettings { video, map, weather, time_of_day, .. } = settings;
        format!("{video:04}_{map}_{weather}_{time_of_day}")
    }

    /// The folder itself.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// `scene.json`, written last: where it is, the video is complete.
    pub fn scene(&self) -> PathBuf {
        self.folder.join("scene.json")
    }

    /// `builds.json`, written first: which builds of the program have worked on the video.
    pub fn builds(&self) -> PathBuf {
        self.folder.join("builds.json")
    }

    /// Whether anything lies in the folder that is not half-written.
    ///
    /// # Errors
    /// When the folder cannot be read.
    pub fn is_begun(&self) -> Result<bool, DatasetError> {
        Ok(list(&self.folder)?.iter().any(|path| !is_temporary(path)))
    }

    /// `actors.json`, where the simulator knows its objects.
    pub fn actors(&self) -> PathBuf {
        self.folder.join("actors.json")
    }

    /// `frames.jsonl`: the scene in each frame, whatever the cameras see.
    pub fn frames(&self) -> PathBuf {
        self.folder.join("frames.jsonl")
    }

    /// Bytes of all its files.
    ///
    /// # Errors
    /// When a folder or a file cannot be read.
    pub fn bytes(&self) -> Result<u64, DatasetError> {
        bytes_below(&self.folder)
    }

    /// Waits until everything that was written of it is on the disk.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn sync(&self) -> Result<(), DatasetError> {
        sync_tree(&self.folder)?;
        self.folder.parent().map_or(Ok(()), sync_folder)
    }

    /// Name of a camera's folder: `camera_a` for camera 0, `camera_h` for the last that there can be.
    ///
    /// # Panics
    /// If the number is not below [`MAX_CAMERAS`].
    pub fn camera_name(camera: usize) -> String {
        assert!(camera < MAX_CAMERAS as usize, "camera {camera} of at most {MAX_CAMERAS}");
        format!("camera_{}", char::from(b'a' + camera as u8))
    }

    /// One camera, by its number from 0.
    ///
    /// # Panics
    /// If the number is not below [`MAX_CAMERAS`].
    pub fn camera(&self, camera: usize) -> CameraLayout {
        CameraLayout { folder: self.folder.join(Self::camera_name(camera)) }
    }

    /// A sensor of the rig, by its name.
    pub fn sensor(&self, name: &str) -> CameraLayout {
        CameraLayout { folder: self.folder.join(name) }
    }

    /// The first `count` cameras.
    ///
    /// # Panics
    /// If there are more than [`MAX_CAMERAS`].
    pub fn cameras(&self, count: usize) -> impl Iterator<Item = CameraLayout> + use<'_> {
        (0..count).map(|camera| self.camera(camera))
    }
}

/// Paths of one camera of a video, or of another sensor.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CameraLayout {
    folder: PathBuf,
}

impl CameraLayout {
    /// The folder itself.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// `camera.json`.
    pub fn camera(&self) -> PathBuf {
        self.folder.join("camera.json")
    }

    /// `sensor.json`, of sensors of a rig.
    pub fn sensor(&self) -> PathBuf {
        self.folder.join("sensor.json")
    }

    /// `poses.jsonl`, of sensors of a rig: where each was at each of its frames.
    pub fn poses(&self) -> PathBuf {
        self.folder.join("poses.jsonl")
    }

    /// `map.json`: what the camera sees of the map.
    pub fn map(&self) -> PathBuf {
        self.folder.join("map.json")
    }

    /// `objects.jsonl`.
    pub fn objects(&self) -> PathBuf {
        self.folder.join("objects.jsonl")
    }

    /// The video of a layer, e.g. `rgb.mp4`.
    pub fn mp4(&self, layer: Layer) -> PathBuf {
        self.folder.join(format!("{layer}.mp4"))
    }

    /// The folder of a layer's images.
    pub fn layer(&self, layer: Layer) -> PathBuf {
        self.folder.join(layer.name())
    }

    /// One image, e.g. `rgb/000123.png`.
    pub fn frame(&self, layer: Layer, frame: u32, rgb_format: RgbFormat) -> PathBuf {
        self.layer(layer).join(format!("{frame:06}.{}", layer.format(rgb_format)))
    }
}

fn bytes_below(folder: &Path) -> Result<u64, DatasetError> {
    let mut total = 0;
    for path in list(folder)? {
        let data = fs::metadata(&path).map_err(|e| DatasetError::io("cannot read", &path, e))?;
        total += if data.is_dir() { bytes_below(&path)? } else { data.len() };
    }
    Ok(total)
}
