//! The weather of every instant of a video, also of one in which it changes.

use crate::condition_mix::{by_elevation, mixed};
use crate::math::lerp;
use crate::sun_path::SunPath;
use crate::{Condition, ConditionChange, DrawnSun, LightVariation, SceneSettings, SceneWeather, Stream, TimeOfDay};

/// Below this the sun's elevation is called night, degrees.
const NIGHTFALL_DEG: f32 = -3.0;
/// Above this it is called afternoon, degrees.
const HIGH_SUN_DEG: f32 = 30.0;
/// Intervals between key frames of a change of the time of day: shadows move by two or three degrees in each.
const TIME_KEYS: u32 = 20;
/// Intervals between key frames of a change of weather.
const WEATHER_KEYS: u32 = 12;

/// The weather of every instant of a video.
#[derive(Debug, Clone, Copy)]
pub struct WeatherTimeline {
    begin: SceneWeather,
    change: Option<Change>,
    /// Laid over every instant.
    light: Option<LightVariation>,
    frames: u32,
}

#[derive(Debug, Clone, Copy)]
struct Change {
    /// The weather, if the sun were where it is at that time.
    end: SceneWeather,
    sun: SunPath,
}

impl WeatherTimeline {
    /// Of a scene.
    pub fn of(settings: &SceneSettings) -> Self {
        let SceneSettings { weather, time_of_day, seed, frames, changing_to, .. } = *settings;
        let (begin, drawn_sun) = (SceneWeather::of_scene(settings), DrawnSun::of(settings));
        let differs = |to: &ConditionChange| (to.weather, to.time_of_day) != (weather, time_of_day);
        let change = changing_to.filter(|to| frames > 1 && differs(to));
        let change = change.map(|to| Change::new(&begin, to, drawn_sun.as_ref(), seed));
        let light = settings.randomised.as_ref().and_then(|randomised| randomised.light);
        // Lamps and the colour of the light follow a sun that moves or is drawn: raising it would leave them behind.
        let sun_as_high = drawn_sun.is_some() || change.as_ref().is_some_and(|change| change.sun.moves());
        let light = light.map(|light| if sun_as_high { light.with_sun_as_high() } else { light });
        Self { begin, change, light, frames }
    }

    /// Of a frame.
    pub fn at_frame(&self, frame: u32) -> SceneWeather {
        let last = self.frames.saturating_sub(1).max(1);
        self.at(frame.min(last) as f32 / last as f32)
    }

    /// Of a key frame, of [`Self::intervals`] and one.
    pub fn at_key(&self, key: u32) -> SceneWeather {
        let intervals = self.intervals();
        self.at(if intervals == 0 { 0.0 } else { key as f32 / intervals as f32 })
    }

    /// How many intervals key frames divide the video into; none where nothing changes.
    pub fn intervals(&self) -> u32 {
        let Some(Change { end, sun }) = &self.change else { return 0 };
        let by_sun = if sun.moves() { TIME_KEYS } else { 0 };
        let by_weather = if end.weather == self.begin.weather { 0 } else { WEATHER_KEYS };
        by_sun.max(by_weather).min(self.frames.saturating_sub(1))
    }

    /// The key frame at or before a frame, and how far the frame is from there towards the next, 0 to below 1.
    pub fn place(&self, frame: u32) -> (u32, f32) {
        let (intervals, last) = (u64::from(self.intervals()), u64::from(self.frames.saturating_sub(1).max(1)));
        let along = u64::from(frame).min(last) * intervals;
        ((along / last) as u32, (along % last) as f32 / last as f32)
    }

    /// At a share of the way, 0 to 1.
    fn at(&self, share: f32) -> SceneWeather {
        let usual = self.usual(share);
        self.light.map_or(usual, |light| usual.varied(&light))
    }

    /// The same in the light that nothing varies.
    fn usual(&self, share: f32) -> SceneWeather {
        let Some(Change { end, sun }) = &self.change else { return self.begin };
        let [azimuth, elevation] = sun.at(share);
        let [of_begin, of_end] = [&self.begin, end].map(|scene| {
            let condition = if sun.moves() { by_elevation(scene.weather, elevation) } else { **scene };
            let values = [azimuth, elevation, scene.visibility_m, scene.scale_height_m];
            condition.with_values(values)
        });
        let mixed = mixed(&of_begin, &of_end, share);
        let cloudiness = lerp(self.begin.cloudiness, end.cloudiness, mixed.sky);
        let time_of_day = name_of(elevation, [self.begin.time_of_day, end.time_of_day]);
        SceneWeather::of(Condition { time_of_day, ..mixed.condition }, self.begin.cloud_seed)
            .with_cloudiness(cloudiness)
    }
}

/// The one of two times of day that fits the sun's elevation, degrees.
fn name_of(elevation: f32, [from, to]: [TimeOfDay; 2]) -> TimeOfDay {
    match (from, to) {
        (TimeOfDay::Night, TimeOfDay::Night) => TimeOfDay::Night,
        (day, TimeOfDay::Night) | (TimeOfDay::Night, day) if elevation > NIGHTFALL_DEG => day,
        (_, TimeOfDay::Night) | (TimeOfDay::Night, _) => TimeOfDay::Night,
        _ if from == to => from,
        _ if elevation > HIGH_SUN_DEG => TimeOfDay::Afternoon,
        _ => TimeOfDay::Morning,
    }
}

impl Change {
    fn new(begin: &SceneWeather, to: ConditionChange, drawn_sun: Option<&DrawnSun>, seed: u64) -> Self {
        let drawn = SceneWeather::new(to.weather, to.time_of_day, Stream::named(seed, "change", &[]).next_u64());
        let drawn = drawn_sun.map_or(drawn, |sun| drawn.with_sun_as_high_as(sun));
        // The air of one weather stays as it is.
        let values = |own: &SceneWeather| {
            let air = if to.weather == begin.weather { begin } else { own };
            [own.sun_azimuth_deg, own.sun_elevation_deg, air.visibility_m, air.scale_height_m]
        };
        let end = SceneWeather::of(drawn.with_values(values(&drawn)), begin.cloud_seed);
        let ends = [begin, &end];
        let sun = SunPath::new(
            ends.map(|scene| scene.time_of_day),
            ends.map(|scene| [scene.sun_azimuth_deg, scene.sun_elevation_deg]),
        );
        Self { end, sun }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ActorDensity, ImageSize, RandomisedPart, SceneRandomisation, TrafficProfile, Weather};
    use proptest::prelude::*;

    fn settings(from: ConditionChange, to: Option<ConditionChange>, frames: u32, seed: u64) -> SceneSettings {
        SceneSettings {
            video: 0,
            map: "Town01".into(),
            town_seed: None,
            drawn_sites: false,
            weather: from.weather,
            time_of_day: from.time_of_day,
            sun_elevation_deg: None,
            changing_to: to,
            randomised: None,
            playback: None,
            cameras: Vec::new(),
            sensors: Vec::new(),
            vehicles: 0,
            pedestrians: 0,
            density: ActorDensity::default(),
            focus: 0.8,
            profile: TrafficProfile::default(),
            jaywalking: 0.0,
            groups: 0.0,
            events: Vec::new(),
            size: ImageSize { width: 16, height: 9 },
            fps: 10.0,
            frames,
            seed,
        }
    }

    fn condition() -> impl Strategy<Value = ConditionChange> {
        (0..Weather::ALL.len(), 0..TimeOfDay::ALL.len())
            .prop_map(|(w, t)| ConditionChange { weather: Weather::ALL[w], time_of_day: TimeOfDay::ALL[t] })
    }

    /// Quantities between 0 and 1, and the sun.
    fn quantities(at: &SceneWeather) -> [f32; 12] {
        [
            at.sun_share,
            at.overcast,
            at.cloud_cover,
            at.airlight,
            at.town_airlight,
            at.rain,
            at.wetness,
            at.puddles,
            at.exposure_key,
            at.lamps_lit,
            at.headlights_on,
            at.cloudiness,
        ]
    }

    proptest! {
        #[test]
        fn a_video_begins_in_one_condition_and_ends_in_the_other(
            from in condition(), to in condition(), seed: u64, frames in 2u32..400,
        ) {
            let changing = WeatherTimeline::of(&settings(from, Some(to), frames, seed));
            let plain = WeatherTimeline::of(&settings(from, None, frames, seed));
            prop_assert_eq!(plain.at_frame(frames / 2), plain.at_frame(0));
            if from.time_of_day == to.time_of_day {
                prop_assert_eq!(changing.at_frame(0), plain.at_frame(0));
            }
            let (end, record) = (changing.at_frame(frames - 1), Condition::of(to.weather, to.time_of_day));
            prop_assert_eq!((end.weather, end.time_of_day), (to.weather, to.time_of_day));
            let near = |a: f32, b: f32| (a - b).abs() < 1e-4;
            prop_assert!(near(end.rain, record.rain) && near(end.wetness, record.wetness));
            prop_assert!(near(end.lamps_lit, record.lamps_lit) && near(end.exposure_key, record.exposure_key));
            prop_assert!(near(end.sun_share * end.sun_direction.z.max(0.0), record.sun_share * end.sun_direction.z.max(0.0)));
            let seen = record.visibility_m;
            prop_assert!((seen.low * 0.999..=seen.high * 1.001).contains(&end.visibility_m), "{}", end.visibility_m);
        }

        #[test]
        fn nothing_jumps(from in condition(), to in condition(), seed: u64) {
            let timeline = WeatherTimeline::of(&settings(from, Some(to), 1000, seed));
            for frame in 1..1000 {
                let (before, now) = (timeline.at_frame(frame - 1), timeline.at_frame(frame));
                for (a, b) in quantities(&before).iter().zip(quantities(&now)) {
                    prop_assert!((0.0..=1.0).contains(&b) && (a - b).abs() < 0.03, "{before:?} {now:?}");
                }
                prop_assert!((now.visibility_m / before.visibility_m - 1.0).abs() < 0.03);
                // The sun of a night that begins or ends may be set anywhere below the horizon.
                let up = before.sun_direction.z > 0.0 && now.sun_direction.z > 0.0;
                prop_assert!(!up || before.sun_direction.distance(now.sun_direction) < 0.02);
            }
        }

        #[test]
        fn frames_lie_between_their_key_frames(
            from in condition(), to in condition(), seed: u64, frames in 1u32..400,
        ) {
            let timeline = WeatherTimeline::of(&settings(from, Some(to), frames, seed));
            let intervals = timeline.intervals();
            prop_assert!(intervals < frames);
            let places: Vec<(u32, f32)> = (0..frames).map(|frame| timeline.place(frame)).collect();
            prop_assert_eq!(places[0], (0, 0.0));
            prop_assert!(frames == 1 || places[places.len() - 1] == (intervals, 0.0));
            for pair in places.windows(2) {
                let way = (pair[1].0 as f32 + pair[1].1) - (pair[0].0 as f32 + pair[0].1);
                prop_assert!((0.0..=1.001).contains(&way) && pair[1].1 < 1.0, "{pair:?}");
            }
            prop_assert_eq!(timeline.at_key(intervals), timeline.at_frame(frames - 1));
        }
    }

    /// With the sun at a height that the video has drawn, degrees.
    fn with_sun(settings: SceneSettings, elevation_deg: f32) -> SceneSettings {
        SceneSettings { sun_elevation_deg: Some(elevation_deg), ..settings }
    }

    proptest! {
        #[test]
        fn a_drawn_sun_stays_where_it_is(
            from in condition(), to in condition(), elevation in -8.0f32..70.0, strength in 0.0f32..1.0, seed: u64,
        ) {
            let to = ConditionChange { time_of_day: from.time_of_day, ..to };
            let plain = settings(from, Some(to), 60, seed);
            let drawn = with_sun(plain.clone(), elevation);
            let light = SceneRandomisation::new(&[RandomisedPart::Light], strength, from.time_of_day, seed);
            let varied = WeatherTimeline::of(&SceneSettings { randomised: light, ..drawn.clone() });
            let (plain, timeline) = (WeatherTimeline::of(&plain), WeatherTimeline::of(&drawn));
            prop_assert_eq!(timeline.intervals(), plain.intervals());
            prop_assert_eq!(timeline.at_frame(0), SceneWeather::of_scene(&drawn));
            for frame in [0, 13, 30, 59] {
                let (now, in_own_light, usual) = (timeline.at_frame(frame), varied.at_frame(frame), plain.at_frame(frame));
                for at in [&now, &in_own_light] {
                    prop_assert!((at.sun_altitude_rad - elevation.to_radians()).abs() < 1e-5);
                    prop_assert!(quantities(at).iter().all(|value| (0.0..=1.0).contains(value)), "{at:?}");
                }
                prop_assert_eq!((now.lamps_lit, now.headlights_on), (in_own_light.lamps_lit, in_own_light.headlights_on));
                let kept = |at: &SceneWeather| (at.weather, at.time_of_day, at.sun_azimuth_rad, at.cloud_seed);
                prop_assert_eq!(kept(&now), kept(&usual));
                let air = |at: &SceneWeather| (at.visibility_m, at.scale_height_m, at.cloudiness);
                prop_assert_eq!(air(&now), air(&usual));
            }
            let end = timeline.at_frame(59);
            let record = by_elevation(to.weather, elevation);
            for (a, b) in [(end.rain, record.rain), (end.lamps_lit, record.lamps_lit), (end.sun_share, record.sun_share)] {
                prop_assert!((a - b).abs() < 1e-4, "{end:?}");
            }
        }

        #[test]
        fn a_twilight_has_some_lamps_lit_and_some_light_in_the_sky(
            from in condition(), elevation in -4.8f32..-1.0, seed: u64,
        ) {
            let night = ConditionChange { time_of_day: TimeOfDay::Night, ..from };
            let [dusk, dark] = [Some(elevation), None].map(|sun_elevation_deg| {
                SceneWeather::of_scene(&SceneSettings { sun_elevation_deg, ..settings(night, None, 9, seed) })
            });
            prop_assert_eq!((dusk.time_of_day, dark.lamps_lit), (TimeOfDay::Night, 1.0));
            prop_assert!(dusk.lamps_lit > 0.02 && dusk.lamps_lit < 1.0 && dusk.headlights_on > 0.5);
            prop_assert!(dusk.airlight > 0.0 && dusk.exposure_key > dark.exposure_key);
        }

        #[test]
        fn a_sun_that_moves_is_not_drawn(from in condition(), elevation in -8.0f32..70.0, seed: u64) {
            let to = ConditionChange { time_of_day: from.time_of_day.next(), ..from };
            let plain = settings(from, Some(to), 60, seed);
            let (drawn, plain) = (WeatherTimeline::of(&with_sun(plain.clone(), elevation)), WeatherTimeline::of(&plain));
            for frame in [0, 31, 59] {
                prop_assert_eq!(drawn.at_frame(frame), plain.at_frame(frame));
            }
        }
    }

    #[test]
    fn rain_stops_before_roads_dry() {
        let [rainy, clear] = [Weather::Rainy, Weather::ClearSky]
            .map(|weather| ConditionChange { weather, time_of_day: TimeOfDay::Afternoon });
        let drying = WeatherTimeline::of(&settings(rainy, Some(clear), 101, 3));
        let wetting = WeatherTimeline::of(&settings(clear, Some(rainy), 101, 3));
        assert!(drying.at_frame(45).rain == 0.0 && drying.at_frame(45).wetness > 0.75);
        assert!(wetting.at_frame(50).rain > 0.5 && wetting.at_frame(50).puddles < 0.1);
    }
}
