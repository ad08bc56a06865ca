//! `endless plan`.

use crate::{
    args::{GenerateArgs, PlanArgs},
    build_info::this_build,
    file,
    generate::{WithSimulator, with_simulator},
    recipe_args::RecipeArgs,
    report::Reporter,
};
use anyhow::{Context, Result, bail};
use bytesize::ByteSize;
use endless_dataset::{Recipe, RecipeDraft, read_json};
use endless_interchange::MapLibrary;
use endless_pipeline::{
    Forecast, MapSource, Plan, Progress, RateOptions, RateSample, Rates, Simulator, human_bytes, measure_rates,
};
use serde::Serialize;
use std::{io::Write, process::ExitCode};

pub(crate) fn run(library: MapLibrary, mut args: PlanArgs, threads: usize) -> Result<ExitCode> {
    let draft = std::mem::take(&mut args.recipe.draft);
    let reporter = Reporter::new();
    let source = source(&mut args);
    let made = with_simulator(library, draft, &source, None, Estimate { args: &args, threads, progress: &reporter });
    reporter.finish();
    let estimated = made?;
    print(&estimated)?;
    if let Some(path) = &args.json {
        file::write(path, &json(&estimated)?)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// The same recipe as one that is to be made.
fn source(args: &mut PlanArgs) -> GenerateArgs {
    let RecipeArgs { cameras, rig, .. } = &mut args.recipe;
    let recipe = RecipeArgs { draft: RecipeDraft::default(), cameras: cameras.take(), rig: rig.take() };
    GenerateArgs {
        out: std::path::PathBuf::new(),
        recipe,
        config: args.config.take(),
        memory: ByteSize::gib(1),
        cache: None,
        traffic_manager: None,
        frame_timeout: 30.0,
        reconnect_timeout: 120.0,
        plan_only: false,
        shard: None,
        allow_other_build: false,
        work_dir: None,
    }
}

/// What a plan is expected to take, and what says so.
#[derive(Debug, Serialize)]
struct Estimated {
    #[serde(flatten)]
    forecast: Forecast,
    rates: Rates,
}

struct Estimate<'a> {
    args: &'a PlanArgs,
    threads: usize,
    progress: &'a dyn Progress,
}

impl WithSimulator for Estimate<'_> {
    type Made = Estimated;

    fn run<S: Simulator + MapSource>(self, simulator: &S, recipe: &Recipe) -> Result<Estimated> {
        let plan = Plan::new(recipe, simulator)?;
        let rates = match &self.args.rates {
            Some(path) if path.exists() => {
                let rates: Rates = read_json(path)?;
                let key = Rates::key(recipe, self.threads, &this_build().sources);
                if let Some((what, theirs, mine)) = rates.first_difference(&key) {
                    bail!(
                        "these rates were measured for something else ({what} is {theirs} there, {mine} here): delete \
                         them or name another file: {}",
                        path.display()
                    );
                }
                rates
            }
            kept => {
                let rates = self.measure(simulator, recipe, &plan)?;
                if let Some(path) = kept {
                    file::write(path, &json(&rates)?)?;
                }
                rates
            }
        };
        Ok(Estimated { forecast: Forecast::new(&plan, &rates, self.args.shards), rates })
    }
}

impl Estimate<'_> {
    fn measure<S: Simulator>(&self, simulator: &S, recipe: &Recipe, plan: &Plan) -> Result<Rates> {
        let options = RateOptions {
            videos: self.args.samples as usize,
            frames: self.args.frames,
            threads: self.threads,
            folder: std::env::current_dir().context("there is no current folder")?,
            build: this_build(),
        };
        Ok(measure_rates(simulator, recipe, plan, &options, self.progress)?)
    }
}

fn json<T: Serialize>(value: &T) -> Result<Vec<u8>> {
    let mut text = serde_json::to_vec_pretty(value)?;
    text.push(b'\n');
    Ok(text)
}

fn print(estimated: &Estimated) -> Result<()> {
    let Estimated { forecast, rates } = estimated;
    let mut out = std::io::stdout().lock();
    writeln!(out, "measured on {} threads: seconds, and bytes a camera frame", rates.threads)?;
    writeln!(out, "  load map  scene   bake   frame      bytes  of")?;
    for sample in &rates.samples {
        let RateSample { load_map_s, load_scene_s, bake_s, frame_s, frame_bytes, .. } = sample;
        let of = format!("{} {} {}, {} frames", sample.map, sample.weather, sample.time_of_day, sample.frames);
        writeln!(
            out,
            "  {load_map_s:>8.2} {load_scene_s:>6.2} {bake_s:>6.2} {frame_s:>7.3} {:>10}  {of}",
            human_bytes(*frame_bytes as u64)
        )?;
    }
    for video in &forecast.videos {
        let shard =
            if forecast.shards > 1 { format!(" {:>4}/{}", video.shard, forecast.shards) } else { String::new() };
        writeln!(
            out,
            "{:<44}{shard} {:>9} {:>10}",
            video.name,
            human_seconds(video.seconds),
            human_bytes(video.bytes as u64)
        )?;
    }
    let (time, bytes) = (human_seconds(forecast.seconds), human_bytes(forecast.bytes as u64));
    writeln!(
        out,
        "all: {} videos, {} camera frames, {bytes}, {time} on {} threads, {:.2} core-hours",
        forecast.videos.len(),
        forecast.camera_frames,
        forecast.threads,
        forecast.core_hours
    )?;
    if forecast.shards > 1 {
        writeln!(out, "in {} shards at once: {}", forecast.shards, human_seconds(forecast.slowest_shard_s))?;
    }
    Ok(())
}

/// A time for people to read, such as `2 h 05 min`.
fn human_seconds(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    match whole {
        0..=99 => format!("{seconds:.1} s"),
        100..=5999 => format!("{} min {:02} s", whole / 60, whole % 60),
        _ => format!("{} h {:02} min", whole / 3600, whole % 3600 / 60),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_as_fine_as_people_want_them() {
        let said = [0.04, 61.0, 125.0, 7261.0, 400_000.0].map(human_seconds);
        assert_eq!(said, ["0.0 s", "61.0 s", "2 min 05 s", "2 h 01 min", "111 h 06 min"]);
    }
}
