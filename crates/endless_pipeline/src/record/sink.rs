//! The ordered outputs of one camera: its videos and its list of objects.

use super::{
    recording::Recording,
    times::{Stage, StageClock},
};
use endless_annotate::{FrameObjects, SceneFrame};
use endless_dataset::{DatasetError, LinesWriter, ObjectsWriter, VideoEncoder, Yuv};
use std::path::PathBuf;

/// What one frame of one camera brings.
pub(super) struct SinkItem {
    /// Its line of `objects.jsonl`.
    pub(super) line: FrameObjects,
    /// One picture a video, in the recipe's order.
    pub(super) pictures: Vec<Yuv>,
    /// The line of `frames.jsonl`: the first camera's sink writes it.
    pub(super) scene: Option<SceneFrame>,
}

/// The open files of one camera.
pub(super) struct CameraSink {
    objects: ObjectsWriter,
    videos: Vec<VideoEncoder>,
    /// `frames.jsonl`: its path, and the file once there is a line for it.
    frames: (PathBuf, Option<LinesWriter<SceneFrame>>),
    boxes: u64,
}

impl CameraSink {
    pub(super) fn create(recording: &Recording<'_>, camera: usize) -> Result<Self, DatasetError> {
        let Recording { settings, recipe, layout, .. } = *recording;
        let files = layout.camera(camera);
        let videos = recipe
            .mp4
            .iter()
            .map(|layer| VideoEncoder::create(&files.mp4(*layer), settings.size, settings.fps))
            .collect::<Result<_, _>>()?;
        let frames = (layout.frames(), None);
        Ok(Self { objects: ObjectsWriter::create(&files.objects())?, videos, frames, boxes: 0 })
    }

    pub(super) fn push(&mut self, frame: &SinkItem, clock: &StageClock) -> Result<(), DatasetError> {
        self.boxes += frame.line.objects.len() as u64;
        clock.time(Stage::Lines, || {
            self.objects.write(&frame.line)?;
            frame.scene.as_ref().map_or(Ok(()), |scene| self.write_scene(scene))
        })?;
        clock.time(Stage::Video, || {
            self.videos.iter_mut().zip(&frame.pictures).try_for_each(|(video, picture)| video.push(picture))
        })
    }

    fn write_scene(&mut self, line: &SceneFrame) -> Result<(), DatasetError> {
        let (path, file) = &mut self.frames;
        if file.is_none() {
            *file = Some(LinesWriter::create(path)?);
        }
        file.as_mut().map_or(Ok(()), |file| file.write(line))
    }

    /// Completes the files; how many boxes there are.
    pub(super) fn finish(self) -> Result<u64, DatasetError> {
        self.objects.finish()?;
        self.frames.1.map_or(Ok(()), LinesWriter::finish)?;
        for video in self.videos {
            video.finish()?;
        }
        Ok(self.boxes)
    }
}
