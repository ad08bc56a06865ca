//! Makes of captured frames what is handed over, and hands it over in order.

use super::{Measurement, StreamedCamera, StreamedFrame, StreamedSensor, StreamedVideo};
use crate::{
    GenerateError, ProgressEvent, SensorReading, SimulationStep, SimulatorError,
    record::{
        CameraStream, CapturedFrame, FrameOutput, GnssTrack, ImuTrack, Noticed, Observed, Recording, SensorPlace,
        Stage, Stream, StreamModel, StreamReading, StreamReadings, as_stored, capture, labels, lens_at, measure,
    },
};
use endless_annotate::{CameraView, SceneFrame};
use endless_dataset::{DatasetError, PoseLine, metres_from_rgb, rgb_from_metres};
use endless_road::Georeference;
use endless_sensor::EventCamera;
use endless_world::{Image, SensorFrame};
use std::{
    ops::ControlFlow,
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
};

/// Hands frames over to whoever takes them.
pub(super) struct Handover<'a> {
    recording: &'a Recording<'a>,
    video: Arc<StreamedVideo>,
    /// The first frame that is handed over.
    first: u32,
    /// Its index.
    index: u64,
    /// Frames before the first must be measured, too: what one measures depends on what it measured before.
    remembers: bool,
    receiver: Mutex<Receiver<'a>>,
    stopped: AtomicBool,
}

/// What sees the frames in their order.
struct Receiver<'a> {
    /// One a stream.
    tracks: Vec<Track>,
    take: &'a mut (dyn FnMut(StreamedFrame) -> ControlFlow<()> + Send),
}

/// What a sensor remembers from frame to frame.
enum Track {
    Imu(Box<ImuTrack>),
    Gnss(GnssTrack),
    Events(Box<EventCamera>),
    Nothing,
}

/// A frame that waits for its turn.
pub(super) struct WaitingFrame {
    frame: u32,
    scene: Option<SceneFrame>,
    /// One a stream; none of those that did not measure.
    measured: Vec<Option<WaitingMeasurement>>,
}

struct WaitingMeasurement {
    /// Of sensors of a rig.
    pose: Option<PoseLine>,
    what: Waiting,
}

enum Waiting {
    Camera(StreamedCamera),
    /// What an event camera looks at.
    Picture(Image<[u8; 3]>),
    Reading(Measurement),
    /// It follows from its pose.
    Told,
    Noticed(Noticed),
}

impl<'a> Handover<'a> {
    pub(super) fn new(
        recording: &'a Recording<'a>,
        video: Arc<StreamedVideo>,
        georeference: Georeference,
        first: u32,
        index: u64,
        take: &'a mut (dyn FnMut(StreamedFrame) -> ControlFlow<()> + Send),
    ) -> Self {
        let track = |stream: &Stream<'_>| match &stream.model {
            StreamModel::Imu(settings) => {
                let period_s = f64::from(stream.every) / recording.settings.fps;
                Track::Imu(Box::new(ImuTrack::new(settings, period_s, stream.seed)))
            }
            StreamModel::Gnss(settings) => Track::Gnss(GnssTrack::new(settings, georeference, stream.seed)),
            StreamModel::Events { settings, size } => {
                Track::Events(Box::new(EventCamera::new(settings, *size, stream.seed)))
            }
            _ => Track::Nothing,
        };
        let tracks: Vec<Track> = recording.streams.iter().map(track).collect();
        let remembers = tracks.iter().any(|track| matches!(track, Track::Events(_)));
        let receiver = Mutex::new(Receiver { tracks, take });
        Self { recording, video, first, index, remembers, receiver, stopped: AtomicBool::new(false) }
    }

    /// Whether whoever takes the frames wanted no more.
    pub(super) fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }

    /// What a stream measured; `None` if it did not at this frame.
    fn waiting(
        &self,
        stream: &Stream<'_>,
        captured: &CapturedFrame<'_, ()>,
        reading: Option<StreamReading>,
    ) -> Result<Option<WaitingMeasurement>, GenerateError> {
        let at = stream.sensor.map(|(number, _)| &captured.poses[number]);
        let what = match (&stream.model, reading) {
            (StreamModel::Camera(camera), Some(StreamReading::Made(SensorReading::Camera(frame)))) => {
                let Some(seen) = self.camera(stream, camera, captured, at, &frame)? else { return Ok(None) };
                Waiting::Camera(seen)
            }
            (_, Some(StreamReading::Made(SensorReading::Camera(frame)))) => Waiting::Picture(frame.rgb),
            (_, Some(StreamReading::Made(SensorReading::Lidar(sweep)))) => Waiting::Reading(Measurement::Lidar(sweep)),
            (_, Some(StreamReading::Made(SensorReading::Radar(scan)))) => Waiting::Reading(Measurement::Radar(scan)),
            (_, Some(StreamReading::Told)) => Waiting::Told,
            (_, None) => return Ok(None),
        };
        Ok(Some(WaitingMeasurement { pose: at.map(|at| at.line.clone()), what }))
    }

    /// Layers and labels of a camera.
    fn camera(
        &self,
        stream: &Stream<'_>,
        camera: &CameraStream<'_>,
        captured: &CapturedFrame<'_, ()>,
        at: Option<&SensorPlace>,
        frame: &SensorFrame,
    ) -> Result<Option<StreamedCamera>, GenerateError> {
        let Some((number, lens)) = lens_at(camera, at) else { return Ok(None) };
        let clock = self.recording.clock;
        // As it would be stored.
        let depth = |pixel: usize| metres_from_rgb(rgb_from_metres(frame.depth.data[pixel]));
        let view = CameraView { number, camera: &lens, instance: &frame.instance, depth: &depth };
        let objects = labels(self.recording, captured.frame, &captured.truth, &view, &camera.output)?;
        let layers = clock.time(Stage::Images, || as_stored(&camera.output, frame));
        let layers = layers.map_err(|reason| DatasetError::malformed(stream.files.folder(), reason))?;
        Ok(Some(StreamedCamera { name: stream.name(), layers, objects }))
    }
}

impl<'m> FrameOutput<'m> for Handover<'_> {
    type Captured = (CapturedFrame<'m, ()>, Option<StreamReadings>);
    type Item = WaitingFrame;

    /// One for all: frames are handed over whole.
    fn queues(&self) -> usize {
        1
    }

    fn capture(&self, step: SimulationStep<'m>) -> Result<Self::Captured, GenerateError> {
        let wanted = self.remembers || step.state.frame >= self.first;
        let mut readings = None;
        let captured = capture(self.recording, step, |state, task| {
            if wanted {
                let measured = self.recording.clock.time(Stage::Render, || measure(self.recording, state, task));
                readings = Some(measured?);
            }
            Ok(())
        })?;
        Ok((captured, readings))
    }

    fn finish(&self, taken: Self::Captured, observed: Observed) -> Result<Vec<WaitingFrame>, GenerateError> {
        let (captured, readings) = taken;
        let streams = self.recording.streams;
        let Observed { happenings, noticed } = observed;
        let mut measured = match readings {
            Some(readings) => {
                let of_stream = streams.iter().zip(readings);
                of_stream.map(|(stream, reading)| self.waiting(stream, &captured, reading)).collect::<Result<_, _>>()?
            }
            // Poses alone: who measures them goes on.
            None => streams.iter().map(|stream| passed(stream, &captured)).collect::<Vec<_>>(),
        };
        for (stream, noticed) in noticed {
            if let Some(measurement) = &mut measured[stream] {
                measurement.what = Waiting::Noticed(noticed);
            }
        }
        let scene = captured.scene.map(|scene| SceneFrame { happenings, ..scene });
        Ok(vec![WaitingFrame { frame: captured.frame, scene, measured }])
    }

    fn push(&self, _queue: usize, item: WaitingFrame) -> Result<(), GenerateError> {
        let WaitingFrame { frame, scene, measured } = item;
        let mut receiver = self.receiver.lock().unwrap_or_else(PoisonError::into_inner);
        let (mut cameras, mut sensors) = (Vec::new(), Vec::new());
        for (place, measured) in measured.into_iter().enumerate() {
            let stream = &self.recording.streams[place];
            let Some(WaitingMeasurement { pose, what }) = measured else { continue };
            let Some(measurement) = receiver.tracks[place].measure(stream, frame, pose.as_ref(), what) else {
                continue;
            };
            match (measurement, stream.sensor.zip(pose)) {
                (measurement, Some(((sensor, _), pose))) => {
                    sensors.push(StreamedSensor { sensor, name: stream.name(), pose, measurement });
                }
                (Measurement::Camera(camera), None) => cameras.push(camera),
                (_, None) => {}
            }
        }
        if frame < self.first {
            return Ok(());
        }
        let count = (cameras.len() + sensors.len()) as u32;
        let time_s = f64::from(frame) / self.recording.settings.fps;
        let index = self.index + u64::from(frame - self.first);
        let video = Arc::clone(&self.video);
        let handed_over = (receiver.take)(StreamedFrame { index, video, frame, time_s, scene, cameras, sensors });
        self.recording.progress.event(&ProgressEvent::Frame { cameras: count, resumed: false });
        if handed_over.is_break() {
            self.stopped.store(true, Ordering::Relaxed);
            return Err(SimulatorError::Interrupted.into());
        }
        Ok(())
    }
}

/// What a frame that is not handed over brings: the pose of a sensor that measures it.
fn passed(stream: &Stream<'_>, captured: &CapturedFrame<'_, ()>) -> Option<WaitingMeasurement> {
    let (number, _) = stream.sensor?;
    let told = matches!(stream.model, StreamModel::Imu(_) | StreamModel::Gnss(_)) && stream.measures_at(captured.frame);
    told.then(|| WaitingMeasurement { pose: Some(captured.poses[number].line.clone()), what: Waiting::Told })
}

impl Track {
    /// What is measured with what was remembered.
    fn measure(
        &mut self,
        stream: &Stream<'_>,
        frame: u32,
        pose: Option<&PoseLine>,
        what: Waiting,
    ) -> Option<Measurement> {
        Some(match (what, self, pose) {
            (Waiting::Camera(camera), ..) => Measurement::Camera(camera),
            (Waiting::Reading(measurement), ..) => measurement,
            (Waiting::Noticed(Noticed::Collisions(events)), ..) => Measurement::Collisions(events),
            (Waiting::Noticed(Noticed::LaneInvasion(event)), ..) => Measurement::LaneInvasion(event),
            (Waiting::Picture(picture), Self::Events(camera), Some(pose)) => {
                Measurement::Events(camera.observe((pose.time_s * 1e6).round() as i64, &picture))
            }
            (Waiting::Told, Self::Imu(imu), Some(pose)) => {
                let mut records = imu.push(pose);
                if stream.frames().next_back() == Some(frame) {
                    records.extend(imu.last());
                }
                Measurement::Imu(records)
            }
            (Waiting::Told, Self::Gnss(gnss), Some(pose)) => Measurement::Gnss(gnss.push(pose)),
            _ => return None,
        })
    }
}
