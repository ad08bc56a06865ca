//! The ordered outputs of a camera: its videos and its list of objects.

use super::{
    streams::{CameraStream, Stream},
    times::{Stage, StageClock},
};
use endless_annotate::FrameObjects;
use endless_dataset::{DatasetError, ObjectsWriter, VideoEncoder, Yuv};

/// The open files of a camera.
pub(super) struct CameraSink {
    objects: ObjectsWriter,
    videos: Vec<VideoEncoder>,
    boxes: u64,
}

impl CameraSink {
    pub(super) fn create(
        stream: &Stream<'_>,
        CameraStream { output, .. }: &CameraStream<'_>,
    ) -> Result<Self, DatasetError> {
        let files = &stream.files;
        let video = |layer| VideoEncoder::create(&files.mp4(layer), output.size, output.fps());
        let videos = output.mp4.iter().map(|layer| video(*layer)).collect::<Result<_, _>>()?;
        Ok(Self { objects: ObjectsWriter::create(&files.objects())?, videos, boxes: 0 })
    }

    pub(super) fn push(
        &mut self,
        line: &FrameObjects,
        pictures: &[Yuv],
        clock: &StageClock,
    ) -> Result<(), DatasetError> {
        self.boxes += line.objects.len() as u64;
        clock.time(Stage::Lines, || self.objects.write(line))?;
        clock.time(Stage::Video, || {
            self.videos.iter_mut().zip(pictures).try_for_each(|(video, picture)| video.push(picture))
        })
    }

    /// Completes the files; how many boxes there are.
    pub(super) fn finish(self) -> Result<u64, DatasetError> {
        self.objects.finish()?;
        self.videos.into_iter().try_for_each(VideoEncoder::finish)?;
        Ok(self.boxes)
    }
}
