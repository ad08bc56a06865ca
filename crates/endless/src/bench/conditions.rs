//! `endless bench --conditions`: weathers and times of day compared.

use super::film::{draft, film};
use crate::args::BenchArgs;
use anyhow::Result;
use endless_dataset::RecipeDraft;
use endless_pipeline::{MapSource, Simulator};
use endless_world::{TimeOfDay, Weather};
use std::{io::Write, process::ExitCode, time::Duration};

/// A line for each condition, and the rate of all together.
pub(super) fn run<S: Simulator + MapSource>(simulator: &S, args: &BenchArgs, threads: usize) -> Result<ExitCode> {
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
