//! Light of a video's own: sun, sky, lamps, air and exposure beside what its condition draws.

use crate::{Condition, Stream, TimeOfDay, math};
use serde::{Deserialize, Serialize};

/// What a video changes of the light of its condition.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LightVariation {
    /// Turns the sun counter-clockwise, degrees.
    pub sun_turn_deg: f32,
    /// Raises the sun, degrees; it stays between 6 and 75 above the horizon, and at night where it is.
    pub sun_rise_deg: f32,
    /// Factors of the sun's light by linear channel.
    pub sun: [f32; 3],
    /// Of the sky's.
    pub sky: [f32; 3],
    /// Of all street lamps'; each varies a little besides.
    pub lamps: [f32; 3],
    /// Of the brightness that exposure aims for.
    pub exposure: f32,
    /// Of the distance that one sees.
    pub visibility: f32,
}

/// Where the sun stands by day, degrees above the horizon.
const SUN_DEG: [f32; 2] = [6.0, 75.0];

impl LightVariation {
    /// What the seed of a scene draws.
    pub fn new(strength: f32, time_of_day: TimeOfDay, seed: u64) -> Self {
        let mut random = Stream::named(seed, "randomised light", &[]);
        let mut within = |most: f32| random.range_f32(-most, most) * strength;
        let mut light = |stops: f32, warmth: f32| tinted(within(stops), within(warmth), within(0.15));
        let (sun, sky, lamps) = (light(1.2, 1.3), light(0.8, 1.1), light(0.9, 1.5));
        let exposure = if time_of_day == TimeOfDay::Night { within(0.7) } else { within(0.95) };
        Self {
            sun_turn_deg: within(180.0),
            sun_rise_deg: within(35.0),
            sun,
            sky,
            lamps,
            exposure: math::exp2(exposure),
            visibility: math::exp2(within(0.9)),
        }
    }

    /// What a scene has drawn of its condition, in this light.
    pub(crate) fn of(&self, condition: &Condition<f32>) -> Condition<f32> {
        let Condition { sun_azimuth_deg, sun_elevation_deg, visibility_m, exposure_key, .. } = *condition;
        let rises = sun_elevation_deg > 0.0 && self.sun_rise_deg != 0.0;
        let raised = (sun_elevation_deg + self.sun_rise_deg).clamp(SUN_DEG[0], SUN_DEG[1]);
        // Fog and what is told of it begin where they do.
        let seen = visibility_m * self.visibility;
        Condition {
            sun_azimuth_deg: sun_azimuth_deg + self.sun_turn_deg,
            sun_elevation_deg: if rises { raised } else { sun_elevation_deg },
            visibility_m: if visibility_m < FOG_M { seen.min(FOG_M - 1.0) } else { seen.max(FOG_M.min(visibility_m)) },
            exposure_key: exposure_key * self.exposure,
            ..*condition
        }
    }

    /// The same without raising the sun, for videos in which it rises, sets or stands where it was drawn.
    pub(crate) fn with_sun_as_high(self) -> Self {
        Self { sun_rise_deg: 0.0, ..self }
    }

    /// Factors by linear channel of one street lamp, by its place in the town's list.
    pub fn lamp(&self, seed: u64, strength: f32, lamp: usize) -> [f32; 3] {
        let mut random = Stream::named(seed, "randomised lamp", &[lamp as u64]);
        let mut within = |most: f32| random.range_f32(-most, most) * strength;
        let own = tinted(within(0.7), within(0.5), within(0.1));
        std::array::from_fn(|k| own[k] * self.lamps[k])
    }
}

/// Meteorological fog begins here, metres.
const FOG_M: f32 = 1000.0;

/// Factors of light that is so many stops brighter, warmer (at 1 about a candle's beside daylight) and greener.
fn tinted(stops: f32, warmth: f32, green: f32) -> [f32; 3] {
    [stops + 0.7 * warmth, stops + green, stops - 1.0 * warmth].map(math::exp2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{SceneWeather, Weather};

    #[test]
    fn conditions_keep_what_their_names_say() {
        for seed in 0..60 {
            for &weather in Weather::ALL {
                for &time in TimeOfDay::ALL {
                    let usual = SceneWeather::new(weather, time, seed);
                    let drawn = usual.varied(&LightVariation::new(1.0, time, seed));
                    assert_eq!(drawn.sun_direction.z > 0.0, time != TimeOfDay::Night);
                    assert_eq!(drawn.visibility_m < FOG_M, usual.visibility_m < FOG_M, "{weather} {time}");
                    assert!(drawn.visibility_m > 50.0);
                    let exposure = drawn.exposure_key / usual.exposure_key;
                    assert!((0.5..2.0).contains(&exposure));
                }
            }
        }
    }

    #[test]
    fn lamps_differ_from_each_other_and_from_seed_to_seed() {
        let light = |seed| LightVariation::new(0.5, TimeOfDay::Night, seed);
        assert_ne!(light(1), light(2));
        assert_ne!(light(1).lamp(1, 0.5, 0), light(1).lamp(1, 0.5, 1));
        assert_eq!(light(1).lamp(1, 0.5, 7), light(1).lamp(1, 0.5, 7));
    }
}
