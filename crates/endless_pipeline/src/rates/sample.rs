//! What was measured.

use endless_dataset::Recipe;
use endless_world::{SceneSettings, TimeOfDay, Weather};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

/// Options of a recipe that say which videos there are, and how long: rates are kept by map, weather and time of day, and told a frame.
const THAT_MAY_DIFFER: &[&str] = &["videos", "maps", "weathers", "times", "balance", "duration", "seed"];

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
    /// What the first frames take beyond that of later ones, seconds.
    pub first_s: f64,
    /// A measurement of one camera or sensor, seconds: the mean of all, the first frames left out.
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
    /// What rates of a recipe are measured for: threads, the build's sources, and all options but those in
    /// `THAT_MAY_DIFFER`.
    pub fn key(recipe: &Recipe, threads: usize, sources: &str) -> BTreeMap<String, String> {
        let options = match serde_json::to_value(recipe) {
            Ok(Value::Object(options)) => options,
            _ => serde_json::Map::new(),
        };
        let of_recipe = options.into_iter().filter(|(name, _)| !THAT_MAY_DIFFER.contains(&name.as_str()));
        let text = |value: Value| value.as_str().map_or_else(|| value.to_string(), ToOwned::to_owned);
        let of_machine = [("threads".to_owned(), threads.to_string()), ("sources".to_owned(), sources.to_owned())];
        of_recipe.map(|(name, value)| (name, text(value))).chain(of_machine).collect()
    }

    /// The first thing in which these rates are not those of a key: its name, here and there.
    pub fn first_difference(&self, key: &BTreeMap<String, String>) -> Option<(String, String, String)> {
        let value = |of: &BTreeMap<String, String>, name: &String| of.get(name).cloned().unwrap_or_default();
        let names: BTreeSet<&String> = key.keys().chain(self.of.keys()).collect();
        let mut all = names.into_iter().map(|name| (name.clone(), value(&self.of, name), value(key, name)));
        all.find(|(_, own, wanted)| own != wanted)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{resolve_recipe, test_catalog::ThreeTowns};
    use endless_dataset::RecipeDraft;

    #[test]
    fn rates_of_another_look_are_not_taken() {
        let of = |draft: RecipeDraft| Rates::key(&resolve_recipe(draft, &ThreeTowns).expect("valid"), 2, "a");
        let rates = Rates { of: of(RecipeDraft::default()), threads: 2, samples: Vec::new() };
        let more = RecipeDraft { videos: Some(900), seed: Some(5), duration: Some(60.0), ..RecipeDraft::default() };
        assert_eq!(rates.first_difference(&of(more)), None);
        let different = |draft: RecipeDraft| rates.first_difference(&of(draft)).map(|(name, ..)| name);
        let look = RecipeDraft { camera_look: Some("cctv".parse().expect("a look")), ..RecipeDraft::default() };
        assert_eq!(different(look).as_deref(), Some("camera_look"));
        assert_eq!(different(RecipeDraft { focus: Some(0.0), ..RecipeDraft::default() }).as_deref(), Some("focus"));
    }
}
