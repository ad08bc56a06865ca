//! One video from its first frame to its last.

use super::{
    frame::FrameRecorder,
    recording::Recording,
    sink::StreamSink,
    stored::{StoredFrames, remove_stored},
    streams::{CameraStream, Stream, StreamLens, StreamModel},
    times::Stage,
    workers::{BoxedSession, Observers, run_workers},
};
use crate::{GenerateError, ProgressEvent, Simulator};
use endless_annotate::{CameraMap, MapFeatures};
use endless_dataset::{
    CameraRecord, DatasetError, Layer, SceneRecord, SensorRecord, SpawnCounts, remove_temporaries, write_actors,
    write_json, write_json_durable, write_json_line,
};
use endless_world::{SceneCamera, SceneSensor, SensorLayers, StagedIncidents};
use std::{
    fs,
    sync::{Mutex, PoisonError},
    time::Instant,
};

/// Records a video, or completes it.
pub(crate) fn record_video<S: Simulator>(
    simulator: &S,
    map: &S::Map,
    recording: &Recording<'_>,
) -> Result<SceneRecord, GenerateError> {
    let Recording { settings, layout, streams, clock, .. } = *recording;
    let capabilities = simulator.capabilities();
    if !capabilities.repeatable {
        remove_stored(recording)?;
    }
    prepare_folders(recording, simulator.map_features(map))?;
    let OpenedSession { mut session, spawned, staged } = open_session(simulator, map, recording)?;
    let actors = session.actors();
    if let Some(actors) = &actors {
        write_actors(&layout.actors(), actors)?;
    }
    for Stream { files, sensor, .. } in streams {
        if let Some((place, sensor)) = sensor {
            write_json(&files.sensor(), &SensorRecord::new(sensor, settings.fps, session.carrier(*place)))?;
        }
    }

    let stored = StoredFrames::find(recording)?;
    if !stored.is_complete() {
        prepare_session(recording, &mut session)?;
    }
    let sinks = streams
        .iter()
        .map(|stream| StreamSink::create(recording, stream, simulator.georeference(map)).map(Mutex::new))
        .collect::<Result<Vec<_>, _>>()?;
    let observers = Observers::new(recording, simulator, map, &session);
    let output = FrameRecorder::new(recording, &stored, &sinks);
    if let Some(session) = run_workers(recording, session, observers, &output, capabilities.random_access)? {
        clock.add_stats(session.stats());
    }
    let mut boxes = Vec::with_capacity(sinks.len());
    for sink in sinks {
        boxes.push(sink.into_inner().unwrap_or_else(PoisonError::into_inner).finish()?);
    }
    let sensor_boxes = boxes.split_off(settings.cameras.len());
    let record = SceneRecord {
        settings: settings.clone(),
        spawned,
        incidents: staged.incidents,
        missed_events: staged.missed,
        actors: actors.map(|actors| actors.len() as u32),
        frame_lines: layout.frames().is_file().then_some(settings.frames),
        camera_maps: simulator.map_features(map).map(|_| settings.cameras.len() as u32),
        recorded_frames: settings.frames,
        boxes,
        sensor_boxes,
    };
    // It says that the video is complete, after a power failure, too.
    layout.sync()?;
    write_json_durable(&layout.scene(), &record)?;
    Ok(record)
}

/// A session whose scene is populated.
pub(crate) struct OpenedSession<'m> {
    pub(crate) session: BoxedSession<'m>,
    pub(crate) spawned: SpawnCounts,
    pub(crate) staged: StagedIncidents,
}

/// Opens the session of a video, and tells what of it could not be had.
pub(crate) fn open_session<'m, S: Simulator>(
    simulator: &'m S,
    map: &'m S::Map,
    recording: &Recording<'m>,
) -> Result<OpenedSession<'m>, GenerateError> {
    let Recording { settings, streams, clock, progress, .. } = *recording;
    let open = || simulator.open_session(map, settings, wanted_layers(streams));
    let session = clock.time(Stage::LoadScene, open)?;
    let spawned = session.spawned();
    report_fewer(recording, &spawned);
    let staged = session.incidents();
    for &kind in &staged.missed {
        progress.event(&ProgressEvent::EventMissed { kind, map: &settings.map });
    }
    Ok(OpenedSession { session, spawned, staged })
}

/// Prepares a session before the workers start, so that it has all threads.
pub(crate) fn prepare_session(recording: &Recording<'_>, session: &mut BoxedSession<'_>) -> Result<(), GenerateError> {
    let start = Instant::now();
    recording.clock.time(Stage::Bake, || session.prepare())?;
    recording.progress.event(&ProgressEvent::Baked { seconds: start.elapsed().as_secs_f64() });
    Ok(())
}

/// The images that any camera stores.
fn wanted_layers(streams: &[Stream<'_>]) -> SensorLayers {
    let stored = streams.iter().filter_map(|stream| match &stream.model {
        StreamModel::Camera(camera) => Some(&camera.output.layers),
        _ => None,
    });
    Layer::wanted(&stored.flatten().copied().collect::<Vec<_>>())
}

/// Folders, no temporaries, the records of the cameras, and what they see of the map.
fn prepare_folders(recording: &Recording<'_>, features: Option<&MapFeatures>) -> Result<(), DatasetError> {
    let Recording { settings, layout, streams, .. } = *recording;
    for stream in streams {
        let folders = stream.frame_folders().into_iter().map(|(folder, _)| folder);
        for folder in folders.chain([stream.files.folder().to_owned()]) {
            fs::create_dir_all(&folder).map_err(|e| DatasetError::io("cannot make the folder", &folder, e))?;
        }
    }
    remove_temporaries(layout.folder())?;
    for (place, Stream { files, model, sensor, .. }) in streams.iter().enumerate() {
        let StreamModel::Camera(camera) = model else { continue };
        let record = camera_record(camera, settings.cameras.get(place), *sensor, features);
        write_json(&files.camera(), &record)?;
        if let (Some(features), StreamLens::Fixed { camera: lens, .. }, None) = (features, &camera.lens, sensor) {
            write_json_line(&files.map(), &CameraMap::new(features, lens))?;
        }
    }
    Ok(())
}

/// What a camera is: one of the scene, or one of the rig.
pub(crate) fn camera_record(
    CameraStream { output, lens }: &CameraStream<'_>,
    of_scene: Option<&SceneCamera>,
    of_rig: Option<(usize, &SceneSensor)>,
    features: Option<&MapFeatures>,
) -> CameraRecord {
    let fixed_rig = of_rig.and_then(|(_, sensor)| sensor.fixed_camera());
    match (lens, of_scene.or(fixed_rig.as_ref())) {
        (StreamLens::Fixed { camera: lens, .. }, Some(camera)) => {
            let ground_z = features.and_then(|features| features.ground_z(lens));
            let distortion = camera.look.distortion;
            CameraRecord::new(&camera.site, distortion, output.size, output.fps()).with_ground(ground_z)
        }
        (StreamLens::Moving(camera), _) => {
            let fov_rad = camera.horizontal_fov_rad as f32;
            CameraRecord::moving(camera.lens, fov_rad, camera.look.distortion, output.size, output.fps())
        }
        (StreamLens::Fixed { .. }, None) => unreachable!("a camera that stands still has a site"),
    }
}

fn report_fewer(recording: &Recording<'_>, spawned: &SpawnCounts) {
    let settings = recording.settings;
    let asked = [("vehicles", settings.vehicles, spawned.vehicles)];
    let walkers = [("pedestrians", settings.pedestrians, spawned.pedestrians)];
    for (what, asked, placed) in asked.into_iter().chain(walkers) {
        if placed < asked {
            recording.progress.event(&ProgressEvent::FewerSpawned { what, asked, placed, map: &settings.map });
        }
    }
}
