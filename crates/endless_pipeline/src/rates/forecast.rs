//! What rates say of each video of a plan.

use super::Rates;
use crate::{Plan, Shard, measurements::measurements};
use endless_dataset::VideoLayout;
use endless_world::{TimeOfDay, Weather};
use serde::Serialize;

/// What is expected of one video.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct VideoForecast {
    /// Its number.
    pub video: u32,
    /// Its folder's name.
    pub name: String,
    /// Its map.
    pub map: String,
    /// Its weather.
    pub weather: Weather,
    /// Its time of day.
    pub time_of_day: TimeOfDay,
    /// The number of the shard that makes it, from 1.
    pub shard: u32,
    /// Frames of all its cameras, and measurements of its other sensors.
    pub camera_frames: u64,
    /// Wall time, seconds; the load of its map, too, where it is the first of its shard on that map.
    pub seconds: f64,
    /// Bytes of all its files.
    pub bytes: f64,
}

/// What is expected of a plan, in the order of work.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Forecast {
    /// How many shards.
    pub shards: u32,
    /// Threads of each.
    pub threads: usize,
    /// One a video.
    pub videos: Vec<VideoForecast>,
    /// Of all videos.
    pub camera_frames: u64,
    /// Bytes of all videos.
    pub bytes: f64,
    /// Wall time one after the other, seconds.
    pub seconds: f64,
    /// Wall time of the slowest shard, seconds.
    pub slowest_shard_s: f64,
    /// Threads times wall time, hours.
    pub core_hours: f64,
}

impl Forecast {
    /// What rates say of a plan in so many shards.
    pub fn new(plan: &Plan, rates: &Rates, shards: u32) -> Self {
        let mut videos = Vec::with_capacity(plan.scenes.len());
        let mut slowest_shard_s = 0.0f64;
        for (shard, part) in Shard::all(shards).zip(plan.shards(shards)) {
            let (mut before, mut shard_s) = (None::<&endless_world::SceneSettings>, 0.0);
            for video in part {
                let settings = &plan.scenes[video as usize];
                let load_s = match before.replace(settings).is_some_and(|other| other.shares_town(settings)) {
                    true => 0.0,
                    false => rates.on_map(&settings.map, |sample| sample.load_map_s),
                };
                let camera_frames = measurements(settings);
                let once_s = rates.on_map(&settings.map, |sample| sample.load_scene_s)
                    + rates.like(settings, |sample| sample.bake_s + sample.first_s);
                let seconds = load_s + once_s + camera_frames as f64 * rates.like(settings, |sample| sample.frame_s);
                shard_s += seconds;
                let bytes = camera_frames as f64 * rates.like(settings, |sample| sample.frame_bytes)
                    + rates.on_map(&settings.map, |sample| sample.video_bytes);
                videos.push(VideoForecast {
                    video,
                    name: VideoLayout::name(settings),
                    map: settings.map.clone(),
                    weather: settings.weather,
                    time_of_day: settings.time_of_day,
                    shard: shard.number(),
                    camera_frames,
                    seconds,
                    bytes,
                });
            }
            slowest_shard_s = slowest_shard_s.max(shard_s);
        }
        let seconds = videos.iter().map(|video| video.seconds).sum::<f64>();
        Self {
            shards,
            threads: rates.threads,
            camera_frames: videos.iter().map(|video| video.camera_frames).sum(),
            bytes: videos.iter().map(|video| video.bytes).sum(),
            seconds,
            slowest_shard_s,
            core_hours: seconds * rates.threads as f64 / 3600.0,
            videos,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{RateSample, resolve_recipe, test_catalog::ThreeTowns};
    use endless_dataset::RecipeDraft;

    fn sample(map: &str, time_of_day: TimeOfDay, frame_s: f64) -> RateSample {
        RateSample {
            map: map.to_owned(),
            weather: Weather::ClearSky,
            time_of_day,
            frames: 4,
            measurements: 8,
            load_map_s: 10.0,
            load_scene_s: 1.0,
            bake_s: 3.0,
            first_s: 1.0,
            frame_s,
            frame_bytes: 1000.0,
            video_bytes: 500.0,
        }
    }

    #[test]
    fn videos_take_the_rates_of_their_time_of_day_and_their_map() {
        let draft = RecipeDraft { videos: Some(30), fps: Some(10.0), duration: Some(1.0), ..RecipeDraft::default() };
        let recipe = resolve_recipe(draft, &ThreeTowns).expect("valid");
        let plan = Plan::new(&recipe, &ThreeTowns).expect("plannable");
        let samples = vec![sample("Town01", TimeOfDay::Night, 2.0), sample("Town02", TimeOfDay::Morning, 1.0)];
        let rates = Rates { of: Rates::key(&recipe, 2, "a"), threads: 2, samples };
        assert_eq!(rates.first_difference(&Rates::key(&recipe, 2, "a")), None);
        let other = rates.first_difference(&Rates::key(&recipe, 3, "a")).expect("other threads");
        assert_eq!(other, ("threads".to_owned(), "2".to_owned(), "3".to_owned()));
        let forecast = Forecast::new(&plan, &rates, 3);
        for video in &forecast.videos {
            let frame_s = match video.time_of_day {
                TimeOfDay::Night => 2.0,
                TimeOfDay::Morning => 1.0,
                TimeOfDay::Afternoon => 1.5,
            };
            let without_load = 1.0 + 4.0 + 20.0 * frame_s;
            assert!([without_load, without_load + 10.0].contains(&video.seconds), "{video:?}");
            assert_eq!((video.camera_frames, video.bytes), (20, 20_500.0));
        }
        assert_eq!(forecast.videos.iter().map(|video| video.video).collect::<Vec<_>>(), plan.work_order());
        assert!(forecast.videos.is_sorted_by_key(|video| video.shard));
        assert!((forecast.core_hours - forecast.seconds * 2.0 / 3600.0).abs() < 1e-9);
        assert!(
            forecast.slowest_shard_s < forecast.seconds && forecast.slowest_shard_s > forecast.seconds / 3.0 - 1e-9
        );
    }
}
