//! A whole run: plan, scenes, videos, resume.

mod begun_video;
mod estimate;
mod index;
mod lock;
mod lock_file;
mod output;

use crate::{
    DatasetStore, FolderStore, GenerateError, MapUse, Plan, Progress, ProgressEvent, SensorTimes, Shard, Simulator,
    SimulatorError, StageTimes,
    measurements::measurements,
    record::{Recording, Stage, StageClock, Stream, record_video, worker_pool},
};
use endless_dataset::{BuildIdentity, DatasetLayout, Recipe, SharedFiles, VideoLayout};
use endless_world::SceneSettings;
use index::DatasetIndex;
use lock::DatasetLock;
use output::{OutputFolder, ResumeRequest};
use std::{path::Path, time::Instant};

/// Settings of a run that are not part of the recipe.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GenerateOptions {
    /// The program that runs. A dataset that another one began is refused.
    pub build: BuildIdentity,
    /// Resume what another build began, and note which builds made which video.
    pub allow_other_build: bool,
    /// Number of threads.
    pub threads: usize,
    /// Write the scenes and stop.
    pub plan_only: bool,
    /// The part of the videos to make; all of them without.
    pub shard: Option<Shard>,
}

/// The result of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Generated {
    /// The whole plan.
    pub plan: Plan,
    /// Videos that were recorded or completed.
    pub videos: u32,
    /// Camera frames of these.
    pub camera_frames: u64,
    /// Bytes of all their files.
    pub bytes: u64,
    /// Wall time of recording, seconds.
    pub seconds: f64,
    /// Time by stage.
    pub times: StageTimes,
    /// Time by sensor: the cameras of the scenes, then the rig's.
    pub sensors: Vec<SensorTimes>,
}

/// Makes the dataset of a recipe in a folder, or resumes it.
///
/// # Errors
/// When the folder holds something else, the disk is too small or the simulator fails. Complete files stay, and the same
/// call resumes from them.
pub fn generate<S: Simulator>(
    simulator: &S,
    recipe: &Recipe,
    root: &Path,
    options: &GenerateOptions,
    progress: &dyn Progress,
) -> Result<Generated, GenerateError> {
    generate_into(simulator, recipe, root, &FolderStore, options, progress)
}

/// Makes the dataset of a recipe in a store, or resumes it; videos are recorded in a folder of work.
///
/// # Errors
/// As [`generate`], and when the store refuses.
pub fn generate_into<S: Simulator>(
    simulator: &S,
    recipe: &Recipe,
    root: &Path,
    store: &dyn DatasetStore,
    options: &GenerateOptions,
    progress: &dyn Progress,
) -> Result<Generated, GenerateError> {
    let pool = worker_pool(simulator, options.threads)?;
    pool.install(|| generate_in(&pool, simulator, recipe, root, store, options, progress))
}

/// [`generate_into`] on the threads of a pool.
fn generate_in<S: Simulator>(
    pool: &rayon::ThreadPool,
    simulator: &S,
    recipe: &Recipe,
    root: &Path,
    store: &dyn DatasetStore,
    options: &GenerateOptions,
    progress: &dyn Progress,
) -> Result<Generated, GenerateError> {
    let start = Instant::now();
    let layout = DatasetLayout::new(root);
    let plan = Plan::new(recipe, simulator)?;
    let part = plan.part(options.shard);
    let allow_other_build = options.allow_other_build;
    let claim = ResumeRequest { recipe, plan: &plan, build: &options.build, allow_other_build, store };
    // A folder is not touched before it is known that it may be. One of work is nobody else's, and is made anew.
    let of_work = store.videos_at_a_time().is_some();
    let early_lock = of_work.then(|| DatasetLock::take(&layout, options.shard)).transpose()?;
    store.open(&layout)?;
    let output = OutputFolder::inspect(&layout, &claim, &part)?;
    let remaining_scenes = output.remaining_scenes(&plan, &part);
    let estimate = estimate::estimate(&layout, recipe, &remaining_scenes, store.videos_at_a_time())?;
    if !options.plan_only && estimate.bytes > estimate.free {
        return Err(GenerateError::DiskTooSmall { estimate, path: root.to_owned() });
    }
    let lock = early_lock.map_or_else(|| DatasetLock::take(&layout, options.shard), Ok)?;
    if !lock.holds() {
        progress.event(&ProgressEvent::NoLocks);
    }
    // Once more, now that nobody else can change it.
    let output = OutputFolder::inspect(&layout, &claim, &part)?;
    let remaining_scenes = output.remaining_scenes(&plan, &part);
    let files = shared_files(options.shard);
    for folder in [layout.root(), &layout.scenes()] {
        files.remove_temporaries(folder, |writer| !lock.holds() || is_of_same_shards(writer, options.shard))?;
    }
    output::write_plan(&layout, &plan, &files)?;
    store.put_scenes(&layout)?;
    output::reopen(&layout, &remaining_scenes, store)?;
    let mut index = DatasetIndex::new(&layout, claim, &files);
    index.update()?;
    let mut generated = Generated {
        plan: plan.clone(),
        videos: 0,
        camera_frames: 0,
        bytes: 0,
        seconds: 0.0,
        times: StageTimes::default(),
        sensors: Vec::new(),
    };
    if options.plan_only {
        return Ok(generated);
    }
    let complete = (part.len() - remaining_scenes.len()) as u32;
    progress.event(&ProgressEvent::Start {
        videos: remaining_scenes.len() as u32,
        complete,
        estimate,
        shard: options.shard,
    });
    let clock = StageClock::default();
    let mut run = GenerateRun { pool, simulator, recipe, layout: &layout, options, progress, clock: &clock, place: 0 };
    for same_map in remaining_scenes.chunk_by(|a, b| a.shares_town(b)) {
        let name = &same_map[0].map;
        let cameras = plan.all_cameras(recipe, simulator, same_map[0])?;
        let load = || {
            progress.event(&ProgressEvent::LoadMap { map: name });
            clock.time(Stage::LoadMap, || simulator.load_map(&MapUse { name, cameras: &cameras, videos: same_map }))
        };
        let mut map = None;
        for settings in same_map {
            let of = remaining_scenes.len() as u32;
            run.place += 1;
            let mut failures = 0;
            if progress.is_stopped() {
                return Err(SimulatorError::Interrupted.into());
            }
            while let Err(failure) = run.video(&mut map, &load, settings, of, &mut index, &mut generated.sensors) {
                failures += 1;
                // What is loaded there may be lost with the connection.
                map = None;
                run.recover(settings, failure, failures)?;
            }
            let video = layout.video(settings);
            generated.bytes += video.bytes()?;
            store.put_video(&video)?;
            index.update()?;
            generated.videos += 1;
            generated.camera_frames += measurements(settings);
        }
    }
    if of_work {
        store.wait()?;
        index.update()?;
        store.close(&layout)?;
    }
    generated.seconds = start.elapsed().as_secs_f64();
    generated.times = clock.times();
    Ok(generated)
}

/// How the files are written that all shards write.
fn shared_files(shard: Option<Shard>) -> SharedFiles {
    shard.map_or_else(SharedFiles::alone, |shard| SharedFiles::of(shard.file_name()))
}

/// Whether a writer of temporary files may be at work beside this shard: one of as many shards.
fn is_of_same_shards(writer: &str, shard: Option<Shard>) -> bool {
    shard.zip(Shard::from_file_name(writer)).is_some_and(|(shard, other)| shard.of() == other.of())
}

/// The state that all videos of a run share.
struct GenerateRun<'a, S> {
    pool: &'a rayon::ThreadPool,
    simulator: &'a S,
    recipe: &'a Recipe,
    layout: &'a DatasetLayout,
    options: &'a GenerateOptions,
    progress: &'a dyn Progress,
    clock: &'a StageClock,
    place: u32,
}

impl<S: Simulator> GenerateRun<'_, S> {
    /// After a failure of a video: whether it may be begun again.
    fn recover(&self, settings: &SceneSettings, failure: GenerateError, failures: u32) -> Result<(), GenerateError> {
        let GenerateError::Simulator(failure) = failure else { return Err(failure) };
        if !failure.is_passing() {
            return Err(failure.into());
        }
        let reason = failure.to_string();
        self.simulator.recover(failure, failures)?;
        self.progress.event(&ProgressEvent::VideoAgain { name: &VideoLayout::name(settings), reason: &reason });
        Ok(())
    }

    /// Records a video, and notes who does it before it begins.
    fn video(
        &mut self,
        map: &mut Option<S::Map>,
        load: &impl Fn() -> Result<S::Map, SimulatorError>,
        settings: &SceneSettings,
        of: u32,
        index: &mut DatasetIndex<'_>,
        sensors: &mut Vec<SensorTimes>,
    ) -> Result<(), GenerateError> {
        let map = match map {
            Some(map) => map,
            none => none.insert(load()?),
        };
        let name = VideoLayout::name(settings);
        let camera_frames = measurements(settings);
        self.progress.event(&ProgressEvent::Video { name: &name, place: self.place, of, camera_frames });
        let layout = self.layout.video(settings);
        layout.note_build(&self.options.build)?;
        index.update()?;
        let streams = Stream::all(self.recipe, settings, &layout);
        let recording = Recording {
            settings,
            recipe: self.recipe,
            layout: &layout,
            streams: &streams,
            pool: self.pool,
            progress: self.progress,
            clock: self.clock,
        };
        self.clock.time(Stage::Record, || record_video(self.simulator, map, &recording))?;
        streams.iter().for_each(|stream| stream.add_times(sensors));
        self.progress.event(&ProgressEvent::VideoDone { name: &name });
        Ok(())
    }
}
