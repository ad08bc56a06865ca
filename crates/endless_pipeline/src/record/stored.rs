//! The images of a video that are stored already.

use super::{layers::stored_layers_suffice, recording::Recording};
use endless_dataset::{CameraLayout, DatasetError, Layer, Recipe};
use std::{collections::BTreeSet, ffi::OsString, fs, io, path::Path};

/// Frames that are taken over as they are stored: every layer of all cameras is there.
pub(super) struct StoredFrames {
    present: Vec<bool>,
}

impl StoredFrames {
    /// Looks at the names. Where labels cannot be made again of what is stored, nothing counts as present.
    pub(super) fn find(recording: &Recording<'_>) -> Result<Self, DatasetError> {
        let Recording { settings, recipe, layout, .. } = *recording;
        let mut present = vec![stored_layers_suffice(recipe); recipe.frames() as usize];
        for camera in layout.cameras(settings.cameras.len()) {
            for &layer in &recipe.layers {
                mark_missing(&mut present, &camera, layer, recipe)?;
            }
        }
        Ok(Self { present })
    }

    pub(super) fn has(&self, frame: u32) -> bool {
        self.present[frame as usize]
    }

    pub(super) fn is_complete(&self) -> bool {
        self.present.iter().all(|p| *p)
    }
}

fn mark_missing(
    present: &mut [bool],
    camera: &CameraLayout,
    layer: Layer,
    recipe: &Recipe,
) -> Result<(), DatasetError> {
    let names = names(camera, layer)?;
    for (present, frame) in present.iter_mut().zip(0..) {
        *present &= camera.frame(layer, frame, recipe).file_name().is_some_and(|name| names.contains(name));
    }
    Ok(())
}

fn names(camera: &CameraLayout, layer: Layer) -> Result<BTreeSet<OsString>, DatasetError> {
    let folder = camera.layer(layer);
    let entries = match fs::read_dir(&folder) {
        Ok(entries) => entries,
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(BTreeSet::new()),
        Err(e) => return Err(DatasetError::io("cannot read the folder", &folder, e)),
    };
    entries
        .map(|entry| Ok(entry.map_err(|e| DatasetError::io("cannot read the folder", &folder, e))?.file_name()))
        .collect()
}

/// Removes the files of a video that cannot be resumed, first the file that marks it as complete.
pub(super) fn remove_stored(recording: &Recording<'_>) -> Result<(), DatasetError> {
    let Recording { settings, layout, .. } = *recording;
    let gone = |path: &Path, removed: io::Result<()>| match removed {
        Err(e) if e.kind() != io::ErrorKind::NotFound => Err(DatasetError::io("cannot remove", path, e)),
        _ => Ok(()),
    };
    gone(&layout.scene(), fs::remove_file(layout.scene()))?;
    for camera in layout.cameras(settings.cameras.len()) {
        gone(camera.folder(), fs::remove_dir_all(camera.folder()))?;
    }
    Ok(())
}

/// How many images of a camera are there.
pub(crate) fn count_images(camera: &CameraLayout, recipe: &Recipe) -> Result<u64, DatasetError> {
    let mut count = 0;
    for &layer in &recipe.layers {
        let names = names(camera, layer)?;
        if names.is_empty() {
            continue;
        }
        let there =
            |frame: &u32| camera.frame(layer, *frame, recipe).file_name().is_some_and(|name| names.contains(name));
        count += (0..recipe.frames()).filter(there).count() as u64;
    }
    Ok(count)
}

/// Whether every file of a camera is there.
pub(crate) fn camera_is_complete(camera: &CameraLayout, recipe: &Recipe) -> Result<bool, DatasetError> {
    let others = recipe.mp4.iter().map(|l| camera.mp4(*l)).chain([camera.camera(), camera.objects()]);
    let all = u64::from(recipe.frames()) * recipe.layers.len() as u64;
    Ok(others.into_iter().all(|path| path.is_file()) && count_images(camera, recipe)? == all)
}
