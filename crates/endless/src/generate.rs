//! `endless generate`.

use crate::{args::GenerateArgs, assets, build_info::this_build, exit::INTERRUPTED, report::Reporter, storage};
use anyhow::Result;
use endless_carla::client::{Address, CarlaSettings, CarlaSimulator, StopFlag};
use endless_dataset::{Recipe, RecipeDraft};
use endless_interchange::{MapLibrary, TrackFile};
use endless_pipeline::{
    BakeCache, BuiltinSimulator, GenerateOptions, Generated, MapSource, Plan, Progress, RecipeError, Shard, Simulator,
    generate, read_cameras, read_recipe, read_rig, resolve_recipe,
};
use endless_storage::DatasetAddress;
use std::{io::Write, process::ExitCode, time::Duration};

/// The simulator that is used if none is named.
const BUILTIN: &str = "builtin";

pub(crate) fn run(library: MapLibrary, mut args: GenerateArgs, threads: usize) -> Result<ExitCode> {
    let reporter = Reporter::new();
    let draft = std::mem::take(&mut args.recipe.draft);
    let made = with_simulator(library, draft, &args, None, Record { args: &args, threads, progress: &reporter });
    reporter.finish();
    let made = made?;
    if args.plan_only {
        print_order(&made.plan, args.shard)?;
    } else {
        eprintln!("{}", summary(&made, args.shard));
    }
    Ok(ExitCode::SUCCESS)
}

/// What is done with a recipe and the simulator that it names.
pub(crate) trait WithSimulator {
    /// What comes of it.
    type Made;

    fn run<S: Simulator + MapSource>(self, simulator: &S, recipe: &Recipe) -> Result<Self::Made>;
}

/// Records a dataset.
pub(crate) struct Record<'a> {
    pub(crate) args: &'a GenerateArgs,
    pub(crate) threads: usize,
    pub(crate) progress: &'a dyn Progress,
}

impl WithSimulator for Record<'_> {
    type Made = Generated;

    fn run<S: Simulator + MapSource>(self, simulator: &S, recipe: &Recipe) -> Result<Generated> {
        let Self { args, threads, progress } = self;
        let options = GenerateOptions {
            build: this_build(),
            allow_other_build: args.allow_other_build,
            threads,
            plan_only: args.plan_only,
            shard: args.shard,
        };
        match storage::address(&args.out)? {
            DatasetAddress::Folder(folder) => Ok(generate(simulator, recipe, &folder, &options, progress)?),
            DatasetAddress::Storage(address) => {
                storage::generate_there(simulator, recipe, &address, args, &options, progress)
            }
        }
    }
}

/// Resolves the recipe of a draft and of the files that the arguments name, for the simulator that it names. Who has no
/// `stop` of their own is stopped by Ctrl-C.
pub(crate) fn with_simulator<W: WithSimulator>(
    library: MapLibrary,
    draft: RecipeDraft,
    args: &GenerateArgs,
    stop: Option<StopFlag>,
    work: W,
) -> Result<W::Made> {
    let file = args.config.as_deref().map(read_recipe).transpose()?.unwrap_or_default();
    let cameras = args.recipe.cameras.as_deref().map(read_cameras).transpose()?;
    let sensor = args.recipe.rig.as_deref().map(read_rig).transpose()?;
    let draft = RecipeDraft { cameras, sensor, ..RecipeDraft::default() }.or(draft).or(file);
    let library = assets::with_folder(library, draft.assets.as_deref(), draft.skip_broken.unwrap_or(false))?;
    match draft.simulator.as_deref().unwrap_or(BUILTIN) {
        BUILTIN => {
            let mut simulator = BuiltinSimulator::new(library).with_bake_cache(bake_cache(args)?);
            if let Some(path) = &draft.traffic {
                simulator = simulator.with_tracks(TrackFile::read(path).map_err(RecipeError::from)?);
            }
            work.run(&simulator, &recipe(draft, &simulator)?)
        }
        other => match Address::of_simulator(other) {
            Some(address) => {
                let address = address.map_err(|problem| RecipeError::Simulator { problem })?;
                let stop = stop.map_or_else(stop_at_ctrl_c, Ok)?;
                let simulator = CarlaSimulator::connect(carla_settings(address, &draft, args, stop))?;
                // Where it is says nothing of what is made.
                let draft = RecipeDraft { simulator: Some("carla".to_owned()), ..draft };
                work.run(&simulator, &recipe(draft, &simulator)?)
            }
            None => {
                let known = vec![BUILTIN, "carla://HOST:PORT"];
                Err(RecipeError::UnknownSimulator { given: other.to_owned(), known }.into())
            }
        },
    }
}

/// The resolved recipe; warns of tracks that do not fit it.
fn recipe<S: MapSource>(draft: RecipeDraft, simulator: &S) -> Result<Recipe> {
    let recipe = resolve_recipe(draft, simulator)?;
    for note in simulator.track_notes(&recipe).map_err(RecipeError::from)? {
        eprintln!("warning: {note}");
    }
    Ok(recipe)
}

/// Ctrl-C and a request to end let a simulator elsewhere be cleaned up.
fn stop_at_ctrl_c() -> Result<StopFlag> {
    let stop = StopFlag::default();
    let flag = stop.clone();
    ctrlc::set_handler(move || {
        // Whoever asks twice does not want to wait for that.
        if flag.is_set() {
            std::process::exit(INTERRUPTED.into());
        }
        flag.stop();
    })?;
    Ok(stop)
}

/// Settings of a connection.
fn carla_settings(address: Address, draft: &RecipeDraft, args: &GenerateArgs, stop: StopFlag) -> CarlaSettings {
    CarlaSettings {
        address,
        traffic_manager: args.traffic_manager.clone(),
        frame_limit: Duration::from_secs_f64(args.frame_timeout),
        reconnect_limit: Duration::from_secs_f64(args.reconnect_timeout),
        finds_sites: draft.cameras.is_none(),
        stop,
    }
}

/// What is kept of bakes. A plan alone bakes nothing.
fn bake_cache(args: &GenerateArgs) -> Result<BakeCache> {
    let in_memory = BakeCache::in_memory(usize::try_from(args.memory.as_u64()).unwrap_or(usize::MAX));
    match &args.cache {
        Some(folder) if !args.plan_only => Ok(in_memory.in_folder(folder, this_build().sources)?),
        _ => Ok(in_memory),
    }
}

fn print_order(plan: &Plan, shard: Option<Shard>) -> Result<()> {
    let mut out = std::io::stdout().lock();
    for video in plan.part(shard) {
        let s = &plan.scenes[video as usize];
        let cameras: Vec<&str> = s.cameras.iter().map(|c| c.site.name.as_str()).collect();
        writeln!(out, "{video:04} {} {} {} {}", s.map, s.weather, s.time_of_day, cameras.join("+"))?;
    }
    Ok(())
}

fn summary(made: &Generated, shard: Option<Shard>) -> String {
    match shard {
        Some(shard) if made.plan.part(Some(shard)).is_empty() => {
            return format!("nothing to do: shard {shard} has no videos, the others make them as fast");
        }
        Some(shard) if made.videos == 0 => return format!("nothing to do: shard {shard} is complete"),
        None if made.videos == 0 => return "nothing to do: the dataset is complete".into(),
        _ => {}
    }
    let recording = made.times.record.as_secs_f64().max(1e-9);
    let megabytes = made.bytes as f64 / 1e6;
    let frames = made.camera_frames as f64;
    format!(
        "done: {} videos, {} camera frames, {megabytes:.1} MB ({:.3} MB a camera frame) in {:.1} s ({:.1} camera frames a \
         second while recording)",
        made.videos,
        made.camera_frames,
        megabytes / frames,
        made.seconds,
        frames / recording
    )
}
