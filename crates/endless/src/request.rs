//! What other programs ask for: what `endless generate` makes of a recipe, written to a folder or handed over, watched by
//! whoever asks.

use crate::{
    args::{Cli, Command, GenerateArgs},
    generate::{Record, WithSimulator, with_simulator},
    said, threads,
};
use anyhow::Result;
use clap::Parser;
use endless_carla::client::StopFlag;
use endless_dataset::{Recipe, RecipeDraft};
use endless_interchange::MapLibrary;
use endless_pipeline::{
    Generated, MapSource, Plan, Progress, RecipeError, Simulator, SimulatorError, StreamEnd, StreamOptions,
    StreamedFrame, stream,
};
use endless_world::CameraSite;
use std::{error::Error, ffi::OsString, fmt, ops::ControlFlow};

/// A recipe, and how it is made.
#[derive(Debug)]
pub struct Request {
    args: Box<GenerateArgs>,
    draft: RecipeDraft,
    threads: usize,
    stop: StopFlag,
}

/// Something cannot be asked for.
#[derive(Debug)]
pub struct UsageError(String);

impl fmt::Display for UsageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Error for UsageError {}

impl Request {
    /// A request for the dataset in the folder `out`. The flags are those of `endless generate`; what they say of the recipe
    /// wins over the draft. A CARLA server is left when `stop` is set.
    ///
    /// # Errors
    /// [`UsageError`], when a flag cannot be understood.
    pub fn new(out: OsString, flags: Vec<OsString>, draft: RecipeDraft, stop: StopFlag) -> Result<Self> {
        let program = ["endless", "generate"].map(OsString::from);
        let arguments = program.into_iter().chain(flags).chain(["--".into(), out]);
        let cli = Cli::try_parse_from(arguments).map_err(|error| UsageError(said(&error)))?;
        let threads = threads::threads(cli.threads);
        match cli.command {
            Command::Generate(mut args) => {
                let draft = std::mem::take(&mut args.recipe.draft).or(draft);
                Ok(Self { args, draft, threads, stop })
            }
            _ => Err(UsageError("flags are those of endless generate".to_owned()).into()),
        }
    }

    /// Makes the dataset, or resumes it.
    ///
    /// # Errors
    /// [`RecipeError`] and [`endless_pipeline::GenerateError`].
    pub fn generate(self, progress: &dyn Progress) -> Result<Generated> {
        let Self { args, draft, threads, stop } = self;
        let record = Record { args: &args, threads, progress };
        with_simulator(MapLibrary::user(), draft, &args, Some(stop), record)
    }

    /// Hands over the frames that the dataset would have, in the order of `options`; its threads and its shard
    /// are those of the request.
    ///
    /// # Errors
    /// As [`Self::generate`].
    pub fn stream(
        self,
        options: &StreamOptions,
        progress: &dyn Progress,
        take: &mut (dyn FnMut(StreamedFrame) -> ControlFlow<()> + Send),
    ) -> Result<StreamEnd> {
        let Self { args, draft, threads, stop } = self;
        let options = StreamOptions { threads, shard: args.shard, ..options.clone() };
        let hand_over = HandOver { options, camera: None, progress, take };
        with_simulator(MapLibrary::user(), draft, &args, Some(stop), hand_over)
    }

    /// How many frames the cameras of each of so many shards make.
    ///
    /// # Errors
    /// When a plan cannot be made of the recipe.
    pub fn camera_frames_of_shards(self, of: u32) -> Result<Vec<u64>> {
        let Self { args, draft, stop, .. } = self;
        with_simulator(MapLibrary::user(), draft, &args, Some(stop), CountShards { of })
    }

    /// Makes one frame of the first video, filmed by the camera of this name alone, or by those that the plan chooses.
    ///
    /// # Errors
    /// As [`Self::generate`]; [`UsageError`] if the map has no such camera.
    pub fn render(self, camera: Option<&str>, frame: u32, progress: &dyn Progress) -> Result<Option<StreamedFrame>> {
        let Self { args, draft, threads, stop } = self;
        let mut rendered = None;
        let mut take = |frame| {
            rendered = Some(frame);
            ControlFlow::Break(())
        };
        let options = StreamOptions { threads, first_frame: frame.into(), ..StreamOptions::default() };
        let hand_over = HandOver { options, camera, progress, take: &mut take };
        with_simulator(MapLibrary::user(), draft, &args, Some(stop), hand_over)?;
        Ok(rendered)
    }
}

/// Counts the frames of shards.
struct CountShards {
    of: u32,
}

impl WithSimulator for CountShards {
    type Made = Vec<u64>;

    fn run<S: Simulator + MapSource>(self, simulator: &S, recipe: &Recipe) -> Result<Vec<u64>> {
        let plan = Plan::new(recipe, simulator)?;
        let of_video = |video: &u32| {
            let scene = &plan.scenes[*video as usize];
            u64::from(scene.frames) * scene.cameras.len() as u64
        };
        Ok(plan.shards(self.of).iter().map(|videos| videos.iter().map(of_video).sum()).collect())
    }
}

/// Hands frames over.
struct HandOver<'a> {
    options: StreamOptions,
    /// The one that films, of the recipe's first map.
    camera: Option<&'a str>,
    progress: &'a dyn Progress,
    take: &'a mut (dyn FnMut(StreamedFrame) -> ControlFlow<()> + Send),
}

impl WithSimulator for HandOver<'_> {
    type Made = StreamEnd;

    fn run<S: Simulator + MapSource>(self, simulator: &S, recipe: &Recipe) -> Result<StreamEnd> {
        let mut recipe = recipe.clone();
        if let (Some(camera), Some(map)) = (self.camera, recipe.maps.first().cloned()) {
            let site = site(simulator, &map, camera)?;
            recipe.maps = vec![map.clone()];
            recipe.cameras_per_scene = 1;
            recipe.cameras.insert(map, vec![site]);
        }
        Ok(stream(simulator, &recipe, &self.options, self.progress, self.take)?)
    }
}

/// The camera of a map that has this name.
fn site<S: Simulator>(simulator: &S, map: &str, camera: &str) -> Result<CameraSite> {
    let sites = simulator.cameras(map).map_err(|error: SimulatorError| RecipeError::from(error))?;
    let known = || sites.iter().map(|site| site.name.as_str()).collect::<Vec<_>>().join(", ");
    match sites.iter().find(|site| site.name == camera) {
        Some(site) => Ok(site.clone()),
        None => Err(UsageError(format!("{map} has no camera '{camera}': use one of {}", known())).into()),
    }
}
