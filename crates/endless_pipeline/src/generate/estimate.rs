//! Estimates the disk space that a dataset needs, from its recipe and the files that exist.

use crate::{
    DiskEstimate,
    record::{CameraStream, Stream, StreamModel, count_files},
};
use endless_dataset::{CameraOutput, DatasetError, DatasetLayout, Recipe};
use endless_world::SceneSettings;
use std::path::Path;

/// Bytes a pixel of a video's frame, noise included.
const VIDEO_BYTES_A_PIXEL: f64 = 0.035;
/// Headers, annotations and what a file takes beyond its bytes.
const BYTES_A_FILE: f64 = 4096.0;

/// Of all scenes, or of as many of the largest as may lie on the disk at a time.
pub(super) fn estimate(
    layout: &DatasetLayout,
    recipe: &Recipe,
    remaining_scenes: &[&SceneSettings],
    videos_at_a_time: Option<usize>,
) -> Result<DiskEstimate, DatasetError> {
    let mut missing_frames = 0;
    let mut bytes_of_videos = Vec::with_capacity(remaining_scenes.len());
    for settings in remaining_scenes {
        let mut bytes = 0.0;
        for stream in Stream::all(recipe, settings, &layout.video(settings)) {
            let frames = stream.frames().len() as u64;
            let folders = stream.frame_folders().len() as u64;
            let missing = frames - count_files(&stream)?.checked_div(folders).unwrap_or(0);
            missing_frames += missing;
            let (images, videos) = match &stream.model {
                // A video's samples lie on the disk twice while its index is put in front, and objects take a line a frame.
                StreamModel::Camera(CameraStream { output, .. }) => {
                    let videos = output.mp4.len() as f64 * VIDEO_BYTES_A_PIXEL * output.size.pixels() as f64;
                    (image_bytes(output), videos + BYTES_A_FILE)
                }
                _ => (folders as f64 * BYTES_A_FILE, 0.0),
            };
            bytes += missing as f64 * (images + stream.bytes_a_measurement) + frames as f64 * videos;
        }
        bytes_of_videos.push(bytes);
    }
    bytes_of_videos.sort_by(|a, b| b.total_cmp(a));
    bytes_of_videos.truncate(videos_at_a_time.unwrap_or(usize::MAX));
    let bytes: f64 = bytes_of_videos.iter().sum();
    Ok(DiskEstimate { camera_frames: missing_frames, bytes: bytes as u64, free: free(layout.root())? })
}

/// Of all layers of one frame.
fn image_bytes(output: &CameraOutput) -> f64 {
    let pixels = output.size.pixels() as f64;
    let of_layer = |layer: &endless_dataset::Layer| {
        (layer.entry().bytes_a_pixel)(output.rgb_format, output.look) * pixels + BYTES_A_FILE
    };
    output.layers.iter().map(of_layer).sum()
}

/// Free bytes where the folder is or will be.
fn free(root: &Path) -> Result<u64, DatasetError> {
    let absolute = std::path::absolute(root).unwrap_or_else(|_no_current_folder| root.to_owned());
    let there = absolute.ancestors().find(|p| p.exists()).unwrap_or(Path::new("."));
    fs4::available_space(there).map_err(|e| DatasetError::io("cannot ask for the free space", root, e))
}
