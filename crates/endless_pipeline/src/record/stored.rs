//! The measurements of a video that are stored already.

use super::{
    layers::stored_layers_suffice,
    recording::Recording,
    streams::{CameraStream, Stream, StreamModel},
};
use endless_dataset::{CameraLayout, CameraOutput, DatasetError, Layer};
use std::{collections::BTreeSet, ffi::OsString, fs, io, path::Path};

/// Frames that are taken over as they are stored: every layer of all cameras is there.
pub(super) struct StoredFrames {
    present: Vec<bool>,
}

impl StoredFrames {
    /// Looks at the names. Where labels cannot be made again of what is stored, nothing counts as present.
    pub(super) fn find(recording: &Recording<'_>) -> Result<Self, DatasetError> {
        let Recording { settings, streams, .. } = *recording;
        let suffices = |stream: &Stream<'_>| match &stream.model {
            StreamModel::Camera(camera) => stored_layers_suffice(&camera.output),
        };
        let mut present = vec![streams.iter().all(suffices); settings.frames as usize];
        for Stream { files, model: StreamModel::Camera(CameraStream { output, .. }), .. } in streams {
            for &layer in &output.layers {
                mark_missing(&mut present, files, layer, output)?;
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
    output: &CameraOutput,
) -> Result<(), DatasetError> {
    let names = names(camera, layer)?;
    for frame in output.frames() {
        present[frame as usize] &= is_there(&names, camera, layer, frame, output);
    }
    Ok(())
}

fn is_there(
    names: &BTreeSet<OsString>,
    camera: &CameraLayout,
    layer: Layer,
    frame: u32,
    output: &CameraOutput,
) -> bool {
    camera.frame(layer, frame, output.rgb_format).file_name().is_some_and(|name| names.contains(name))
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
    let Recording { streams, layout, .. } = *recording;
    let gone = |path: &Path, removed: io::Result<()>| match removed {
        Err(e) if e.kind() != io::ErrorKind::NotFound => Err(DatasetError::io("cannot remove", path, e)),
        _ => Ok(()),
    };
    gone(&layout.scene(), fs::remove_file(layout.scene()))?;
    for Stream { files, .. } in streams {
        gone(files.folder(), fs::remove_dir_all(files.folder()))?;
    }
    Ok(())
}

/// How many images of a stream are there.
pub(crate) fn count_images(stream: &Stream<'_>) -> Result<u64, DatasetError> {
    let Stream { files, model: StreamModel::Camera(CameraStream { output, .. }), .. } = stream;
    let mut count = 0;
    for &layer in &output.layers {
        let names = names(files, layer)?;
        if !names.is_empty() {
            count += output.frames().filter(|frame| is_there(&names, files, layer, *frame, output)).count() as u64;
        }
    }
    Ok(count)
}

/// Whether every file of a stream is there.
pub(crate) fn stream_is_complete(stream: &Stream<'_>) -> Result<bool, DatasetError> {
    let Stream { files, model: StreamModel::Camera(CameraStream { output, .. }), sensor, .. } = stream;
    let of_rig = sensor.iter().flat_map(|_| [files.sensor(), files.poses()]);
    let mut others = output.mp4.iter().map(|l| files.mp4(*l)).chain([files.camera(), files.objects()]).chain(of_rig);
    Ok(others.all(|path| path.is_file()) && count_images(stream)? == stream.images())
}
