//! The whole run: plan, scenes, videos, resume.

mod estimate;
mod output;

pub use estimate::Estimate;

use crate::{
    Event, GenerateError, Plan, Progress, Simulator, StageTimes,
    record::{Clock, Recording, Stage, record_video},
};
use endless_dataset::{DatasetLayout, Manifest, Recipe, VideoEntry, VideoLayout, VideoState, write_json};
use endless_world::SceneSettings;
use output::{Lock, Output};
use std::{path::Path, time::Instant};

/// What does not change the bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GenerateOptions {
    /// Threads that record.
    pub threads: usize,
    /// Write the scenes and stop.
    pub plan_only: bool,
}

/// What a run did.
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
    /// Seconds that recording took, wall time.
    pub seconds: f64,
    /// Where the time went.
    pub times: StageTimes,
}

/// Makes the dataset of a recipe in a folder, or completes what is there.
///
/// # Errors
/// When the folder holds something else, the disk is too small or the simulator fails. What is complete stays, and the
/// same call goes on from there.
pub fn generate<S: Simulator>(
    simulator: &S,
    recipe: &Recipe,
    root: &Path,
    options: &GenerateOptions,
    progress: &dyn Progress,
) -> Result<Generated, GenerateError> {
    let start = Instant::now();
    let layout = DatasetLayout::new(root);
    let plan = Plan::new(recipe, simulator)?;
    let output = Output::inspect(&layout, recipe, &plan)?;
    let estimate = estimate::estimate(&layout, recipe, &output.to_do(&plan))?;
    if !options.plan_only && estimate.bytes > estimate.free {
        return Err(GenerateError::DiskTooSmall { estimate, path: root.to_owned() });
    }
    let _lock = Lock::take(&layout)?;
    // Once more, now that nobody else can change it.
    let output = Output::inspect(&layout, recipe, &plan)?;
    let to_do = output.to_do(&plan);
    let mut manifest = Manifest::new(recipe.clone(), output.entries(&plan));
    output::write_plan(&layout, &manifest, &plan)?;
    let mut generated = Generated {
        plan: plan.clone(),
        videos: 0,
        camera_frames: 0,
        bytes: 0,
        seconds: 0.0,
        times: StageTimes::default(),
    };
    if options.plan_only {
        return Ok(generated);
    }
    let complete = recipe.videos - to_do.len() as u32;
    progress.event(&Event::Start { videos: to_do.len() as u32, complete, estimate });
    let clock = Clock::default();
    let mut run = Run { simulator, recipe, layout: &layout, options, progress, clock: &clock, place: 0 };
    for same_map in to_do.chunk_by(|a, b| a.map == b.map) {
        progress.event(&Event::LoadMap { map: &same_map[0].map });
        let map = clock.time(Stage::LoadMap, || simulator.load_map(&same_map[0].map))?;
        for settings in same_map {
            let entry = run.video(&map, settings, to_do.len() as u32)?;
            manifest.videos[settings.video as usize] = entry;
            write_json(&layout.manifest(), &manifest)?;
            generated.videos += 1;
            generated.camera_frames += 2 * u64::from(settings.frames);
            generated.bytes += layout.video(settings).bytes()?;
        }
    }
    generated.seconds = start.elapsed().as_secs_f64();
    generated.times = clock.times();
    Ok(generated)
}

/// What all videos of a run share.
struct Run<'a, S> {
    simulator: &'a S,
    recipe: &'a Recipe,
    layout: &'a DatasetLayout,
    options: &'a GenerateOptions,
    progress: &'a dyn Progress,
    clock: &'a Clock,
    place: u32,
}

impl<S: Simulator> Run<'_, S> {
    fn video(&mut self, map: &S::Map, settings: &SceneSettings, of: u32) -> Result<VideoEntry, GenerateError> {
        self.place += 1;
        let name = VideoLayout::name(settings);
        let camera_frames = 2 * u64::from(settings.frames);
        self.progress.event(&Event::Video { name: &name, place: self.place, of, camera_frames });
        let recording = Recording {
            settings,
            recipe: self.recipe,
            layout: &self.layout.video(settings),
            threads: self.options.threads.max(1),
            progress: self.progress,
            clock: self.clock,
        };
        let record = self.clock.time(Stage::Record, || record_video(self.simulator, map, &recording))?;
        self.progress.event(&Event::VideoDone { name: &name });
        Ok(output::entry(settings, VideoState::Complete, Some(record.boxes)))
    }
}
