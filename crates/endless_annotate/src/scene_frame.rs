//! The scene at one instant, whatever the cameras see of it: weather, light, signals, numbers of objects.

use crate::Happenings;
use crate::rounding::{millionths, ten_thousandths_f64};
use endless_world::{ObjectClass, SceneWeather, SignalAspect, SignalId, TimeOfDay, Weather};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Metres over which [`WeatherState::fog_density`] is measured.
const FOG_PATH_M: f64 = 100.0;
/// Optical depth at the meteorological visibility: contrast falls to 2 % (Koschmieder 1924).
const VISIBILITY_DEPTH: f64 = 3.912;

/// One line of `frames.jsonl`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneFrame {
    /// Simulation frame.
    pub frame: u32,
    /// Seconds since frame 0.
    pub time_s: f64,
    /// The weather.
    pub weather: WeatherState,
    /// The light.
    pub light: LightState,
    /// Every signal group of the map, by ascending id.
    pub signals: Vec<SignalRecord>,
    /// Numbers of objects in the whole scene by class, seen or not, parked ones included.
    pub counts: BTreeMap<ObjectClass, u32>,
    /// What happens.
    #[serde(default, flatten)]
    pub happenings: Happenings,
}

/// The weather; percentages are those of CARLA's `WeatherParameters`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WeatherState {
    /// Its name.
    pub name: Weather,
    /// Share of the sky that clouds cover, percent.
    pub cloudiness: f64,
    /// Rain in the air, percent: 100 is moderate to heavy.
    pub precipitation: f64,
    /// Share of level ground that is puddle, percent.
    pub precipitation_deposits: f64,
    /// Wetness of surfaces, percent.
    pub wetness: f64,
    /// Share of a thing's contrast that the air takes on 100 m, percent.
    pub fog_density: f64,
    /// Meteorological visibility at the ground, metres.
    pub visibility_m: f64,
    /// How much higher the air is thinner by the factor e, metres.
    pub fog_scale_height_m: f64,
}

impl WeatherState {
    /// The weather of a scene at an instant.
    pub fn new(weather: &SceneWeather) -> Self {
        let depth = VISIBILITY_DEPTH * FOG_PATH_M / f64::from(weather.visibility_m);
        Self {
            name: weather.weather,
            cloudiness: percent(weather.cloudiness),
            precipitation: percent(weather.rain),
            precipitation_deposits: percent(weather.puddles),
            wetness: percent(weather.wetness),
            fog_density: ten_thousandths_f64(100.0 * (1.0 - endless_world::math::f64::exp(-depth))),
            visibility_m: ten_thousandths_f64(weather.visibility_m.into()),
            fog_scale_height_m: ten_thousandths_f64(weather.scale_height_m.into()),
        }
    }
}

/// The light of an instant.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LightState {
    /// Its name.
    pub time_of_day: TimeOfDay,
    /// The sun.
    pub sun: SunState,
    /// Whether any street lamps, windows and signs are lit.
    pub street_lamps_on: bool,
    /// Whether any vehicles drive with dipped headlights.
    pub headlights_on: bool,
    /// How many of the lamps, windows and signs are lit that are at night, percent.
    pub street_lamps_percent: f64,
    /// How many of the vehicles drive with dipped headlights, percent.
    pub headlights_percent: f64,
}

impl LightState {
    /// The light of a scene at an instant.
    pub fn new(weather: &SceneWeather) -> Self {
        Self {
            time_of_day: weather.time_of_day,
            sun: SunState::new(weather.sun_azimuth_rad, weather.sun_altitude_rad, weather.sun_share),
            street_lamps_on: weather.lamps_lit > 0.0,
            headlights_on: weather.headlights_on > 0.0,
            street_lamps_percent: percent(weather.lamps_lit),
            headlights_percent: percent(weather.headlights_on),
        }
    }
}

fn percent(share: f32) -> f64 {
    ten_thousandths_f64(100.0 * f64::from(share))
}

/// Where the sun stands in the world, also under clouds and below the horizon.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SunState {
    /// Towards the sun; a unit vector.
    pub direction: [f64; 3],
    /// Counter-clockwise from east, radians.
    pub azimuth_rad: f64,
    /// Above the horizon, radians.
    pub altitude_rad: f64,
    /// Whether it is above the horizon.
    pub up: bool,
    /// Share of its direct light that haze and clouds let through; 0 where nothing throws a shadow.
    pub direct_share: f64,
}

impl SunState {
    /// The sun at these angles; the share is kept only while it is up.
    pub fn new(azimuth_rad: f32, altitude_rad: f32, direct_share: f32) -> Self {
        let [azimuth, altitude] = [azimuth_rad, altitude_rad].map(|angle| millionths(angle.into()));
        let (sin_azimuth, cos_azimuth) = endless_world::math::f64::sin_cos(azimuth);
        let (sin_altitude, cos_altitude) = endless_world::math::f64::sin_cos(altitude);
        let up = altitude > 0.0;
        Self {
            direction: [cos_azimuth * cos_altitude, sin_azimuth * cos_altitude, sin_altitude].map(millionths),
            azimuth_rad: azimuth,
            altitude_rad: altitude,
            up,
            direct_share: if up { ten_thousandths_f64(direct_share.into()) } else { 0.0 },
        }
    }
}

/// A signal group at an instant.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SignalRecord {
    /// The group.
    pub id: SignalId,
    /// What it shows.
    pub aspect: SignalAspect,
    /// Seconds until it shows something else; left out, as what follows, if it never does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub remaining_s: Option<f64>,
    /// What it shows then.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub next: Option<SignalAspect>,
}

impl SignalRecord {
    /// A group that shows something else in so many seconds, if ever.
    pub fn new(id: SignalId, aspect: SignalAspect, change: Option<(f64, SignalAspect)>) -> Self {
        Self { id, aspect, remaining_s: change.map(|c| millionths(c.0)), next: change.map(|c| c.1) }
    }
}

/// How many there are of each class; classes of which there is none are 0.
pub fn count_by_class(classes: impl IntoIterator<Item = ObjectClass>) -> BTreeMap<ObjectClass, u32> {
    let mut counts: BTreeMap<ObjectClass, u32> = ObjectClass::ALL.iter().map(|class| (*class, 0)).collect();
    for class in classes {
        *counts.entry(class).or_default() += 1;
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_has_the_documented_fields() {
        let weather = SceneWeather::new(Weather::Rainy, TimeOfDay::Night, 1);
        let line = SceneFrame {
            frame: 7,
            time_s: 1.4,
            weather: WeatherState { visibility_m: 1000.0, ..WeatherState::new(&weather) },
            light: LightState { sun: SunState::new(1.0, -0.5, 0.7), ..LightState::new(&weather) },
            signals: vec![
                SignalRecord::new(SignalId(0), SignalAspect::RedYellow, Some((0.5, SignalAspect::Green))),
                SignalRecord::new(SignalId(1), SignalAspect::Red, None),
            ],
            counts: count_by_class([ObjectClass::Car, ObjectClass::Car, ObjectClass::Bus]),
            happenings: Happenings::default(),
        };
        let text = serde_json::to_string(&line).expect("plain data");
        for part in [
            r#"{"frame":7,"time_s":1.4,"weather":{"name":"rainy","cloudiness":100.0,"precipitation":100.0,"#,
            r#""visibility_m":1000.0"#,
            r#""altitude_rad":-0.5,"up":false,"direct_share":0.0}"#,
            r#"{"id":0,"aspect":"red_yellow","remaining_s":0.5,"next":"green"},{"id":1,"aspect":"red"}]"#,
            r#""counts":{"car":2,"van":0,"truck":0,"bus":1,"#,
        ] {
            assert!(text.contains(part), "{part} in {text}");
        }
        assert_eq!(serde_json::from_str::<SceneFrame>(&text).expect("own output"), line);
    }
}
