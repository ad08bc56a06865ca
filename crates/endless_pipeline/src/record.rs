//! Records one video: ticks once, renders frames on all threads, writes everything in order.
//!
//! There is one kind of thread. A worker first does ordered work if some waits (feeding a camera's video encoder and
//! its list of objects), and else takes the next state of the world, renders all cameras, encodes and writes the
//! images. The scheduler keeps the workers within a window of frames, so memory is the same after ten seconds and after
//! an hour.

mod frame;
mod scheduler;
mod sink;
mod stored;
mod times;

pub use times::StageTimes;
pub(crate) use {
    stored::{camera_is_complete, count_images},
    times::{Clock, Stage},
};

use crate::{Cameras, Event, GenerateError, Progress, Scene, Simulator};
use endless_dataset::{
    CameraRecord, Recipe, SceneRecord, VideoLayout, remove_temporaries, write_json, write_json_durable,
};
use endless_world::{Actor, PinholeCamera, SceneCamera, SceneSettings};
use frame::FrameMaker;
use scheduler::{FrameScheduler, Job};
use sink::{CameraSink, SinkItem};
use std::{
    sync::{Mutex, OnceLock, PoisonError},
    time::Instant,
};
use stored::StoredFrames;

/// What a recording needs besides the simulator.
pub(crate) struct Recording<'a> {
    pub(crate) settings: &'a SceneSettings,
    pub(crate) recipe: &'a Recipe,
    pub(crate) layout: &'a VideoLayout,
    pub(crate) threads: usize,
    pub(crate) progress: &'a dyn Progress,
    pub(crate) clock: &'a Clock,
}

/// The cameras, baked when the first frame needs them.
struct LazyCameras<'a, S: Simulator> {
    simulator: &'a S,
    map: &'a S::Map,
    recording: &'a Recording<'a>,
    moving: &'a [Actor],
    baked: OnceLock<Result<Box<dyn Cameras + 'a>, GenerateError>>,
}

impl<'a, S: Simulator> LazyCameras<'a, S> {
    /// `None` when baking failed; the error waits in `baked`.
    fn get(&self) -> Option<&(dyn Cameras + 'a)> {
        let baked = self.baked.get_or_init(|| {
            let start = Instant::now();
            let cameras = self.recording.clock.time(Stage::Bake, || {
                self.simulator.bake(self.map, self.recording.settings, self.moving).map_err(GenerateError::from)
            });
            self.recording.progress.event(&Event::Baked { seconds: start.elapsed().as_secs_f64() });
            cameras
        });
        baked.as_ref().ok().map(Box::as_ref)
    }
}

/// Records a video, or completes it.
pub(crate) fn record_video<S: Simulator>(
    simulator: &S,
    map: &S::Map,
    recording: &Recording<'_>,
) -> Result<SceneRecord, GenerateError> {
    let Recording { settings, recipe, layout, .. } = *recording;
    for camera in layout.cameras(settings.cameras.len()) {
        camera.create(&recipe.layers)?;
    }
    remove_temporaries(layout.folder())?;
    for (number, SceneCamera { site, look }) in settings.cameras.iter().enumerate() {
        let record = CameraRecord::new(site, look.distortion, settings.size, settings.fps);
        write_json(&layout.camera(number).camera(), &record)?;
    }
    let Scene { spawned, parked, moving, skin_tones, bodies, traffic } =
        recording.clock.time(Stage::LoadScene, || simulator.load_scene(map, settings))?;
    report_fewer(recording, &spawned);

    let stored = StoredFrames::find(recording)?;
    let cameras = LazyCameras { simulator, map, recording, moving: &moving, baked: OnceLock::new() };
    if !stored.is_complete() {
        // On this thread, before the workers start, so that the baking has all cores.
        cameras.get();
    }
    let sinks = (0..settings.cameras.len())
        .map(|camera| CameraSink::create(recording, camera).map(Mutex::new))
        .collect::<Result<Vec<_>, _>>()?;
    let scheduler = FrameScheduler::new(traffic, sinks.len(), settings.frames, 2 * recording.threads as u32 + 2);
    let lens = |SceneCamera { site, look }: &SceneCamera| {
        PinholeCamera::new(site, settings.size).with_distortion(look.distortion)
    };
    let lenses: Vec<PinholeCamera> = settings.cameras.iter().map(lens).collect();
    let (parked, skin_tones, bodies) = (&parked, &skin_tones, bodies.as_deref());
    let maker = FrameMaker { recording, parked, skin_tones, bodies, lenses: &lenses, stored: &stored };
    let failure = Mutex::new(None);
    if cameras.baked.get().is_none_or(Result::is_ok) {
        std::thread::scope(|scope| {
            for _ in 0..recording.threads {
                scope.spawn(|| {
                    let _stop_others_on_panic = scheduler.stop_on_panic();
                    if let Err(error) = work(&scheduler, &sinks, &maker, &cameras) {
                        failure.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
                        scheduler.stop();
                    }
                });
            }
        });
    }
    if let Some(cameras) = cameras.baked.get().and_then(|c| c.as_ref().ok()) {
        recording.clock.add_rays(cameras.stats());
    }
    if let Some(Err(error)) = cameras.baked.into_inner() {
        return Err(error);
    }
    if let Some(error) = failure.into_inner().unwrap_or_else(PoisonError::into_inner) {
        return Err(error);
    }
    let mut boxes = Vec::with_capacity(sinks.len());
    for sink in sinks {
        boxes.push(sink.into_inner().unwrap_or_else(PoisonError::into_inner).finish()?);
    }
    let record = SceneRecord { settings: settings.clone(), spawned, recorded_frames: settings.frames, boxes };
    // It says that the video is complete, after a power failure, too.
    layout.sync()?;
    write_json_durable(&layout.scene(), &record)?;
    Ok(record)
}

/// What a worker does until there is nothing left. When baking failed, there is nothing to do.
fn work<S: Simulator>(
    scheduler: &FrameScheduler<'_, SinkItem>,
    sinks: &[Mutex<CameraSink>],
    maker: &FrameMaker<'_>,
    cameras: &LazyCameras<'_, S>,
) -> Result<(), GenerateError> {
    while let Some(job) = scheduler.next(&maker.recording.clock.timer(Stage::Traffic)) {
        match job {
            Job::Frame(state) => {
                let made = maker.make(&state, || cameras.get())?;
                let Some((items, resumed)) = made else {
                    scheduler.stop();
                    return Ok(());
                };
                scheduler.deliver(state.frame, items);
                maker.recording.progress.event(&Event::Frame { cameras: sinks.len() as u32, resumed });
            }
            Job::Sink { camera, item } => {
                let mut sink = sinks[camera].lock().unwrap_or_else(PoisonError::into_inner);
                sink.push(&item, maker.recording.clock)?;
                drop(sink);
                scheduler.sink_done(camera);
            }
        }
    }
    Ok(())
}

fn report_fewer(recording: &Recording<'_>, spawned: &endless_dataset::Spawned) {
    let settings = recording.settings;
    let asked = [("vehicles", settings.vehicles, spawned.vehicles)];
    let walkers = [("pedestrians", settings.pedestrians, spawned.pedestrians)];
    for (what, asked, placed) in asked.into_iter().chain(walkers) {
        if placed < asked {
            recording.progress.event(&Event::Fewer { what, asked, placed, map: &settings.map });
        }
    }
}
