//! The ordered outputs of a video: what must be written frame by frame.

use super::{
    recording::Recording,
    streams::{CameraStream, Stream, StreamModel},
    times::{Stage, StageClock},
};
use endless_annotate::{FrameObjects, SceneFrame};
use endless_dataset::{DatasetError, LinesWriter, ObjectsWriter, PoseLine, VideoEncoder, Yuv};
use std::path::PathBuf;

/// What one frame of one stream brings.
#[derive(Default)]
pub(super) struct SinkItem {
    /// What it measured, if it did at this frame.
    pub(super) measured: Option<Measured>,
    /// The line of `poses.jsonl`, of sensors of a rig.
    pub(super) pose: Option<PoseLine>,
    /// The line of `frames.jsonl`: the first stream's sink writes it.
    pub(super) scene: Option<SceneFrame>,
}

/// What is written of a measurement in the order of frames.
pub(super) enum Measured {
    /// Of a camera: its line of `objects.jsonl`, and one picture a video, in the order of its output.
    Camera { line: FrameObjects, pictures: Vec<Yuv> },
}

/// The open files of one stream.
pub(super) struct StreamSink {
    model: ModelSink,
    poses: Option<LinesWriter<PoseLine>>,
    /// `frames.jsonl`: its path, and the file once there is a line for it.
    frames: (PathBuf, Option<LinesWriter<SceneFrame>>),
}

enum ModelSink {
    Camera(CameraSink),
}

struct CameraSink {
    objects: ObjectsWriter,
    videos: Vec<VideoEncoder>,
    boxes: u64,
}

impl StreamSink {
    pub(super) fn create(recording: &Recording<'_>, stream: &Stream<'_>) -> Result<Self, DatasetError> {
        let model = match &stream.model {
            StreamModel::Camera(camera) => ModelSink::Camera(CameraSink::create(stream, camera)?),
        };
        let poses = stream.sensor.map(|_| LinesWriter::create(&stream.files.poses())).transpose()?;
        Ok(Self { model, poses, frames: (recording.layout.frames(), None) })
    }

    pub(super) fn push(&mut self, frame: &SinkItem, clock: &StageClock) -> Result<(), DatasetError> {
        clock.time(Stage::Lines, || {
            if let (Some(poses), Some(pose)) = (&mut self.poses, &frame.pose) {
                poses.write(pose)?;
            }
            frame.scene.as_ref().map_or(Ok(()), |scene| self.write_scene(scene))
        })?;
        match (&mut self.model, &frame.measured) {
            (_, None) => Ok(()),
            (ModelSink::Camera(camera), Some(Measured::Camera { line, pictures })) => {
                camera.push(line, pictures, clock)
            }
        }
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
        self.poses.map_or(Ok(()), LinesWriter::finish)?;
        self.frames.1.map_or(Ok(()), LinesWriter::finish)?;
        match self.model {
            ModelSink::Camera(camera) => camera.finish(),
        }
    }
}

impl CameraSink {
    fn create(stream: &Stream<'_>, CameraStream { output, .. }: &CameraStream<'_>) -> Result<Self, DatasetError> {
        let files = &stream.files;
        let video = |layer| VideoEncoder::create(&files.mp4(layer), output.size, output.fps());
        let videos = output.mp4.iter().map(|layer| video(*layer)).collect::<Result<_, _>>()?;
        Ok(Self { objects: ObjectsWriter::create(&files.objects())?, videos, boxes: 0 })
    }

    fn push(&mut self, line: &FrameObjects, pictures: &[Yuv], clock: &StageClock) -> Result<(), DatasetError> {
        self.boxes += line.objects.len() as u64;
        clock.time(Stage::Lines, || self.objects.write(line))?;
        clock.time(Stage::Video, || {
            self.videos.iter_mut().zip(pictures).try_for_each(|(video, picture)| video.push(picture))
        })
    }

    fn finish(self) -> Result<u64, DatasetError> {
        self.objects.finish()?;
        self.videos.into_iter().try_for_each(VideoEncoder::finish)?;
        Ok(self.boxes)
    }
}
