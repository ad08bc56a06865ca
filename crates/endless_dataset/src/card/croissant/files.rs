//! The images of a dataset, by layer.

use crate::{Layer, ModelSpec, Recipe, RgbFormat};

/// The images of a layer.
#[derive(Debug)]
pub(super) struct ImageFiles {
    pub(super) layer: Layer,
    pub(super) format: RgbFormat,
    /// Patterns of their paths, one for the scenes' cameras and one for each camera of the rig that stores the layer.
    pub(super) patterns: Vec<String>,
}

/// Patterns of the folders of the scenes' cameras, if there are some.
pub(super) fn camera_folders(recipe: &Recipe) -> Option<&'static str> {
    (recipe.cameras_per_scene > 0).then_some("videos/*/camera_?")
}

/// All images that a recipe stores.
pub(super) fn image_files(recipe: &Recipe) -> Vec<ImageFiles> {
    let folders = |layer: Layer| {
        let usual = camera_folders(recipe).filter(|_| recipe.layers.contains(&layer)).map(str::to_owned);
        let of_rig = recipe.sensor.iter().filter_map(move |sensor| {
            let ModelSpec::Camera(camera) = &sensor.model else { return None };
            let stored = recipe.rig_camera_output(sensor, camera).layers.contains(&layer);
            stored.then(|| format!("videos/*/{}", sensor.name))
        });
        usual.into_iter().chain(of_rig)
    };
    let files = |layer: &Layer| {
        let (layer, format) = (*layer, layer.format(recipe.rgb_format));
        let patterns = folders(layer).map(|folder| format!("{folder}/{layer}/*.{format}")).collect();
        ImageFiles { layer, format, patterns }
    };
    Layer::ALL.iter().map(files).filter(|files| !files.patterns.is_empty()).collect()
}
