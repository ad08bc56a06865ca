//! The dataset that is exported.

use crate::{ExportError, Sequence};
use endless_dataset::{
    CameraRecord, DatasetLayout, Manifest, ModelSpec, VideoEntry, VideoLayout, VideoState, read_json,
};
use std::{path::Path, sync::Arc};

/// The complete videos of a dataset.
#[derive(Debug, Clone)]
pub struct SourceDataset {
    /// Its files.
    pub layout: DatasetLayout,
    /// `dataset.json`.
    pub manifest: Manifest,
    /// The cameras of its complete videos, video by video.
    pub sequences: Vec<Sequence>,
}

impl SourceDataset {
    /// Opens a dataset. Videos that are not complete are left out.
    ///
    /// # Errors
    /// When there is no dataset, none of its videos is complete, or a camera's record cannot be read.
    pub fn open(root: &Path, stride: u32) -> Result<Self, ExportError> {
        let layout = DatasetLayout::new(root);
        let manifest = Manifest::read(&layout.manifest())?;
        let mut sequences = Vec::new();
        for video in manifest.videos.iter().filter(|video| video.state == VideoState::Complete) {
            sequences.extend(of_video(&layout, &manifest, video, stride)?);
        }
        if sequences.is_empty() {
            return Err(ExportError::NothingComplete { root: root.to_owned() });
        }
        Ok(Self { layout, manifest, sequences })
    }

    /// The sequences of each video, in order.
    pub fn videos(&self) -> impl Iterator<Item = &[Sequence]> {
        self.sequences.chunk_by(|a, b| a.video.video == b.video.video)
    }
}

fn of_video(
    layout: &DatasetLayout,
    manifest: &Manifest,
    entry: &VideoEntry,
    stride: u32,
) -> Result<Vec<Sequence>, ExportError> {
    let (recipe, entry) = (&manifest.recipe, Arc::new(entry.clone()));
    let files = layout.video_named(&entry.name);
    let mut sequences = Vec::new();
    for (camera, site) in entry.cameras.iter().take(recipe.cameras_per_scene as usize).enumerate() {
        let files = files.camera(camera);
        sequences.push(Sequence {
            video: Arc::clone(&entry),
            camera,
            camera_name: VideoLayout::camera_name(camera),
            site: site.clone(),
            record: read_json(&files.camera())?,
            moves: false,
            files,
            output: recipe.camera_output(),
            stride,
        });
    }
    for spec in &recipe.sensor {
        let ModelSpec::Camera(camera) = &spec.model else { continue };
        let files = files.sensor(&spec.name);
        let record: CameraRecord = read_json(&files.camera())?;
        sequences.push(Sequence {
            video: Arc::clone(&entry),
            camera: sequences.len(),
            camera_name: spec.name.clone(),
            site: spec.name.clone(),
            moves: record.world_from_camera.is_none(),
            record,
            files,
            output: recipe.rig_camera_output(spec, camera),
            stride,
        });
    }
    Ok(sequences)
}
