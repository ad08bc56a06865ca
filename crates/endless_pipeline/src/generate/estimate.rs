//! Estimates the disk space that a dataset needs, from its recipe and the files that exist.

use crate::{DiskEstimate, record::count_images};
use endless_dataset::{DatasetError, DatasetLayout, Recipe};
use endless_world::SceneSettings;
use std::path::Path;

/// Bytes a pixel of a video's frame, noise included.
const VIDEO_BYTES_A_PIXEL: f64 = 0.035;
/// Headers, annotations and what a file takes beyond its bytes.
const BYTES_A_FILE: f64 = 4096.0;

pub(super) fn estimate(
    layout: &DatasetLayout,
    recipe: &Recipe,
    remaining_scenes: &[&SceneSettings],
) -> Result<DiskEstimate, DatasetError> {
    let mut present = 0;
    for settings in remaining_scenes {
        for camera in layout.video(settings).cameras(settings.cameras.len()) {
            present += count_images(&camera, recipe)?;
        }
    }
    let camera_frames =
        u64::from(recipe.cameras_per_scene) * remaining_scenes.len() as u64 * u64::from(recipe.frames());
    let missing = (camera_frames - present / recipe.layers.len() as u64) as f64;
    let pixels = recipe.size.pixels() as f64;
    let images: f64 = recipe
        .layers
        .iter()
        .map(|l| (l.entry().bytes_a_pixel)(recipe.rgb_format, recipe.camera_look) * pixels + BYTES_A_FILE)
        .sum();
    // A video's samples lie on the disk twice while its index is put in front, and objects take a line a frame.
    let videos = recipe.mp4.len() as f64 * VIDEO_BYTES_A_PIXEL * pixels * camera_frames as f64;
    let bytes = (missing * images + videos + camera_frames as f64 * BYTES_A_FILE) as u64;
    Ok(DiskEstimate { camera_frames: missing as u64, bytes, free: free(layout.root())? })
}

/// Free bytes where the folder is or will be.
fn free(root: &Path) -> Result<u64, DatasetError> {
    let absolute = std::path::absolute(root).unwrap_or_else(|_no_current_folder| root.to_owned());
    let there = absolute.ancestors().find(|p| p.exists()).unwrap_or(Path::new("."));
    fs4::available_space(there).map_err(|e| DatasetError::io("cannot ask for the free space", root, e))
}
