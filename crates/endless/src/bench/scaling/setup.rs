//! The scene in which one thing grows.

use super::scene_timer::SceneTimer;
use crate::args::BenchArgs;
use crate::bench::film::draft;
use anyhow::{Context, Result};
use endless_dataset::RecipeDraft;
use endless_pipeline::{BuiltinSimulator, MapSource, Plan, resolve_recipe};
use endless_world::SceneSettings;

/// Small: most of what grows costs as many times as much in small pictures.
const SIZE: &str = "640x360";
/// Seconds of video a row.
const DURATION_S: f64 = 0.5;

/// What all series have in common.
pub(super) struct ScalingSetup<'a> {
    pub(super) simulator: &'a BuiltinSimulator,
    pub(super) timer: SceneTimer<'a>,
    pub(super) threads: usize,
    args: &'a BenchArgs,
}

impl<'a> ScalingSetup<'a> {
    pub(super) fn new(simulator: &'a BuiltinSimulator, args: &'a BenchArgs, threads: usize) -> Result<Self> {
        Ok(Self { simulator, timer: SceneTimer::new(simulator, threads)?, threads, args })
    }

    /// The town of all series but the one that compares towns: the first that was asked for.
    pub(super) fn map(&self) -> String {
        self.maps().swap_remove(0)
    }

    /// The towns that are compared.
    pub(super) fn maps(&self) -> Vec<String> {
        self.args.maps.clone().filter(|maps| !maps.is_empty()).unwrap_or_else(|| self.simulator.maps())
    }

    /// The size that was asked for.
    pub(super) fn asked_size(&self) -> Option<&str> {
        self.args.size.as_deref()
    }

    /// The seconds of video that were asked for.
    pub(super) fn asked_duration(&self) -> Option<f64> {
        self.args.duration
    }

    /// What each scene is made of but for what grows.
    pub(super) fn draft(&self) -> RecipeDraft {
        let one = |asked: &Option<Vec<String>>, otherwise: &str| {
            Some(vec![asked.as_ref().and_then(|words| words.first()).map_or(otherwise, String::as_str).to_owned()])
        };
        RecipeDraft {
            maps: Some(vec![self.map()]),
            size: Some(self.asked_size().unwrap_or(SIZE).to_owned()),
            duration: Some(self.asked_duration().unwrap_or(DURATION_S)),
            weathers: one(&self.args.weathers, "clear_sky"),
            times: one(&self.args.times, "afternoon"),
            ..draft(self.args)
        }
    }

    /// The one scene of a draft.
    pub(super) fn scene(&self, draft: RecipeDraft) -> Result<SceneSettings> {
        let recipe = resolve_recipe(draft, self.simulator)?;
        let mut plan = Plan::new(&recipe, self.simulator)?;
        plan.scenes.pop().context("a plan of one video has one scene")
    }

    /// What all scenes have in common but for what a table says.
    pub(super) fn summary(&self) -> Result<String> {
        let settings = self.scene(self.draft())?;
        let SceneSettings { map, weather, time_of_day, cameras, vehicles, pedestrians, size, frames, .. } = &settings;
        Ok(format!(
            "{map}, {weather} {time_of_day}, {} cameras of {size}, {vehicles} vehicles, {pedestrians} people, {frames} \
             frames, {} threads, where nothing else is said",
            cameras.len(),
            self.threads
        ))
    }
}
