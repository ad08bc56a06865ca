//! Weathers that are told by numbers instead of a name: mixtures of the records of the table.

use crate::condition_mix::{Groups, by_elevation};
use crate::math::{exp, ln};
use crate::{Condition, SceneWeather, TimeOfDay, ValueRange, Weather};
use std::f32::consts::TAU;

/// A weather and a sun as numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WeatherQuantities {
    /// Of the sun, counter-clockwise from east, radians.
    pub sun_azimuth_rad: f32,
    /// Of the sun above the horizon, radians, -π/2 to π/2.
    pub sun_altitude_rad: f32,
    /// Broken clouds, from none over 0.5, those of fair weather, to 1, those that are left after rain.
    pub broken_clouds: f32,
    /// Of an overcast sky, 0 to 1.
    pub overcast: f32,
    /// In the air, 0 to 1, moderate to heavy.
    pub rain: f32,
    /// Of surfaces, 0 dry to 1 soaked.
    pub wetness: f32,
    /// Share of level wet ground that is puddle, 0 to 1.
    pub puddles: f32,
    /// How far one would see if there were nothing but fog in the air, metres; infinite without fog.
    pub fog_visibility_m: f32,
    /// How much higher the fog is thinner by the factor e, metres.
    pub fog_height_m: f32,
    /// Dust in the air, 0 to 1, a storm of it.
    pub dust: f32,
}

/// From this visibility on, metres, haze begins to look like fog; at the second it is thick.
const FOG_M: [f32; 2] = [2000.0, 155.0];
/// Visibility in a storm of dust, metres, and the colour of the light in it.
const DUST_M: f32 = 150.0;
const DUST_LIGHT: [f32; 3] = [1.0, 0.76, 0.48];
/// The sun of a night, degrees: no record tells of a lower one.
const LOWEST_SUN_DEG: f32 = -40.0;
/// Names of times of day end here, degrees of the sun's elevation.
const NIGHTFALL_DEG: f32 = -3.0;
const HIGH_SUN_DEG: f32 = 30.0;

impl SceneWeather {
    /// The weather of these quantities; the seed draws its clouds. Numbers that are none are taken for 0.
    pub fn of_quantities(quantities: &WeatherQuantities, seed: u64) -> Self {
        let q = quantities.sane();
        let elevation = q.sun_altitude_rad.to_degrees().clamp(LOWEST_SUN_DEG, 89.0);
        let condition = q.condition(elevation);
        let by_day = q.condition(45.0);
        let clouds = Self::new(Weather::ClearSky, TimeOfDay::Afternoon, seed).cloud_seed;
        Self::of(condition, clouds).with_cloudiness(by_day.overcast.max(by_day.cloud_cover))
    }
}

impl WeatherQuantities {
    fn sane(&self) -> Self {
        let share = |value: f32| if value > 0.0 { value.min(1.0) } else { 0.0 };
        let angle = |value: f32| if value.is_finite() { value % TAU } else { 0.0 };
        Self {
            sun_azimuth_rad: angle(self.sun_azimuth_rad),
            sun_altitude_rad: angle(self.sun_altitude_rad),
            broken_clouds: share(self.broken_clouds),
            overcast: share(self.overcast),
            rain: share(self.rain),
            wetness: share(self.wetness),
            puddles: share(self.puddles),
            fog_visibility_m: if self.fog_visibility_m > 0.0 { self.fog_visibility_m.max(5.0) } else { f32::INFINITY },
            fog_height_m: if self.fog_height_m.is_finite() { self.fog_height_m.clamp(2.0, 1200.0) } else { 1200.0 },
            dust: share(self.dust),
        }
    }

    /// With the sun at this elevation, degrees.
    fn condition(&self, elevation: f32) -> Condition<f32> {
        let record = |weather| {
            let usual = Condition::of(weather, TimeOfDay::Afternoon);
            let mean = |range: ValueRange| 0.5 * (range.low + range.high);
            let air = [mean(usual.visibility_m), mean(usual.scale_height_m)];
            let degrees = [self.sun_azimuth_rad.to_degrees(), elevation];
            by_elevation(weather, elevation).with_values([degrees[0], degrees[1], air[0], air[1]])
        };
        let towards = |from: &Condition<f32>, weather, sky, air| {
            Groups { sky, air, rain: air, wetness: 0.0, puddles: 0.0 }.mix(from, &record(weather))
        };
        let clear = record(Weather::ClearSky);
        let fair = Condition { cloud_cover: clear.cloud_cover * (2.0 * self.broken_clouds).min(1.0), ..clear };
        let broken = (2.0 * self.broken_clouds - 1.0).max(0.0);
        let cloudy = towards(&fair, Weather::AfterRain, broken, broken);
        let overcast = towards(&cloudy, Weather::Cloudy, self.overcast, self.overcast);
        let rainy = towards(&overcast, Weather::Rainy, self.rain * self.overcast, self.rain);
        let fog = self.fogginess();
        let foggy = towards(&rainy, Weather::Foggy, fog, fog);
        // Light is lost in each of them alone.
        let visibility_m = 1.0 / (1.0 / rainy.visibility_m + 1.0 / self.fog_visibility_m + self.dust / DUST_M);
        let time_of_day = match elevation {
            ..NIGHTFALL_DEG => TimeOfDay::Night,
            ..HIGH_SUN_DEG => TimeOfDay::Morning,
            _ => TimeOfDay::Afternoon,
        };
        let turbidity = foggy.turbidity + 4.0 * self.dust;
        let tinted = |k: usize| foggy.low_light[k] + (DUST_LIGHT[k] - foggy.low_light[k]) * self.dust;
        Condition {
            weather: self.nearest(),
            time_of_day,
            turbidity,
            low_light: [tinted(0), tinted(1), tinted(2)],
            dust_color: DUST_LIGHT.map(|channel| 1.0 + (channel - 1.0) * self.dust),
            visibility_m,
            scale_height_m: rainy.scale_height_m * exp(fog * ln(self.fog_height_m / rainy.scale_height_m)),
            rain: self.rain,
            wetness: self.wetness,
            puddles: self.puddles,
            headlights_on: foggy.headlights_on,
            ..foggy
        }
    }

    /// How much the air looks like fog, 0 to 1.
    fn fogginess(&self) -> f32 {
        let [thin, thick] = FOG_M;
        let of_fog = ln(thin / self.fog_visibility_m.min(1e9)) / ln(thin / thick);
        of_fog.clamp(0.0, 1.0).max(0.8 * self.dust)
    }

    /// The name that tells most of it.
    fn nearest(&self) -> Weather {
        if self.rain >= 0.2 {
            Weather::Rainy
        } else if self.fogginess() >= 0.5 {
            Weather::Foggy
        } else if self.overcast >= 0.7 {
            Weather::Cloudy
        } else if self.wetness >= 0.4 {
            Weather::AfterRain
        } else {
            Weather::ClearSky
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const FAIR: WeatherQuantities = WeatherQuantities {
        sun_azimuth_rad: 1.0,
        sun_altitude_rad: 0.9,
        broken_clouds: 0.5,
        overcast: 0.0,
        rain: 0.0,
        wetness: 0.0,
        puddles: 0.0,
        fog_visibility_m: f32::INFINITY,
        fog_height_m: 50.0,
        dust: 0.0,
    };

    #[test]
    fn records_of_the_table_come_out_as_they_are() {
        let after = WeatherQuantities { broken_clouds: 1.0, wetness: 0.75, puddles: 0.36, ..FAIR };
        let rainy = WeatherQuantities { overcast: 1.0, rain: 1.0, wetness: 1.0, puddles: 0.42, ..FAIR };
        let foggy = WeatherQuantities { overcast: 1.0, wetness: 0.12, fog_visibility_m: 158.0, ..FAIR };
        let cloudy = WeatherQuantities { overcast: 1.0, ..FAIR };
        let all = [
            (FAIR, Weather::ClearSky),
            (rainy, Weather::Rainy),
            (cloudy, Weather::Cloudy),
            (foggy, Weather::Foggy),
            (after, Weather::AfterRain),
        ];
        let times = [(0.25, TimeOfDay::Morning), (0.9, TimeOfDay::Afternoon), (-0.7, TimeOfDay::Night)];
        for (quantities, weather) in all {
            for (sun_altitude_rad, time) in times {
                let told = SceneWeather::of_quantities(&WeatherQuantities { sun_altitude_rad, ..quantities }, 3);
                let named = SceneWeather::new(weather, time, 3);
                assert_eq!((told.weather, told.time_of_day), (weather, time));
                let near = |of: fn(&SceneWeather) -> f32, by: f32| {
                    assert!((of(&told) - of(&named)).abs() <= by, "{weather} {time}: {} {}", of(&told), of(&named));
                };
                near(|w| w.sun_share, 1e-3);
                near(|w| w.overcast, 0.02);
                near(|w| w.overcast_klx, 0.6);
                near(|w| w.cloud_cover, 1e-3);
                near(|w| w.skyglow, 1e-3);
                near(|w| w.exposure_key, 0.02);
                near(|w| w.wetness + w.puddles + w.rain, 1e-3);
                near(|w| w.lamps_lit, 0.0);
                near(|w| ln(w.visibility_m), 0.45);
                near(|w| w.cloudiness, 0.02);
            }
        }
    }

    proptest! {
        #[test]
        fn every_number_makes_a_weather(numbers in prop::array::uniform10(prop::num::f32::ANY), seed in 0u64..4) {
            let [a, b, c, d, e, f, g, h, i, j] = numbers;
            let quantities = WeatherQuantities {
                sun_azimuth_rad: a, sun_altitude_rad: b, broken_clouds: c, overcast: d, rain: e, wetness: f, puddles: g,
                fog_visibility_m: h, fog_height_m: i, dust: j,
            };
            let scene = SceneWeather::of_quantities(&quantities, seed);
            prop_assert!((scene.sun_direction.length() - 1.0).abs() < 1e-3);
            prop_assert!(scene.visibility_m > 1.0 && scene.visibility_m.is_finite() && scene.scale_height_m >= 1.9);
            for share in [scene.sun_share, scene.overcast, scene.rain, scene.wetness, scene.puddles, scene.lamps_lit] {
                prop_assert!((0.0..=1.0).contains(&share), "{share}");
            }
        }

        #[test]
        fn little_changes_little(altitude in -0.3f32..1.2, overcast in 0.0f32..0.98, rain in 0.0f32..0.98, fog in 3.0f32..9.0) {
            let at = |more: f32| {
                let quantities = WeatherQuantities {
                    sun_altitude_rad: altitude + 0.01 * more,
                    overcast: overcast + 0.01 * more,
                    rain: rain + 0.01 * more,
                    fog_visibility_m: exp(fog + 0.01 * more),
                    ..FAIR
                };
                SceneWeather::of_quantities(&quantities, 0)
            };
            let (a, b) = (at(0.0), at(1.0));
            let steps = [
                a.sun_share - b.sun_share, a.overcast - b.overcast, 0.05 * (a.overcast * a.overcast_klx - b.overcast * b.overcast_klx),
                a.exposure_key - b.exposure_key, ln(a.visibility_m / b.visibility_m), a.lamps_lit - b.lamps_lit,
            ];
            prop_assert!(steps.iter().all(|step| step.abs() < 0.25), "{steps:?}");
        }
    }
}
