//! Frames that go to files: measured and written, or read back where they are stored already, and then labelled.

use super::{
    capture::{CapturedFrame, SensorPlace, StreamReading, StreamReadings, capture, lens_at, measure},
    files,
    labels::labels,
    layers::{self, StoredImages, StoredLayers},
    recording::Recording,
    sink::{Measured, SinkItem, StreamSink},
    stored::StoredFrames,
    streams::{CameraStream, Stream, StreamModel},
    times::Stage,
    workers::{FrameOutput, Observed},
};
use crate::{GenerateError, ProgressEvent, SensorReading, SimulationStep};
use endless_annotate::{CameraView, SceneFrame};
use endless_dataset::{
    CameraOutput, DatasetError, LastPng, Layer, StoredImage, Yuv, metres_from_rgb, rgb_from_metres, yuv_from_rgb,
};
use std::sync::{Mutex, PoisonError};

/// Writes the frames of a video.
pub(super) struct FrameRecorder<'a> {
    recording: &'a Recording<'a>,
    stored: &'a StoredFrames,
    sinks: &'a [Mutex<StreamSink>],
    /// By stream and layer: what was written last.
    written: Vec<Vec<LastPng>>,
}

/// One a stream; none of those that do not measure at this frame.
pub(super) enum FrameReadings {
    Made(StreamReadings),
    Stored(Vec<Option<StoredReading>>),
}

/// What is stored of a stream's measurement.
pub(super) enum StoredReading {
    Layers(StoredLayers),
    /// Nothing is made of it.
    Other,
}

type Captured<'a> = CapturedFrame<'a, FrameReadings>;

impl FrameReadings {
    /// How many streams measured.
    fn measurements(&self) -> u32 {
        let count = match self {
            Self::Made(made) => made.iter().flatten().count(),
            Self::Stored(stored) => stored.iter().flatten().count(),
        };
        count as u32
    }

    /// How many points or detections a stream's measurement has.
    fn points(&self, stream: usize) -> usize {
        match self {
            Self::Made(made) => made[stream].as_ref().map_or(0, StreamReading::points),
            Self::Stored(_) => 0,
        }
    }
}

impl<'a> FrameRecorder<'a> {
    pub(super) fn new(recording: &'a Recording<'a>, stored: &'a StoredFrames, sinks: &'a [Mutex<StreamSink>]) -> Self {
        let layers = |stream: &Stream<'_>| match &stream.model {
            StreamModel::Camera(camera) => camera.output.layers.iter().map(|_| LastPng::default()).collect(),
            _ => Vec::new(),
        };
        let written = recording.streams.iter().map(layers).collect();
        Self { recording, stored, sinks, written }
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
    fn items(&self, taken: &Captured<'_>) -> Result<Vec<SinkItem>, GenerateError> {
        let streams = self.recording.streams.iter().enumerate();
        let item = |(place, stream): (usize, &Stream<'_>)| {
            let at = stream.sensor.map(|(number, _)| &taken.poses[number]);
            let measured = match &stream.model {
                StreamModel::Camera(camera) => self.measured(taken, place, camera, at)?,
                _ => self.written(taken, place)?,
            };
            let pose = at.filter(|_| measured.is_some()).map(|at| at.line.clone());
            if measured.is_some() {
                stream.clock.measured(taken.readings.points(place));
            }
            Ok(SinkItem { measured, pose, ..SinkItem::default() })
        };
        streams.map(|(place, stream)| stream.clock.time(|| item((place, stream)))).collect()
    }

    /// Writes what another sensor measured; what its sink gets of this frame.
    fn written(&self, taken: &Captured<'_>, place: usize) -> Result<Option<Measured>, GenerateError> {
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
        taken: &Captured<'_>,
        place: usize,
        camera: &CameraStream<'_>,
        at: Option<&SensorPlace>,
    ) -> Result<Option<Measured>, GenerateError> {
        let Recording { streams, clock, .. } = *self.recording;
        let output = &camera.output;
        let Some((number, lens)) = lens_at(camera, at) else { return Ok(None) };
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
        taken: &Captured<'_>,
        view: &CameraView<'_>,
        output: &CameraOutput,
        images: &StoredImages<'_>,
    ) -> Result<Measured, GenerateError> {
        let line = labels(self.recording, taken.frame, &taken.truth, view, output)?;
        let pictures = self.recording.clock.time(Stage::Video, || {
            let picture = |(layer, image): &(Layer, StoredImage<'_>)| {
                let preview = (layer.entry().preview)(image);
                preview.map(|p| yuv_from_rgb(&p)).map_err(|reason| DatasetError::Video { reason })
            };
            images.iter().map(picture).collect::<Result<Vec<Yuv>, _>>()
        })?;
        Ok(Measured::Camera { line, pictures })
    }
}

impl<'m> FrameOutput<'m> for FrameRecorder<'_> {
    type Captured = Captured<'m>;
    type Item = SinkItem;

    /// One a stream.
    fn queues(&self) -> usize {
        self.sinks.len()
    }

    fn capture(&self, step: SimulationStep<'m>) -> Result<Captured<'m>, GenerateError> {
        capture(self.recording, step, |state, task| {
            Ok(match self.read(state.frame)? {
                Some(stored) => FrameReadings::Stored(stored),
                None => FrameReadings::Made(
                    self.recording.clock.time(Stage::Render, || measure(self.recording, state, task))?,
                ),
            })
        })
    }

    fn finish(&self, taken: Captured<'m>, observed: Observed) -> Result<Vec<SinkItem>, GenerateError> {
        let mut items = self.items(&taken)?;
        let Observed { happenings, noticed } = observed;
        let (resumed, cameras) = (matches!(taken.readings, FrameReadings::Stored(_)), taken.readings.measurements());
        if let Some(first) = items.first_mut() {
            first.scene = taken.scene.map(|scene| SceneFrame { happenings, ..scene });
        }
        for (stream, noticed) in noticed {
            items[stream].noticed = Some(noticed);
        }
        self.recording.progress.event(&ProgressEvent::Frame { cameras, resumed });
        Ok(items)
    }

    fn push(&self, stream: usize, item: SinkItem) -> Result<(), GenerateError> {
        let Recording { streams, clock, .. } = *self.recording;
        let mut sink = self.sinks[stream].lock().unwrap_or_else(PoisonError::into_inner);
        Ok(streams[stream].clock.time(|| sink.push(item, clock))?)
    }
}
