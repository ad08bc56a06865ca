//! The ordered outputs of one camera: its videos and its list of objects.

use super::{
    recording::Recording,
    times::{Stage, StageClock},
};
use endless_annotate::FrameObjects;
use endless_dataset::{DatasetError, ObjectsWriter, VideoEncoder, Yuv};

/// What one frame of one camera brings.
pub(super) struct SinkItem {
    /// Its line of `objects.jsonl`.
    pub(super) line: FrameObjects,
    /// One picture a video, in the recipe's order.
    pub(super) pictures: Vec<Yuv>,
}

/// The open files of one camera.
pub(super) struct CameraSink {
    objects: ObjectsWriter,
    videos: Vec<VideoEncoder>,
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
        Ok(Self { objects: ObjectsWriter::create(&files.objects())?, videos, boxes: 0 })
    }

    pub(super) fn push(&mut self, frame: &SinkItem, clock: &StageClock) -> Result<(), DatasetError> {
        self.boxes += frame.line.objects.len() as u64;
        self.objects.write(&frame.line)?;
        clock.time(Stage::Video, || {
            self.videos.iter_mut().zip(&frame.pictures).try_for_each(|(video, picture)| video.push(picture))
        })
    }

    /// Completes the files; how many boxes there are.
    pub(super) fn finish(self) -> Result<u64, DatasetError> {
        self.objects.finish()?;
        for video in self.videos {
            video.finish()?;
        }
        Ok(self.boxes)
    }
}
