//! One video of a stream.

use super::{StreamEnd, StreamedFrame, StreamedVideo, handover::Handover};
use crate::{
    GenerateError, Progress, ProgressEvent, Simulator,
    measurements::measurements_from,
    record::{
        Observers, OpenedSession, Recording, StageClock, Stream, StreamModel, camera_record, open_session,
        prepare_session, run_workers,
    },
};
use endless_dataset::{CameraRecord, DatasetLayout, Recipe, SensorRecord, VideoLayout};
use endless_world::SceneSettings;
use std::{ops::ControlFlow, sync::Arc};

/// A video and what it is made with.
pub(super) struct VideoStream<'a> {
    pub(super) pool: &'a rayon::ThreadPool,
    pub(super) recipe: &'a Recipe,
    pub(super) settings: &'a SceneSettings,
    pub(super) progress: &'a dyn Progress,
    pub(super) clock: &'a StageClock,
    /// Among the videos of the stream, from 1.
    pub(super) place: u32,
    /// How many there are.
    pub(super) of: u32,
}

/// Hands over the frames of a video from frame `first` on, whose index is `index`.
pub(super) fn stream_video<S: Simulator>(
    simulator: &S,
    map: &S::Map,
    video: &VideoStream<'_>,
    first: u32,
    index: u64,
    take: &mut (dyn FnMut(StreamedFrame) -> ControlFlow<()> + Send),
) -> Result<StreamEnd, GenerateError> {
    let VideoStream { settings, recipe, pool, progress, clock, place, of } = *video;
    // Nothing is written there: it names the streams.
    let layout = DatasetLayout::new("").video(settings);
    let streams = Stream::all(recipe, settings, &layout);
    let recording = Recording { settings, recipe, layout: &layout, streams: &streams, pool, progress, clock };
    let name = VideoLayout::name(settings);
    let camera_frames = measurements_from(settings, first);
    progress.event(&ProgressEvent::Video { name: &name, place, of, camera_frames });
    let OpenedSession { mut session, spawned, staged } = open_session(simulator, map, &recording)?;
    prepare_session(&recording, &mut session)?;
    let features = simulator.map_features(map);
    let record = |place: usize, stream: &Stream<'_>| -> Option<CameraRecord> {
        let StreamModel::Camera(camera) = &stream.model else { return None };
        Some(camera_record(camera, settings.cameras.get(place), stream.sensor, features))
    };
    let (of_scene, of_rig) = streams.split_at(settings.cameras.len());
    let sensors = settings.sensors.iter().enumerate();
    let video = StreamedVideo {
        settings: settings.clone(),
        name: name.clone(),
        spawned,
        incidents: staged.incidents,
        actors: session.actors(),
        cameras: of_scene.iter().enumerate().filter_map(|(place, stream)| record(place, stream)).collect(),
        sensors: sensors.map(|(place, of)| SensorRecord::new(of, settings.fps, session.carrier(place))).collect(),
        sensor_cameras: of_rig.iter().map(|stream| record(usize::MAX, stream)).collect(),
    };
    let observers = Observers::new(&recording, simulator, map, &session);
    let georeference = simulator.georeference(map);
    let handover = Handover::new(&recording, Arc::new(video), georeference, first, index, take);
    match run_workers(&recording, session, observers, &handover, simulator.capabilities().random_access) {
        Err(_) if handover.is_stopped() => Ok(StreamEnd::Stopped),
        Err(error) => Err(error),
        Ok(_) => {
            progress.event(&ProgressEvent::VideoDone { name: &name });
            Ok(StreamEnd::Complete)
        }
    }
}
