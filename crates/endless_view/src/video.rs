//! One video: its settings, its cameras, and how much of it can be shown.

use crate::{
    camera_files::CameraFiles,
    folder::{DatasetFolder, Stamp, is_plain_name},
    refusal::Refusal,
};
use endless_dataset::{DatasetLayout, Layer, Manifest, SceneRecord, VideoEntry, VideoLayout, VideoState};
use endless_world::SceneSettings;

/// A video of the dataset.
#[derive(Debug, Clone)]
pub(crate) struct Video {
    pub(crate) entry: VideoEntry,
    pub(crate) layout: VideoLayout,
    pub(crate) settings: SceneSettings,
    /// What is written when the video is complete.
    pub(crate) record: Option<SceneRecord>,
    pub(crate) cameras: Vec<CameraFiles>,
}

impl Video {
    /// Where the settings of a video stand, and those of which time they are.
    pub(crate) fn source(
        folder: &DatasetFolder,
        layout: &DatasetLayout,
        entry: &VideoEntry,
    ) -> Result<(VideoLayout, Stamp), Refusal> {
        if !is_plain_name(&entry.name) {
            return Err(Refusal::Damaged(format!("dataset.json: video {} has no plain name", entry.video)));
        }
        let video = layout.video_named(&entry.name);
        let path = if entry.state == VideoState::Complete { video.scene() } else { layout.scene(entry.video) };
        let stamp = folder.stamp(&path)?;
        Ok((video, stamp))
    }

    /// Reads it.
    pub(crate) fn read(
        folder: &DatasetFolder,
        layout: &DatasetLayout,
        entry: &VideoEntry,
        video: VideoLayout,
    ) -> Result<Self, Refusal> {
        let (settings, record) = if entry.state == VideoState::Complete {
            let record: SceneRecord = folder.json(&video.scene())?;
            (record.settings.clone(), Some(record))
        } else {
            (folder.json(&layout.scene(entry.video))?, None)
        };
        let cameras = CameraFiles::of(&settings, &video);
        Ok(Self { entry: entry.clone(), layout: video, settings, record, cameras })
    }

    /// One of its cameras.
    pub(crate) fn camera(&self, camera: usize) -> Result<&CameraFiles, Refusal> {
        self.cameras.get(camera).ok_or_else(|| Refusal::Missing(format!("camera {camera} in this video")))
    }

    /// Frames that all cameras show: all of a complete video, those recorded so far of others.
    pub(crate) fn frames_there(&self, folder: &DatasetFolder, manifest: &Manifest) -> u32 {
        if let Some(record) = &self.record {
            return record.recorded_frames;
        }
        let of = |camera: &CameraFiles| {
            let layer = camera.layers(folder).first().copied().unwrap_or(Layer::Rgb);
            camera.frames_there(folder, layer, manifest.recipe.rgb_format).saturating_mul(camera.every)
        };
        self.cameras.iter().map(of).min().unwrap_or(0).min(self.settings.frames)
    }
}
