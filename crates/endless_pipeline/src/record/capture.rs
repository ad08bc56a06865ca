//! One frame of all streams as the simulator gives it: its ground truth, where the sensors are, and what all measured.

use super::{
    recording::Recording,
    streams::{CameraStream, Stream, StreamLens, StreamModel},
    times::Stage,
};
use crate::{RenderTask, SceneTruth, SensorReading, SimulationStep, SimulatorError};
use endless_annotate::SceneFrame;
use endless_dataset::PoseLine;
use endless_world::{PinholeCamera, WorldState};
use std::{borrow::Cow, time::Instant};

/// One frame on its way to wherever it goes.
pub(crate) struct CapturedFrame<'a, Readings> {
    pub(crate) frame: u32,
    pub(crate) truth: SceneTruth<'a>,
    /// The line of `frames.jsonl`, if the simulator knows it.
    pub(crate) scene: Option<SceneFrame>,
    /// One a sensor of the rig.
    pub(crate) poses: Vec<SensorPlace>,
    /// What all streams measured.
    pub(crate) readings: Readings,
}

/// Where a sensor is, and the camera that it is then.
pub(crate) struct SensorPlace {
    pub(crate) line: PoseLine,
    camera: Option<PinholeCamera>,
}

/// What a stream measured.
pub(crate) enum StreamReading {
    /// The simulator made it.
    Made(SensorReading),
    /// It follows from the pose, or from world states.
    Told,
}

impl StreamReading {
    /// How many points or detections it has.
    pub(crate) fn points(&self) -> usize {
        match self {
            Self::Made(SensorReading::Lidar(sweep)) => sweep.points.len(),
            Self::Made(SensorReading::Radar(scan)) => scan.detections.len(),
            Self::Made(SensorReading::Camera(_)) | Self::Told => 0,
        }
    }
}

/// What streams measured, one each; none of those that do not measure at this frame.
pub(crate) type StreamReadings = Vec<Option<StreamReading>>;

/// Takes from a step what needs the simulator; `read` gives what all streams measured.
pub(crate) fn capture<'m, Readings>(
    recording: &Recording<'_>,
    step: SimulationStep<'m>,
    read: impl FnOnce(&WorldState, Box<dyn RenderTask<'m> + 'm>) -> Result<Readings, crate::GenerateError>,
) -> Result<CapturedFrame<'m, Readings>, crate::GenerateError> {
    let SimulationStep { state, task } = step;
    let (truth, scene) = recording.clock.time(Stage::Boxes, || (task.truth(&state), task.scene_frame(&state)));
    let poses = poses(recording, &state, &*task)?;
    let readings = read(&state, task)?;
    Ok(CapturedFrame { frame: state.frame, truth, scene, poses, readings })
}

/// Where the sensors of the rig are.
fn poses(
    recording: &Recording<'_>,
    state: &WorldState,
    task: &dyn RenderTask<'_>,
) -> Result<Vec<SensorPlace>, SimulatorError> {
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
    recording.streams.iter().filter_map(place).collect()
}

/// The number of a camera among those that stand still, and its lens at this frame; `None` if nobody knows where it is.
pub(crate) fn lens_at<'a>(
    camera: &'a CameraStream<'_>,
    at: Option<&'a SensorPlace>,
) -> Option<(Option<usize>, Cow<'a, PinholeCamera>)> {
    match &camera.lens {
        StreamLens::Fixed { number, camera } => Some((Some(*number), Cow::Borrowed(camera))),
        StreamLens::Moving(_) => Some((None, Cow::Borrowed(at?.camera.as_ref()?))),
    }
}

/// What every stream measures at this frame.
pub(crate) fn measure<'m>(
    recording: &Recording<'_>,
    state: &WorldState,
    task: Box<dyn RenderTask<'m> + 'm>,
) -> Result<StreamReadings, SimulatorError> {
    let frame = state.frame;
    let streams = recording.streams;
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
