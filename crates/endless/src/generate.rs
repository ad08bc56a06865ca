//! `endless generate`.

use crate::{args::GenerateArgs, assets, build_info::this_build, exit::INTERRUPTED, report::Reporter};
use anyhow::Result;
use endless_carla::client::{Address, CarlaSettings, CarlaSimulator, StopFlag};
use endless_dataset::RecipeDraft;
use endless_interchange::{MapLibrary, TrackFile};
use endless_pipeline::{
    BakeCache, BuiltinSimulator, GenerateOptions, Generated, MapSource, Plan, RecipeError, Shard, Simulator, generate,
    read_cameras, read_recipe, read_rig, resolve_recipe,
};
use std::{io::Write, process::ExitCode, time::Duration};

/// The simulator that is used if none is named.
const BUILTIN: &str = "builtin";

pub(crate) fn run(library: MapLibrary, mut args: GenerateArgs, threads: usize) -> Result<ExitCode> {
    let file = args.config.as_deref().map(read_recipe).transpose()?.unwrap_or_default();
    let cameras = args.recipe.cameras.as_deref().map(read_cameras).transpose()?;
    let sensor = args.recipe.rig.as_deref().map(read_rig).transpose()?;
    let draft = RecipeDraft { cameras, sensor, ..std::mem::take(&mut args.recipe.draft) }.or(file);
    let library = assets::with_folder(library, draft.assets.as_deref(), draft.skip_broken.unwrap_or(false))?;
    match draft.simulator.as_deref().unwrap_or(BUILTIN) {
        BUILTIN => {
            let mut simulator = BuiltinSimulator::new(library).with_bake_cache(bake_cache(&args)?);
            if let Some(path) = &draft.traffic {
                simulator = simulator.with_tracks(TrackFile::read(path).map_err(RecipeError::from)?);
            }
            run_with(&simulator, draft, &args, threads)
        }
        other => match Address::of_simulator(other) {
            Some(address) => {
                let address = address.map_err(|problem| RecipeError::Simulator { problem })?;
                let simulator = CarlaSimulator::connect(carla_settings(address, &draft, &args)?)?;
                // Where it is says nothing of what is made.
                let draft = RecipeDraft { simulator: Some("carla".to_owned()), ..draft };
                run_with(&simulator, draft, &args, threads)
            }
            None => {
                let known = vec![BUILTIN, "carla://HOST:PORT"];
                Err(RecipeError::UnknownSimulator { given: other.to_owned(), known }.into())
            }
        },
    }
}

/// Settings of a connection. Ctrl-C and a request to end let it clean up on the server.
fn carla_settings(address: Address, draft: &RecipeDraft, args: &GenerateArgs) -> Result<CarlaSettings> {
    let stop = StopFlag::default();
    let flag = stop.clone();
    ctrlc::set_handler(move || {
        // Whoever asks twice does not want to wait for that.
        if flag.is_set() {
            std::process::exit(INTERRUPTED.into());
        }
        flag.stop();
    })?;
    Ok(CarlaSettings {
        address,
        traffic_manager: args.traffic_manager.clone(),
        frame_limit: Duration::from_secs_f64(args.frame_timeout),
        reconnect_limit: Duration::from_secs_f64(args.reconnect_timeout),
        finds_sites: draft.cameras.is_none(),
        stop,
    })
}

/// What is kept of bakes. A plan alone bakes nothing.
fn bake_cache(args: &GenerateArgs) -> Result<BakeCache> {
    let in_memory = BakeCache::in_memory(usize::try_from(args.memory.as_u64()).unwrap_or(usize::MAX));
    match &args.cache {
        Some(folder) if !args.plan_only => Ok(in_memory.in_folder(folder, this_build().sources)?),
        _ => Ok(in_memory),
    }
}

fn run_with<S: Simulator + MapSource>(
    simulator: &S,
    draft: RecipeDraft,
    args: &GenerateArgs,
    threads: usize,
) -> Result<ExitCode> {
    let recipe = resolve_recipe(draft, simulator)?;
    for note in simulator.track_notes(&recipe).map_err(RecipeError::from)? {
        eprintln!("warning: {note}");
    }
    let options = GenerateOptions {
        build: this_build(),
        allow_other_build: args.allow_other_build,
        threads,
        plan_only: args.plan_only,
        shard: args.shard,
    };
    let reporter = Reporter::new();
    let made = generate(simulator, &recipe, &args.out, &options, &reporter);
    reporter.finish();
    let made = made?;
    if args.plan_only {
        print_order(&made.plan, args.shard)?;
    } else {
        eprintln!("{}", summary(&made, args.shard));
    }
    Ok(ExitCode::SUCCESS)
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
