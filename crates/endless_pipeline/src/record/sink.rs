//! The ordered outputs of a stream: what must be written frame by frame.

use super::{
    camera_sink::CameraSink,
    event_sink::EventSink,
    line_sinks::{GnssSink, GnssTrack, ImuSink, ImuTrack},
    recording::Recording,
    streams::{Stream, StreamModel},
    times::{Stage, StageClock},
    vehicle_sensors::Noticed,
};
use endless_annotate::{CollisionEvent, FrameObjects, LaneInvasionEvent, SceneFrame};
use endless_dataset::{DatasetError, LinesWriter, PoseLine, Yuv};
use endless_road::Georeference;
use endless_world::Image;
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
    /// What happened to who carries it.
    pub(super) noticed: Option<Noticed>,
}

/// What is written of a measurement in the order of frames.
pub(super) enum Measured {
    /// Of a camera: its line of `objects.jsonl`, and one picture a video, in the order of its output.
    Camera { line: FrameObjects, pictures: Vec<Yuv> },
    /// Of an event camera: its picture.
    Picture(Image<[u8; 3]>),
    /// Of a sensor whose files are written already, or whose measurement is its pose.
    Done,
}

/// The open files of one stream.
pub(super) struct StreamSink {
    model: ModelSink,
    poses: Option<LinesWriter<PoseLine>>,
    /// `frames.jsonl`: its path, and the file once there is a line for it.
    frames: (PathBuf, Option<LinesWriter<SceneFrame>>),
}

enum ModelSink {
    Camera(Box<CameraSink>),
    Events(EventSink),
    Imu(Box<ImuSink>),
    Gnss(GnssSink),
    Collisions(LinesWriter<CollisionEvent>),
    LaneInvasions(LinesWriter<LaneInvasionEvent>),
    Nothing,
}

impl StreamSink {
    pub(super) fn create(
        recording: &Recording<'_>,
        stream: &Stream<'_>,
        georeference: Georeference,
    ) -> Result<Self, DatasetError> {
        let lines = stream.lines.as_deref();
        let model = match (&stream.model, lines) {
            (StreamModel::Camera(camera), _) => ModelSink::Camera(Box::new(CameraSink::create(stream, camera)?)),
            (StreamModel::Events { settings, size }, _) => ModelSink::Events(EventSink::new(stream, settings, *size)),
            (StreamModel::Imu(settings), Some(path)) => {
                let period_s = f64::from(stream.every) / recording.settings.fps;
                let track = ImuTrack::new(settings, period_s, stream.seed);
                ModelSink::Imu(Box::new(ImuSink::create(path, track)?))
            }
            (StreamModel::Gnss(settings), Some(path)) => {
                ModelSink::Gnss(GnssSink::create(path, GnssTrack::new(settings, georeference, stream.seed))?)
            }
            (StreamModel::Collision, Some(path)) => ModelSink::Collisions(LinesWriter::create(path)?),
            (StreamModel::LaneInvasion, Some(path)) => ModelSink::LaneInvasions(LinesWriter::create(path)?),
            _ => ModelSink::Nothing,
        };
        let poses = stream.sensor.map(|_| LinesWriter::create(&stream.files.poses())).transpose()?;
        Ok(Self { model, poses, frames: (recording.layout.frames(), None) })
    }

    pub(super) fn push(&mut self, frame: SinkItem, clock: &StageClock) -> Result<(), DatasetError> {
        let SinkItem { measured, pose, scene, noticed } = frame;
        clock.time(Stage::Lines, || {
            if let (Some(poses), Some(pose)) = (&mut self.poses, &pose) {
                poses.write(pose)?;
            }
            scene.as_ref().map_or(Ok(()), |scene| self.write_scene(scene))
        })?;
        match (&mut self.model, measured, pose) {
            (ModelSink::Camera(camera), Some(Measured::Camera { line, pictures }), _) => {
                camera.push(&line, &pictures, clock)?;
            }
            (ModelSink::Events(events), Some(Measured::Picture(picture)), Some(pose)) => {
                clock.time(Stage::Images, || events.push(&pose, &picture))?;
            }
            (ModelSink::Imu(imu), Some(_), Some(pose)) => clock.time(Stage::Lines, || imu.push(&pose))?,
            (ModelSink::Gnss(gnss), Some(_), Some(pose)) => clock.time(Stage::Lines, || gnss.push(&pose))?,
            _ => {}
        }
        clock.time(Stage::Lines, || match (&mut self.model, noticed) {
            (ModelSink::Collisions(file), Some(Noticed::Collisions(events))) => {
                events.iter().try_for_each(|event| file.write(event))
            }
            (ModelSink::LaneInvasions(file), Some(Noticed::LaneInvasion(Some(event)))) => file.write(&event),
            _ => Ok(()),
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
        self.poses.map_or(Ok(()), LinesWriter::finish)?;
        self.frames.1.map_or(Ok(()), LinesWriter::finish)?;
        match self.model {
            ModelSink::Camera(camera) => return camera.finish(),
            ModelSink::Imu(imu) => imu.finish()?,
            ModelSink::Gnss(gnss) => gnss.finish()?,
            ModelSink::Collisions(file) => file.finish()?,
            ModelSink::LaneInvasions(file) => file.finish()?,
            ModelSink::Events(_) | ModelSink::Nothing => {}
        }
        Ok(0)
    }
}
