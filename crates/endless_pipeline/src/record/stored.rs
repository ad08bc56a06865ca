//! The measurements of a video that are stored already.

use super::{
    layers::stored_layers_suffice,
    recording::Recording,
    streams::{Stream, StreamModel},
};
use endless_dataset::DatasetError;
use std::{
    collections::BTreeSet,
    ffi::OsString,
    fs, io,
    path::{Path, PathBuf},
};

/// Frames that are taken over as they are stored: every file of all streams is there.
pub(super) struct StoredFrames {
    present: Vec<bool>,
}

impl StoredFrames {
    /// Looks at the names. Where labels cannot be made again of what is stored, or events of what lies between two
    /// pictures, nothing counts as present.
    pub(super) fn find(recording: &Recording<'_>) -> Result<Self, DatasetError> {
        let Recording { settings, streams, .. } = *recording;
        let suffices = |stream: &Stream<'_>| match &stream.model {
            StreamModel::Camera(camera) => stored_layers_suffice(&camera.output),
            StreamModel::Events { .. } => false,
            _ => true,
        };
        let mut present = vec![streams.iter().all(suffices); settings.frames as usize];
        for stream in streams {
            for (folder, extension) in stream.frame_folders() {
                let names = names(&folder)?;
                for frame in stream.frames() {
                    present[frame as usize] &= names.contains(&*file_name(frame, &extension));
                }
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

fn file_name(frame: u32, extension: &str) -> OsString {
    format!("{frame:06}.{extension}").into()
}

fn names(folder: &Path) -> Result<BTreeSet<OsString>, DatasetError> {
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(BTreeSet::new()),
        Err(e) => return Err(DatasetError::io("cannot read the folder", folder, e)),
    };
    entries
        .map(|entry| Ok(entry.map_err(|e| DatasetError::io("cannot read the folder", folder, e))?.file_name()))
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

/// How many files of a stream's measurements are there.
pub(crate) fn count_files(stream: &Stream<'_>) -> Result<u64, DatasetError> {
    let mut count = 0;
    for (folder, extension) in stream.frame_folders() {
        let names = names(&folder)?;
        if !names.is_empty() {
            count += stream.frames().filter(|frame| names.contains(&*file_name(*frame, &extension))).count() as u64;
        }
    }
    Ok(count)
}

/// Whether every file of a stream is there.
pub(crate) fn stream_is_complete(stream: &Stream<'_>, is_there: impl Fn(&Path) -> bool) -> bool {
    let Stream { files, sensor, .. } = stream;
    let mut others = Vec::new();
    if let StreamModel::Camera(camera) = &stream.model {
        others.extend(camera.output.mp4.iter().map(|layer| files.mp4(*layer)));
        others.extend([files.camera(), files.objects()]);
    }
    if sensor.is_some() {
        others.extend([files.sensor(), files.poses()]);
    }
    others.extend(stream.lines.clone());
    let of_frames = |(folder, extension): &(PathBuf, String)| {
        stream.frames().all(|frame| is_there(&folder.join(file_name(frame, extension))))
    };
    others.iter().all(|path| is_there(path)) && stream.frame_folders().iter().all(of_frames)
}
