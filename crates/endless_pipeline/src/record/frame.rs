//! One frame of all streams: measured and written, or read back where it is stored already, and then labelled.

use super::{
    files,
    layers::{self, StoredImages, StoredLayers},
    recording::Recording,
    sink::{Measured, SinkItem},
    stored::StoredFrames,
    streams::{CameraStream, Stream, StreamLens, StreamModel},
    times::Stage,
};
use crate::{GenerateError, RenderTask, SceneTruth, SensorReading, SimulationStep, SimulatorError};
use endless_annotate::{AnnotateError, CameraView, FrameObjects, ObjectShapes, SceneFrame, annotate, visible_objects};
use endless_dataset::{
    CameraOutput, DatasetError, LastPng, Layer, PoseLine, StoredImage, Yuv, metres_from_rgb, rgb_from_metres,
    yuv_from_rgb,
};
use endless_world::{PinholeCamera, WorldState};
use std::{borrow::Cow, time::Instant};

pub(super) struct FrameRecorder<'a> {
    pub(super) recording: &'a Recording<'a>,
    stored: &'a StoredFrames,
    /// By stream and layer: what was written last.
    written: Vec<Vec<LastPng>>,
}

/// One frame: its ground truth and what all streams measured.
pub(super) struct CapturedFrame<'a> {
    frame: u32,
    truth: SceneTruth<'a>,
    scene: Option<SceneFrame>,
    /// One a sensor of the rig.
    poses: Vec<SensorPlace>,
    readings: FrameReadings,
}

/// Where a sensor is, and the camera that it is then.
struct SensorPlace {
    line: PoseLine,
    camera: Option<PinholeCamera>,
}

/// One a stream; none of those that do not measure at this frame.
enum FrameReadings {
    Made(Vec<Option<StreamReading>>),
    Stored(Vec<Option<StoredReading>>),
}

/// What a stream measured.
enum StreamReading {
    /// The simulator made it.
    Made(SensorReading),
    /// It follows from the pose, or from world states.
    Told,
}

/// What is stored of a stream's measurement.
enum StoredReading {
    Layers(StoredLayers),
    /// Nothing is made of it.
    Other,
}

impl CapturedFrame<'_> {
    /// Whether it was stored already.
    pub(super) fn is_stored(&self) -> bool {
        matches!(self.readings, FrameReadings::Stored(_))
    }

    /// How many streams measured.
    pub(super) fn measurements(&self) -> u32 {
        let count = match &self.readings {
            FrameReadings::Made(made) => made.iter().flatten().count(),
            FrameReadings::Stored(stored) => stored.iter().flatten().count(),
        };
        count as u32
    }

    /// How many points or detections a stream's measurement has.
    fn points(&self, stream: usize) -> usize {
        match &self.readings {
            FrameReadings::Made(made) => match &made[stream] {
                Some(StreamReading::Made(SensorReading::Lidar(sweep))) => sweep.points.len(),
                Some(StreamReading::Made(SensorReading::Radar(scan))) => scan.detections.len(),
                _ => 0,
            },
            FrameReadings::Stored(_) => 0,
        }
    }

    /// The line of `frames.jsonl`, if the simulator knows it.
    pub(super) fn into_scene_frame(self) -> Option<SceneFrame> {
        self.scene
    }
}

impl<'a> FrameRecorder<'a> {
    pub(super) fn new(recording: &'a Recording<'a>, stored: &'a StoredFrames) -> Self {
        let layers = |stream: &Stream<'_>| match &stream.model {
            StreamModel::Camera(camera) => camera.output.layers.iter().map(|_| LastPng::default()).collect(),
            _ => Vec::new(),
        };
        let written = recording.streams.iter().map(layers).collect();
        Self { recording, stored, written }
    }

    /// What needs the simulator.
    pub(super) fn take<'m>(&self, step: SimulationStep<'m>) -> Result<CapturedFrame<'m>, GenerateError> {
        let SimulationStep { state, task } = step;
        let clock = self.recording.clock;
        let (truth, scene) = clock.time(Stage::Boxes, || (task.truth(&state), task.scene_frame(&state)));
        let frame = state.frame;
        let poses = self.poses(&state, &*task)?;
        let readings = match self.read(frame)? {
            Some(layers) => FrameReadings::Stored(layers),
            None => FrameReadings::Made(clock.time(Stage::Render, || self.measure(&state, task))?),
        };
        Ok(CapturedFrame { frame, truth, scene, poses, readings })
    }

    /// Where the sensors of the rig are.
    fn poses(&self, state: &WorldState, task: &dyn RenderTask<'_>) -> Result<Vec<SensorPlace>, SimulatorError> {
        let place = |stream: &Stream<'_>| {
            let (number, sensor) = stream.sensor?;
            Some(task.sensor_pose(state, number).map(|pose| {
                let line = PoseLine::new(state.frame, state.time_s, &pose);
                let camera = match &stream.model {
                    StreamModel::Camera(CameraStream { lens: StreamLens::Fixed { camera, .. }, .. }) => {
                        Some(camera.clone())
                    }
                    StreamModel::Camera(CameraStream { lens: StreamLens::Moving(camera), .. }) => {
                        Some(camera.at(&sensor.mount, &pose, state.time_s))
                    }
                    _ => None,
                };
                let line = camera.as_ref().map_or(line.clone(), |camera| line.with_camera(camera));
                SensorPlace { line, camera }
            }))
        };
        self.recording.streams.iter().filter_map(place).collect()
    }

    /// What every stream measures at this frame.
    fn measure<'m>(
        &self,
        state: &WorldState,
        task: Box<dyn RenderTask<'m> + 'm>,
    ) -> Result<Vec<Option<StreamReading>>, SimulatorError> {
        let frame = state.frame;
        let streams = self.recording.streams;
        let of_rig = |stream: &Stream<'_>| {
            let (number, _) = stream.sensor?;
            let sense = || match &stream.model {
                StreamModel::Camera(_) | StreamModel::Events { .. } | StreamModel::Readings => {
                    task.sense(state, number).map(StreamReading::Made)
                }
                _ => Ok(StreamReading::Told),
            };
            stream.measures_at(frame).then(|| stream.clock.time(sense))
        };
        let mut sensed = Vec::new();
        for stream in streams {
            sensed.push(of_rig(stream).transpose()?);
        }
        let cameras = streams.iter().filter(|stream| stream.sensor.is_none()).count();
        let start = Instant::now();
        let frames = if cameras == 0 { Vec::new() } else { task.render(state)? };
        for stream in streams.iter().filter(|stream| stream.sensor.is_none()) {
            stream.clock.add(start.elapsed() / cameras as u32);
        }
        if frames.len() != cameras {
            return Err(SimulatorError::CamerasMissing { frame, expected: cameras, got: frames.len() });
        }
        for (reading, image) in sensed.iter_mut().zip(frames) {
            *reading = Some(StreamReading::Made(SensorReading::Camera(Box::new(image))));
        }
        let other = sensed.iter().flatten().find_map(|reading| match reading {
            StreamReading::Made(SensorReading::Camera(image)) if image.frame != frame => Some(image.frame),
            _ => None,
        });
        other.map_or(Ok(sensed), |got| Err(SimulatorError::FramesDropped { expected: frame, got }))
    }

    /// The frame if it is stored; a damaged one is made again.
    fn read(&self, frame: u32) -> Result<Option<Vec<Option<StoredReading>>>, DatasetError> {
        if !self.stored.has(frame) {
            return Ok(None);
        }
        let Recording { streams, clock, .. } = *self.recording;
        let read_stream = |stream: &Stream<'_>| {
            let read = || match &stream.model {
                StreamModel::Camera(CameraStream { output, .. }) => {
                    StoredLayers::read(&stream.files, output, frame).map(StoredReading::Layers)
                }
                _ => files::read(stream, frame).map(|()| StoredReading::Other),
            };
            stream.measures_at(frame).then(read).transpose()
        };
        let read = clock.time(Stage::Resume, || streams.iter().map(read_stream).collect());
        match read {
            Ok(layers) => Ok(Some(layers)),
            Err(DatasetError::Malformed { .. }) => Ok(None),
            Err(other) => Err(other),
        }
    }

    /// Images on disk, and what each stream's sink gets.
    pub(super) fn finish(&self, taken: &CapturedFrame<'_>) -> Result<Vec<SinkItem>, GenerateError> {
        let streams = self.recording.streams.iter().enumerate();
        let item = |(place, stream): (usize, &Stream<'_>)| {
            let at = stream.sensor.map(|(number, _)| &taken.poses[number]);
            let measured = match &stream.model {
                StreamModel::Camera(camera) => self.measured(taken, place, camera, at)?,
                _ => self.written(taken, place)?,
            };
            let pose = at.filter(|_| measured.is_some()).map(|at| at.line.clone());
            if measured.is_some() {
                stream.clock.measured(taken.points(place));
            }
            Ok(SinkItem { measured, pose, ..SinkItem::default() })
        };
        streams.map(|(place, stream)| stream.clock.time(|| item((place, stream)))).collect()
    }

    /// Writes what another sensor measured; what its sink gets of this frame.
    fn written(&self, taken: &CapturedFrame<'_>, place: usize) -> Result<Option<Measured>, GenerateError> {
        let Recording { streams, clock, .. } = *self.recording;
        let FrameReadings::Made(made) = &taken.readings else {
            return Ok(streams[place].measures_at(taken.frame).then_some(Measured::Done));
        };
        Ok(match &made[place] {
            None => None,
            Some(StreamReading::Told) => Some(Measured::Done),
            Some(StreamReading::Made(SensorReading::Camera(frame))) => Some(Measured::Picture(frame.rgb.clone())),
            Some(StreamReading::Made(reading)) => {
                clock.time(Stage::Images, || files::write(&streams[place], taken.frame, reading))?;
                Some(Measured::Done)
            }
        })
    }

    /// What a camera's sink gets of this frame.
    fn measured(
        &self,
        taken: &CapturedFrame<'_>,
        place: usize,
        camera: &CameraStream<'_>,
        at: Option<&SensorPlace>,
    ) -> Result<Option<Measured>, GenerateError> {
        let Recording { streams, clock, .. } = *self.recording;
        let output = &camera.output;
        let (number, lens) = match &camera.lens {
            StreamLens::Fixed { number, camera } => (Some(*number), Cow::Borrowed(camera)),
            StreamLens::Moving(_) => match at.and_then(|at| at.camera.as_ref()) {
                Some(camera) => (None, Cow::Borrowed(camera)),
                None => return Ok(None),
            },
        };
        match &taken.readings {
            FrameReadings::Stored(stored) => {
                let Some(StoredReading::Layers(stored)) = &stored[place] else { return Ok(None) };
                let depth = |pixel: usize| metres_from_rgb(stored.depth.data[pixel]);
                let view = CameraView { number, camera: &lens, instance: &stored.instance, depth: &depth };
                self.labelled(taken, &view, output, &stored.images).map(Some)
            }
            FrameReadings::Made(made) => {
                let Some(StreamReading::Made(SensorReading::Camera(frame))) = &made[place] else { return Ok(None) };
                let write = || layers::write(&streams[place].files, output, frame, &self.written[place], clock);
                let images = clock.time(Stage::Images, write)?;
                // As it is or would be stored: labels do not depend on which layers are.
                let depth = |pixel: usize| metres_from_rgb(rgb_from_metres(frame.depth.data[pixel]));
                let view = CameraView { number, camera: &lens, instance: &frame.instance, depth: &depth };
                self.labelled(taken, &view, output, &images).map(Some)
            }
        }
    }

    /// Labels, and pictures of videos.
    fn labelled(
        &self,
        taken: &CapturedFrame<'_>,
        view: &CameraView<'_>,
        output: &CameraOutput,
        images: &StoredImages<'_>,
    ) -> Result<Measured, GenerateError> {
        let line = self.labels(taken, view, output)?;
        let clock = self.recording.clock;
        let pictures = clock.time(Stage::Video, || {
            let picture = |(layer, image): &(Layer, StoredImage<'_>)| {
                let preview = (layer.entry().preview)(image);
                preview.map(|p| yuv_from_rgb(&p)).map_err(|reason| DatasetError::Video { reason })
            };
            images.iter().map(picture).collect::<Result<Vec<Yuv>, _>>()
        })?;
        Ok(Measured::Camera { line, pictures })
    }

    /// All that is told of the objects that a camera sees.
    fn labels(
        &self,
        taken: &CapturedFrame<'_>,
        view: &CameraView<'_>,
        output: &CameraOutput,
    ) -> Result<FrameObjects, AnnotateError> {
        let Recording { settings, recipe, clock, .. } = *self.recording;
        let CapturedFrame { frame, truth, .. } = taken;
        let shapes = truth.shapes.as_deref().map(|shapes| shapes as &dyn ObjectShapes);
        let line = clock.time(Stage::Boxes, || {
            let visible = visible_objects(view.instance);
            let time_s = f64::from(*frame) / settings.fps;
            let line = annotate(*frame, time_s, &visible, &truth.objects, output.size, output.min_pixels)?;
            Ok::<_, AnnotateError>(line.with_keypoints(&truth.bodies, view))
        })?;
        let line = match shapes {
            Some(shapes) => {
                let line = clock.time(Stage::Amodal, || line.with_amodal(shapes, view, recipe.amodal_masks));
                clock.time(Stage::Boxes, || line.with_boxes3d(shapes, view))
            }
            None => line,
        };
        Ok(clock.time(Stage::Boxes, || line.with_riders(shapes, view)))
    }
}
