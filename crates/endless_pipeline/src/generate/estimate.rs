//! How much disk a dataset takes.

use crate::record::count_images;
use endless_dataset::{DatasetError, DatasetLayout, Layer, Recipe, RgbFormat};
use endless_world::{LookChoice, SceneSettings};
use std::path::Path;

/// What is still to be made, and the room for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Estimate {
    /// Images of each layer still to be made.
    pub camera_frames: u64,
    /// About so many bytes.
    pub bytes: u64,
    /// Bytes free on the disk.
    pub free: u64,
}

/// Bytes a pixel, a tenth above the dearest scene measured. Four scenes at 1280x720 (rain, fog, clear sky and after rain,
/// by day and by night), each file's bytes by its pixels: 0.45 to 1.11 for RGB, 0.63 to 1.0 for depth, 0.035 to 0.06 for
/// instances; all three of a camera frame 1.1 to 2.0, about 1.7 in the mean.
fn bytes_a_pixel(layer: Layer, rgb_format: RgbFormat, look: LookChoice) -> f64 {
    match (layer, rgb_format) {
        // Noise does not compress: a little of it adds a bit or three a value, much of it all there is.
        (Layer::Rgb, RgbFormat::Png) if look == LookChoice::Natural => 2.1,
        (Layer::Rgb, RgbFormat::Png) if look != LookChoice::Clean => 3.01,
        (Layer::Rgb, RgbFormat::Png) => 1.2,
        (Layer::Rgb, RgbFormat::Jpg) if look != LookChoice::Clean => 0.9,
        (Layer::Rgb, RgbFormat::Jpg) => 0.35,
        (Layer::Depth, _) => 1.1,
        (Layer::Instance, _) => 0.06,
    }
}

/// Bytes a pixel of a video's frame, noise included.
const VIDEO_BYTES_A_PIXEL: f64 = 0.035;
/// Headers, annotations and what a file takes beyond its bytes.
const BYTES_A_FILE: f64 = 4096.0;

pub(super) fn estimate(
    layout: &DatasetLayout,
    recipe: &Recipe,
    to_do: &[&SceneSettings],
) -> Result<Estimate, DatasetError> {
    let mut present = 0;
    for settings in to_do {
        for camera in 0..2 {
            present += count_images(&layout.video(settings).camera(camera), recipe)?;
        }
    }
    let camera_frames = 2 * to_do.len() as u64 * u64::from(recipe.frames());
    let missing = (camera_frames - present / recipe.layers.len() as u64) as f64;
    let pixels = recipe.size.pixels() as f64;
    let images: f64 = recipe
        .layers
        .iter()
        .map(|l| bytes_a_pixel(*l, recipe.rgb_format, recipe.camera_look) * pixels + BYTES_A_FILE)
        .sum();
    // A video's samples lie on the disk twice while its index is put in front, and objects take a line a frame.
    let videos = recipe.mp4.len() as f64 * VIDEO_BYTES_A_PIXEL * pixels * camera_frames as f64;
    let bytes = (missing * images + videos + camera_frames as f64 * BYTES_A_FILE) as u64;
    Ok(Estimate { camera_frames: missing as u64, bytes, free: free(layout.root())? })
}

/// Free bytes where the folder is or will be.
fn free(root: &Path) -> Result<u64, DatasetError> {
    let absolute = std::path::absolute(root).unwrap_or_else(|_no_current_folder| root.to_owned());
    let there = absolute.ancestors().find(|p| p.exists()).unwrap_or(Path::new("."));
    fs4::available_space(there).map_err(|e| DatasetError::io("cannot ask for the free space", root, e))
}
