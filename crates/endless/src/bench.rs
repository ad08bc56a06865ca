//! `endless bench`: the whole pipeline on a fixed recipe, or under all conditions.

use crate::args::BenchArgs;
use crate::build_info::this_build;
use anyhow::{Context, Result};
use endless_dataset::{DatasetLayout, RecipeDraft};
use endless_pipeline::{GenerateOptions, Generated, MapSource, SilentProgress, Simulator, generate, resolve_recipe};
use endless_world::{TimeOfDay, Weather};
use std::{
    fs::{self, File},
    io::Write,
    path::Path,
    process::ExitCode,
    time::Duration,
};

/// What the names of the bench's datasets begin with; the number of its process follows.
const FOLDER: &str = ".endless-bench-";

pub(crate) fn run<S: Simulator + MapSource>(simulator: &S, args: &BenchArgs, threads: usize) -> Result<ExitCode> {
    if args.conditions {
        return conditions(simulator, args, threads);
    }
    let asked = |list: &Option<Vec<String>>, default: &str| list.clone().or_else(|| Some(vec![default.into()]));
    let draft = RecipeDraft {
        weathers: asked(&args.weathers, "clear_sky"),
        times: asked(&args.times, "afternoon"),
        ..draft(args)
    };
    print(&film(simulator, draft, threads)?, threads)?;
    Ok(ExitCode::SUCCESS)
}

/// What all benches have in common.
fn draft(args: &BenchArgs) -> RecipeDraft {
    RecipeDraft {
        videos: Some(1),
        size: Some(args.size.clone()),
        duration: Some(args.duration),
        maps: args.maps.clone(),
        cameras_per_scene: args.cameras_per_scene,
        ..RecipeDraft::default()
    }
}

/// Makes a dataset, and leaves nothing of it.
fn film<S: Simulator + MapSource>(simulator: &S, draft: RecipeDraft, threads: usize) -> Result<Generated> {
    let recipe = resolve_recipe(draft, simulator)?;
    let folder = std::env::current_dir()?;
    remove_leftovers(&folder)?;
    let out = folder.join(format!("{FOLDER}{}", std::process::id()));
    let options = GenerateOptions { build: this_build(), allow_other_build: false, threads, plan_only: false };
    let made = generate(simulator, &recipe, &out, &options, &SilentProgress);
    if out.exists() {
        fs::remove_dir_all(&out).context("cannot remove the bench's files")?;
    }
    Ok(made?)
}

/// Removes what benches that were killed left behind: datasets that nobody writes any more.
fn remove_leftovers(folder: &Path) -> Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if !entry.file_name().to_string_lossy().starts_with(FOLDER) {
            continue;
        }
        // One without a lock is just being removed, or never was begun.
        let lock = File::open(DatasetLayout::new(entry.path()).lock());
        if lock.is_ok_and(|lock| lock.try_lock().is_ok()) {
            fs::remove_dir_all(entry.path()).context("cannot remove the files of a bench that was killed")?;
        }
    }
    Ok(())
}

/// A line for each condition, and the rate of all together.
fn conditions<S: Simulator + MapSource>(simulator: &S, args: &BenchArgs, threads: usize) -> Result<ExitCode> {
    let maps = simulator.maps();
    let mut out = std::io::stdout().lock();
    writeln!(out, "weather     time       map        bake s/camera   render ms   camera frames/s")?;
    let (mut frames, mut time) = (0, Duration::ZERO);
    let weathers: Vec<Weather> = parsed(&args.weathers, Weather::ALL)?;
    let times: Vec<TimeOfDay> = parsed(&args.times, TimeOfDay::ALL)?;
    let all = Weather::ALL.iter().flat_map(|w| TimeOfDay::ALL.iter().map(move |t| (w, t)));
    // Each condition keeps its town, whichever others are filmed.
    let films = maps.iter().cycle().zip(all).flat_map(|(own, condition)| {
        let maps = args.maps.as_deref().unwrap_or(std::slice::from_ref(own));
        maps.iter().map(move |map| (map, condition))
    });
    for (map, (weather, hour)) in films {
        if !weathers.contains(weather) || !times.contains(hour) {
            continue;
        }
        let made = film(
            simulator,
            RecipeDraft {
                maps: Some(vec![map.clone()]),
                weathers: Some(vec![weather.to_string()]),
                times: Some(vec![hour.to_string()]),
                ..draft(args)
            },
            threads,
        )?;
        let count = made.camera_frames as f64;
        let cameras = made.plan.scenes.iter().map(|s| s.cameras.len()).sum::<usize>() as f64;
        writeln!(
            out,
            "{:<11} {:<10} {map:<10} {:>13.1} {:>11.1} {:>17.1}",
            weather.to_string(),
            hour.to_string(),
            made.times.bake.as_secs_f64() / cameras,
            made.times.render.as_secs_f64() * 1e3 / count,
            count / made.times.record.as_secs_f64()
        )?;
        frames += made.camera_frames;
        time += made.times.record;
    }
    writeln!(out, "together: {:.1} camera frames/s", frames as f64 / time.as_secs_f64())?;
    Ok(ExitCode::SUCCESS)
}

/// What was asked for, or all.
fn parsed<T: Clone + std::str::FromStr>(asked: &Option<Vec<String>>, all: &[T]) -> Result<Vec<T>, T::Err> {
    asked.as_ref().map_or_else(|| Ok(all.to_vec()), |words| words.iter().map(|word| word.parse()).collect())
}

fn print(made: &Generated, threads: usize) -> Result<()> {
    let mut out = std::io::stdout().lock();
    let t = &made.times;
    let frames = made.camera_frames as f64;
    writeln!(out, "stage            seconds   ms a camera frame")?;
    let once = [("load map", t.load_map), ("load scene", t.load_scene), ("bake (wall)", t.bake)];
    for (name, time) in once {
        writeln!(out, "{name:<14} {:>9.2}", time.as_secs_f64())?;
    }
    let each =
        [("traffic", t.traffic), ("render", t.render), ("images", t.images), ("boxes", t.boxes), ("video", t.video)];
    for (name, time) in each {
        writeln!(out, "{name:<14} {:>9.2}   {:>8.2}", time.as_secs_f64(), time.as_secs_f64() * 1e3 / frames)?;
    }
    let rate = |count: f64, time: Duration| count / time.as_secs_f64().max(1e-9);
    writeln!(out, "recording (wall) {:.2} s on {threads} threads", t.record.as_secs_f64())?;
    writeln!(out, "camera frames    {frames}, {:.1} a second", rate(frames, t.record))?;
    writeln!(out, "bake             {:.1} Mrays/s", rate(t.rays.bake_rays as f64 / 1e6, t.bake))?;
    writeln!(out, "render           {:.1} Mrays/s a thread", rate(t.rays.frame_rays as f64 / 1e6, t.render))?;
    let megabytes = made.bytes as f64 / 1e6;
    writeln!(out, "written          {megabytes:.1} MB, {:.3} MB a camera frame", megabytes / frames)?;
    if let Some(peak) = peak_memory_mb() {
        writeln!(out, "peak memory      {peak:.0} MB")?;
    }
    Ok(())
}

/// As Linux counts it; elsewhere nobody says.
fn peak_memory_mb() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"))?;
    line.split_whitespace().next()?.parse::<f64>().ok().map(|kb| kb / 1024.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_killed_benches_left_goes_and_what_is_being_written_stays() {
        let folder = tempfile::tempdir().expect("temp");
        let bench = |name: &str| {
            let out = folder.path().join(name);
            fs::create_dir(&out).expect("writable");
            fs::write(out.join("dataset.json"), "{}").expect("writable");
            (File::create(out.join(".lock")).expect("writable"), out)
        };
        let ((killed_lock, killed), (lock, running), (_, dear)) =
            (bench(".endless-bench-1"), bench(".endless-bench-2"), bench("thesis"));
        drop(killed_lock);
        lock.try_lock().expect("free");
        remove_leftovers(folder.path()).expect("removable");
        assert!(!killed.exists() && running.exists() && dear.exists());
    }
}
