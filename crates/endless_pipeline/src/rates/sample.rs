//! What was measured.

use endless_dataset::{Layer, Recipe};
use endless_world::{SceneSettings, TimeOfDay, Weather};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What a few frames of one video took.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RateSample {
    /// Its map.
    pub map: String,
    /// Its weather.
    pub weather: Weather,
    /// Its time of day.
    pub time_of_day: TimeOfDay,
    /// Frames that were recorded.
    pub frames: u32,
    /// Measurements of all cameras and sensors in these.
    pub measurements: u64,
    /// Loading the map, seconds.
    pub load_map_s: f64,
    /// Populating the scene, seconds.
    pub load_scene_s: f64,
    /// Baking, seconds for all cameras.
    pub bake_s: f64,
    /// A measurement of one camera or sensor, seconds: the mean of all.
    pub frame_s: f64,
    /// Bytes of a measurement, images and lines of labels.
    pub frame_bytes: f64,
    /// Bytes of the files that a video has once.
    pub video_bytes: f64,
}

/// Rates of a machine, and what they hold for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Rates {
    /// Whatever decides them besides map, weather and time of day: threads, size, layers, sensors and the like.
    pub of: BTreeMap<String, String>,
    /// Threads that worked.
    pub threads: usize,
    /// One a video that was tried.
    pub samples: Vec<RateSample>,
}

impl Rates {
    /// What rates of a recipe are measured for.
    pub fn key(recipe: &Recipe, threads: usize, sources: &str) -> BTreeMap<String, String> {
        let layers = |layers: &[Layer]| layers.iter().map(ToString::to_string).collect::<Vec<_>>().join(",");
        let size = recipe.size;
        let entries = [
            ("threads", threads.to_string()),
            ("sources", sources.to_owned()),
            ("size", format!("{}x{}", size.width, size.height)),
            ("cameras_per_scene", recipe.cameras_per_scene.to_string()),
            ("sensors", recipe.sensor.len().to_string()),
            ("layers", layers(&recipe.layers)),
            ("mp4", layers(&recipe.mp4)),
            ("rgb_format", recipe.rgb_format.to_string()),
            ("amodal_masks", recipe.amodal_masks.to_string()),
            ("vehicles", recipe.vehicles.to_string()),
            ("pedestrians", recipe.pedestrians.to_string()),
        ];
        entries.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
    }

    /// The first thing in which these rates are not those of a key: its name, here and there.
    pub fn first_difference(&self, key: &BTreeMap<String, String>) -> Option<(String, String, String)> {
        let nothing = String::new();
        key.iter().find_map(|(name, wanted)| {
            let own = self.of.get(name).unwrap_or(&nothing);
            (own != wanted).then(|| (name.clone(), own.clone(), wanted.clone()))
        })
    }

    /// The mean of a rate over the samples that are most like a video: of its weather and time of day, else of its time of
    /// day, else all.
    pub(super) fn like(&self, settings: &SceneSettings, rate: impl Fn(&RateSample) -> f64) -> f64 {
        let time = |sample: &&RateSample| sample.time_of_day == settings.time_of_day;
        let both = |sample: &&RateSample| time(sample) && sample.weather == settings.weather;
        let mean = |of: &dyn Fn(&&RateSample) -> bool| mean(self.samples.iter().filter(of).map(&rate));
        mean(&both).or_else(|| mean(&time)).or_else(|| mean(&|_| true)).unwrap_or(0.0)
    }

    /// The same over the samples of its map, else over all.
    pub(super) fn on_map(&self, map: &str, rate: impl Fn(&RateSample) -> f64) -> f64 {
        let own = mean(self.samples.iter().filter(|sample| sample.map == map).map(&rate));
        own.or_else(|| mean(self.samples.iter().map(&rate))).unwrap_or(0.0)
    }
}

fn mean(values: impl Iterator<Item = f64>) -> Option<f64> {
    let (sum, count) = values.fold((0.0, 0u32), |(sum, count), value| (sum + value, count + 1));
    (count > 0).then(|| sum / f64::from(count))
}
