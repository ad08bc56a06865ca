//! Records a few frames of a few videos.

use super::{RateSample, Rates, choice::unlike, frame_times::FrameTimes};
use crate::{
    GenerateError, MapUse, Plan, Progress, ProgressEvent, Simulator,
    measurements::measurements,
    record::{Recording, Stage, StageClock, Stream, record_video},
};
use endless_dataset::{BuildIdentity, DatasetError, DatasetLayout, Recipe, VideoLayout};
use endless_world::{CameraSite, SceneSettings};
use std::{fs, path::PathBuf};

/// How rates are measured.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RateOptions {
    /// Videos that are tried, each unlike the others.
    pub videos: usize,
    /// Frames of each.
    pub frames: u32,
    /// Threads that work.
    pub threads: usize,
    /// Where they are recorded; nothing is left there.
    pub folder: PathBuf,
    /// The program that runs.
    pub build: BuildIdentity,
}

/// Measures rates with a few videos of a plan.
///
/// # Errors
/// When the simulator fails or the disk refuses.
pub fn measure_rates<S: Simulator>(
    simulator: &S,
    recipe: &Recipe,
    plan: &Plan,
    options: &RateOptions,
    progress: &dyn Progress,
) -> Result<Rates, GenerateError> {
    let RateOptions { videos, frames, threads, ref folder, ref build } = *options;
    let waiting = usize::from(simulator.capabilities().waits);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.max(1) + waiting).build()?;
    let work = tempfile::Builder::new().prefix(".endless-plan-").tempdir_in(folder);
    let work = work.map_err(|e| DatasetError::io("cannot make a folder in", folder, e))?;
    let chosen = unlike(&plan.scenes, videos.max(1));
    let of = chosen.len() as u32;
    let measure = || -> Result<Vec<RateSample>, GenerateError> {
        let samples = chosen.iter().zip(1..).map(|(settings, place)| {
            let settings = SceneSettings { frames: frames.clamp(1, settings.frames), ..(*settings).clone() };
            progress.event(&ProgressEvent::Video {
                name: &VideoLayout::name(&settings),
                place,
                of,
                camera_frames: measurements(&settings),
            });
            let cameras = plan.all_cameras(recipe, simulator, &settings)?;
            sample(simulator, recipe, (&settings, &cameras), &pool, &DatasetLayout::new(work.path()), progress)
        });
        samples.collect()
    };
    let samples = pool.install(measure)?;
    Ok(Rates { of: Rates::key(recipe, threads, &build.sources), threads, samples })
}

/// Records one video, and looks at what that took.
fn sample<S: Simulator>(
    simulator: &S,
    recipe: &Recipe,
    (settings, cameras): (&SceneSettings, &[CameraSite]),
    pool: &rayon::ThreadPool,
    layout: &DatasetLayout,
    progress: &dyn Progress,
) -> Result<RateSample, GenerateError> {
    let recipe = Recipe { duration: f64::from(settings.frames) / recipe.fps, ..recipe.clone() };
    let clock = StageClock::default();
    let wanted = MapUse { name: &settings.map, cameras, videos: &[settings] };
    let map = clock.time(Stage::LoadMap, || simulator.load_map(&wanted))?;
    let video = layout.video(settings);
    let streams = Stream::all(&recipe, settings, &video);
    let frame_times = FrameTimes::new(progress);
    let progress: &dyn Progress = &frame_times;
    let recording =
        Recording { settings, recipe: &recipe, layout: &video, streams: &streams, pool, progress, clock: &clock };
    clock.time(Stage::Record, || record_video(simulator, &map, &recording))?;
    let times = clock.times();
    let measured = measurements(settings).max(1);
    let record_s = times.record.as_secs_f64();
    let frames = f64::from(settings.frames.max(1));
    let frame_s = frame_times.steady(pool.current_num_threads()).unwrap_or(record_s / frames).min(record_s / frames);
    let once = bytes_once(&video, settings)?;
    let all = video.bytes()?;
    fs::remove_dir_all(video.folder()).map_err(|e| DatasetError::io("cannot remove", video.folder(), e))?;
    Ok(RateSample {
        map: settings.map.clone(),
        weather: settings.weather,
        time_of_day: settings.time_of_day,
        frames: settings.frames,
        measurements: measured,
        load_map_s: times.load_map.as_secs_f64(),
        load_scene_s: times.load_scene.as_secs_f64(),
        bake_s: times.bake.as_secs_f64(),
        first_s: record_s - frame_s * frames,
        frame_s: frame_s * frames / measured as f64,
        frame_bytes: (all - once) as f64 / measured as f64,
        video_bytes: once as f64,
    })
}

/// Bytes of the files whose size does not depend on the number of frames.
fn bytes_once(video: &VideoLayout, settings: &SceneSettings) -> Result<u64, DatasetError> {
    let mut paths = vec![video.scene(), video.actors()];
    for camera in video.cameras(settings.cameras.len()) {
        paths.extend([camera.camera(), camera.map()]);
    }
    for sensor in &settings.sensors {
        let files = video.sensor(&sensor.name);
        paths.extend([files.camera(), files.map(), files.sensor()]);
    }
    let sizes = paths
        .iter()
        .filter(|path| path.is_file())
        .map(|path| fs::metadata(path).map(|file| file.len()).map_err(|e| DatasetError::io("cannot read", path, e)));
    sizes.sum()
}
