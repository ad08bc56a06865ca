//! One video from its first frame to its last.

use super::{
    frame::FrameRecorder,
    recording::Recording,
    scheduler::{FrameScheduler, WorkerJob},
    sink::{SinkItem, StreamSink},
    stored::{StoredFrames, remove_stored},
    streams::{CameraStream, Stream, StreamLens, StreamModel},
    times::Stage,
    vehicle_sensors::VehicleSensors,
};
use crate::{GenerateError, ProgressEvent, SimulationSession, Simulator, SimulatorError};
use endless_annotate::{CameraMap, MapFeatures, SceneFrame, SceneObserver};
use endless_dataset::{
    CameraRecord, DatasetError, Layer, SceneRecord, SensorRecord, SpawnCounts, remove_temporaries, write_actors,
    write_json, write_json_durable, write_json_line,
};
use endless_world::SensorLayers;
use std::{
    fs,
    sync::{Barrier, Mutex, PoisonError},
    time::Instant,
};

type BoxedSession<'m> = Box<dyn SimulationSession<'m> + 'm>;

/// Records a video, or completes it.
pub(crate) fn record_video<S: Simulator>(
    simulator: &S,
    map: &S::Map,
    recording: &Recording<'_>,
) -> Result<SceneRecord, GenerateError> {
    let Recording { settings, recipe, layout, streams, clock, .. } = *recording;
    let capabilities = simulator.capabilities();
    if !capabilities.repeatable {
        remove_stored(recording)?;
    }
    prepare_folders(recording, simulator.map_features(map))?;
    let mut session = clock.time(Stage::LoadScene, || simulator.open_session(map, settings, wanted_layers(streams)))?;
    let spawned = session.spawned();
    report_fewer(recording, &spawned);
    let staged = session.incidents();
    for &kind in &staged.missed {
        recording.progress.event(&ProgressEvent::EventMissed { kind, map: &settings.map });
    }
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
        // Before the workers start, so that it has all threads.
        let start = Instant::now();
        clock.time(Stage::Bake, || session.prepare())?;
        recording.progress.event(&ProgressEvent::Baked { seconds: start.elapsed().as_secs_f64() });
    }
    let sinks = streams
        .iter()
        .map(|stream| StreamSink::create(recording, stream, simulator.georeference(map)).map(Mutex::new))
        .collect::<Result<Vec<_>, _>>()?;
    let lines = recipe.counting_lines.iter().filter(|line| line.map == settings.map).cloned().collect();
    let road = session.road_facts();
    let marks = simulator.map_features(map).map_or(&[][..], |features| &features.marks);
    let carrier = |sensor| session.carrier(sensor);
    let vehicle_sensors = VehicleSensors::new(streams, carrier, || session.bodies(), marks);
    let observer = Mutex::new((SceneObserver::new(road, lines), vehicle_sensors));
    let window = 2 * recording.pool.current_num_threads() as u32 + 2;
    let scheduler = FrameScheduler::new(session, sinks.len(), settings.frames, window);
    let work = VideoWorkers {
        scheduler: &scheduler,
        observer: &observer,
        sinks: &sinks,
        maker: FrameRecorder::new(recording, &stored),
        random_access: capabilities.random_access,
    };
    let failure = Mutex::new(None);
    // Nobody begins before all are there: a thread that helped one at work, and took up its own part only while it waited
    // for a piece of that, would wait here for the one that waits for it.
    let all_here = Barrier::new(recording.pool.current_num_threads());
    recording.pool.broadcast(|_| {
        all_here.wait();
        let _stop_others_on_panic = scheduler.stop_on_panic();
        if let Err(error) = work.all() {
            failure.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
            scheduler.stop();
        }
    });
    if let Some(error) = failure.into_inner().unwrap_or_else(PoisonError::into_inner) {
        return Err(error);
    }
    if let Some(session) = scheduler.into_session() {
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
        let CameraStream { output, lens } = camera;
        let fixed_rig = sensor.and_then(|(_, sensor)| sensor.fixed_camera());
        let record = match (lens, settings.cameras.get(place).or(fixed_rig.as_ref())) {
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
        };
        write_json(&files.camera(), &record)?;
        if let (Some(features), StreamLens::Fixed { camera: lens, .. }, None) = (features, lens, sensor) {
            write_json_line(&files.map(), &CameraMap::new(features, lens))?;
        }
    }
    Ok(())
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

/// The state that all workers of a video share.
struct VideoWorkers<'a, 'm> {
    scheduler: &'a FrameScheduler<BoxedSession<'m>, SinkItem>,
    /// It sees the frames in their order: whoever has the session has it.
    observer: &'a Mutex<(SceneObserver, VehicleSensors)>,
    sinks: &'a [Mutex<StreamSink>],
    maker: FrameRecorder<'a>,
    random_access: bool,
}

impl<'m> VideoWorkers<'_, 'm> {
    /// Runs one worker until no job is left.
    fn all(&self) -> Result<(), GenerateError> {
        while let Some(job) = self.scheduler.next() {
            match job {
                WorkerJob::Frame { frame, session } => self.frame(frame, session)?,
                WorkerJob::Sink { camera, item } => {
                    let mut sink = self.sinks[camera].lock().unwrap_or_else(PoisonError::into_inner);
                    let Recording { streams, clock, .. } = *self.maker.recording;
                    streams[camera].clock.time(|| sink.push(item, clock))?;
                    drop(sink);
                    self.scheduler.sink_done(camera);
                }
            }
        }
        Ok(())
    }

    fn frame(&self, frame: u32, mut session: BoxedSession<'m>) -> Result<(), GenerateError> {
        let Recording { clock, progress, .. } = *self.maker.recording;
        let step = clock.time(Stage::Traffic, || session.tick())?;
        if step.state.frame != frame {
            return Err(SimulatorError::FramesDropped { expected: frame, got: step.state.frame }.into());
        }
        let (happenings, noticed) = clock.time(Stage::Traffic, || {
            let mut observers = self.observer.lock().unwrap_or_else(PoisonError::into_inner);
            (observers.0.observe(&step.state), observers.1.observe(&step.state))
        });
        let taken = if self.random_access {
            self.scheduler.return_session(session);
            self.maker.take(step)?
        } else {
            let taken = self.maker.take(step)?;
            self.scheduler.return_session(session);
            taken
        };
        let (resumed, measurements) = (taken.is_stored(), taken.measurements());
        let mut items = self.maker.finish(&taken)?;
        if let Some(first) = items.first_mut() {
            first.scene = taken.into_scene_frame().map(|scene| SceneFrame { happenings, ..scene });
        }
        for (stream, noticed) in noticed {
            items[stream].noticed = Some(noticed);
        }
        self.scheduler.deliver(frame, items);
        progress.event(&ProgressEvent::Frame { cameras: measurements, resumed });
        Ok(())
    }
}
