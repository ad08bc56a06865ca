//! The table of the fifteen conditions (a weather at a time of day) with their physical quantities.
//!
//! Within a condition scenes differ: where a quantity is a [`ValueRange`], each scene draws its own by its seed.

use crate::{Stream, TimeOfDay, Weather};

/// The range of a quantity over the scenes of a condition, uniform from `low` to `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ValueRange {
    /// Least.
    pub low: f32,
    /// Most.
    pub high: f32,
}

impl ValueRange {
    /// Always the same.
    pub const fn fixed(value: f32) -> Self {
        Self { low: value, high: value }
    }

    /// Between two values.
    pub const fn between(low: f32, high: f32) -> Self {
        Self { low, high }
    }

    /// One of them. A fixed value draws nothing from the stream.
    pub fn draw(self, random: &mut Stream) -> f32 {
        if self.low == self.high { self.low } else { random.range_f32(self.low, self.high) }
    }
}

/// One weather at one time of day. Quantities without a source are set by eye, against pictures of real street cameras.
/// `Q` is [`ValueRange`] in the table, and `f32` where a scene has drawn its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Condition<Q = ValueRange> {
    /// The weather.
    pub weather: Weather,
    /// The time of day.
    pub time_of_day: TimeOfDay,

    // The sun.
    /// Counter-clockwise from east, degrees: morning around east, afternoon from south-west to west.
    pub sun_azimuth_deg: Q,
    /// Above the horizon, degrees.
    pub sun_elevation_deg: Q,
    /// Share of the sun's direct light that haze and clouds let through, 0 to 1.
    pub sun_share: f32,

    // The sky.
    /// Linke turbidity of the clear part of the sky (Linke 1922): 2 very clear, 3 clear, 6 hazy.
    pub turbidity: f32,
    /// Share of the CIE overcast sky (Moon and Spencer 1942) in the sky, 0 to 1.
    pub overcast: f32,
    /// Horizontal illuminance of a fully overcast sky, klx: 5 to 20 by day (CIE 108).
    pub overcast_klx: f32,
    /// Share of the sky that broken clouds cover, 0 to 1.
    pub cloud_cover: f32,
    /// Brightness of broken clouds, of that at noon.
    pub cloud_brightness: f32,
    /// Colour of light that has come through the low air to clouds and haze, linear, brightest channel 1.
    pub low_light: [f32; 3],
    /// Colour that dust in the air gives all daylight, linear; white without dust.
    pub dust_color: [f32; 3],
    /// Light of the town in the night sky, of that in a clear one; 0 by day. Clouds throw it back.
    pub skyglow: f32,

    // The air.
    /// Meteorological visibility at the ground, metres: contrast falls to 2 % (Koschmieder 1924). Fog by definition
    /// lies under 1000 (WMO-No. 8).
    pub visibility_m: Q,
    /// How much higher the air is thinner by the factor e, metres: haze and rain reach high up, fog lies on the ground as
    /// it cools.
    pub scale_height_m: Q,
    /// Radiance of infinitely deep air by the light of the sky: of the sky's mean; 0 at night.
    pub airlight: f32,
    /// Radiance of infinitely deep air by the light of the town, of that of a usual town; 0 by day.
    pub town_airlight: f32,
    /// Extra radiance of the air towards the sun, of the sky's mean.
    pub sunward: f32,
    /// How much of a lamp's light the air spreads as a halo, 0 to 1: rain less than fog, its drops are few and large.
    pub halo: f32,
    /// Rain in the air, 0 to 1: 1 is moderate to heavy.
    pub rain: f32,

    // The ground.
    /// Wetness of surfaces, 0 dry to 1 soaked.
    pub wetness: f32,
    /// Share of level wet ground that is puddle.
    pub puddles: f32,

    // Cameras.
    /// Share of light that droplets in the air and on the lens scatter around bright objects.
    pub glare: f32,
    /// Grey that exposure makes of the picture's mean, of full scale: night should look like night.
    pub exposure_key: f32,

    // People.
    /// Share of street lamps, windows and signs that are lit: 0 by day, 1 at night.
    pub lamps_lit: f32,
    /// Share of vehicles that drive with dipped headlights.
    pub headlights_on: f32,
}

impl Condition {
    /// The record of a weather at a time of day.
    pub fn of(weather: Weather, time_of_day: TimeOfDay) -> &'static Self {
        &CONDITIONS[weather as usize * TimeOfDay::ALL.len() + time_of_day as usize]
    }
}

impl<Q: Copy> Condition<Q> {
    /// The same with other values of what scenes draw: azimuth and elevation of the sun, visibility, scale height.
    pub(crate) const fn with_values<R: Copy>(
        &self,
        [sun_azimuth_deg, sun_elevation_deg, visibility_m, scale_height_m]: [R; 4],
    ) -> Condition<R> {
        Condition {
            sun_azimuth_deg,
            sun_elevation_deg,
            visibility_m,
            scale_height_m,
            weather: self.weather,
            time_of_day: self.time_of_day,
            sun_share: self.sun_share,
            turbidity: self.turbidity,
            overcast: self.overcast,
            overcast_klx: self.overcast_klx,
            cloud_cover: self.cloud_cover,
            cloud_brightness: self.cloud_brightness,
            low_light: self.low_light,
            dust_color: self.dust_color,
            skyglow: self.skyglow,
            airlight: self.airlight,
            town_airlight: self.town_airlight,
            sunward: self.sunward,
            halo: self.halo,
            rain: self.rain,
            wetness: self.wetness,
            puddles: self.puddles,
            glare: self.glare,
            exposure_key: self.exposure_key,
            lamps_lit: self.lamps_lit,
            headlights_on: self.headlights_on,
        }
    }
}

/// A clear afternoon, from which the others differ.
const CLEAR: Condition = Condition {
    weather: Weather::ClearSky,
    time_of_day: TimeOfDay::Afternoon,
    sun_azimuth_deg: ValueRange::between(215.0, 285.0),
    sun_elevation_deg: ValueRange::between(42.0, 60.0),
    sun_share: 1.0,
    turbidity: 2.2,
    overcast: 0.0,
    overcast_klx: 0.0,
    cloud_cover: 0.28,
    cloud_brightness: 1.0,
    low_light: [1.0; 3],
    dust_color: [1.0; 3],
    skyglow: 0.0,
    visibility_m: ValueRange::fixed(14_000.0),
    scale_height_m: ValueRange::fixed(1200.0),
    airlight: 0.85,
    town_airlight: 0.0,
    sunward: 0.8,
    halo: 0.65,
    rain: 0.0,
    wetness: 0.0,
    puddles: 0.0,
    glare: 0.0,
    exposure_key: 0.235,
    lamps_lit: 0.0,
    headlights_on: 0.0,
};

const CLOUDY: Condition = Condition {
    weather: Weather::Cloudy,
    sun_share: 0.0,
    turbidity: 3.0,
    overcast: 0.93,
    overcast_klx: 17.0,
    cloud_cover: 0.0,
    visibility_m: ValueRange::fixed(7_000.0),
    sunward: 0.0,
    ..CLEAR
};

const RAINY: Condition = Condition {
    weather: Weather::Rainy,
    sun_share: 0.0,
    turbidity: 4.0,
    overcast: 1.0,
    overcast_klx: 8.0,
    cloud_cover: 0.0,
    visibility_m: ValueRange::between(900.0, 1600.0),
    sunward: 0.0,
    halo: 0.5,
    rain: 1.0,
    wetness: 1.0,
    puddles: 0.42,
    exposure_key: 0.20,
    headlights_on: 1.0,
    ..CLEAR
};

const FOGGY: Condition = Condition {
    weather: Weather::Foggy,
    sun_share: 0.0,
    turbidity: 5.0,
    overcast: 0.96,
    overcast_klx: 12.0,
    cloud_cover: 0.0,
    visibility_m: ValueRange::between(110.0, 200.0),
    scale_height_m: ValueRange::between(35.0, 70.0),
    airlight: 0.9,
    sunward: 0.35,
    wetness: 0.12,
    exposure_key: 0.34,
    headlights_on: 1.0,
    ..CLEAR
};

const AFTER_RAIN: Condition = Condition {
    weather: Weather::AfterRain,
    sun_share: 0.8,
    turbidity: 2.0,
    overcast: 0.12,
    overcast_klx: 10.0,
    cloud_cover: 0.55,
    visibility_m: ValueRange::fixed(9_000.0),
    wetness: 0.75,
    puddles: 0.36,
    ..CLEAR
};

/// The same weather in the morning: a low, warm sun, and less than half of the light of the clouds.
const fn morning(afternoon: Condition) -> Condition {
    Condition {
        time_of_day: TimeOfDay::Morning,
        sun_azimuth_deg: ValueRange::between(-25.0, 35.0),
        sun_elevation_deg: ValueRange::between(11.0, 19.0),
        overcast_klx: afternoon.overcast_klx * 0.45,
        cloud_brightness: 0.45,
        low_light: [1.0, 0.86, 0.72],
        exposure_key: 0.165,
        ..afternoon
    }
}

/// The same weather at night, in the light of the town.
const fn night(afternoon: Condition) -> Condition {
    Condition {
        time_of_day: TimeOfDay::Night,
        sun_azimuth_deg: ValueRange::between(0.0, 360.0),
        sun_elevation_deg: ValueRange::fixed(-40.0),
        sun_share: 0.0,
        overcast: 0.0,
        cloud_cover: 0.0,
        skyglow: 1.9,
        airlight: 0.0,
        town_airlight: 0.30,
        sunward: 0.0,
        glare: 0.06,
        exposure_key: 0.065,
        lamps_lit: 1.0,
        headlights_on: 1.0,
        ..afternoon
    }
}

/// All of them, in the order of [`Weather::ALL`], and of [`TimeOfDay::ALL`] within each.
static CONDITIONS: [Condition; 15] = [
    Condition { turbidity: 3.0, exposure_key: 0.19, ..morning(CLEAR) },
    CLEAR,
    Condition { skyglow: 1.0, ..night(CLEAR) },
    morning(RAINY),
    RAINY,
    Condition { town_airlight: 0.12, glare: 0.10, exposure_key: 0.075, ..night(RAINY) },
    morning(CLOUDY),
    CLOUDY,
    night(CLOUDY),
    Condition { sunward: 0.9, exposure_key: 0.27, ..morning(FOGGY) },
    FOGGY,
    Condition { town_airlight: 0.42, glare: 0.13, exposure_key: 0.075, ..night(FOGGY) },
    Condition { exposure_key: 0.19, ..morning(AFTER_RAIN) },
    AFTER_RAIN,
    night(AFTER_RAIN),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_weather_has_a_record_at_each_time() {
        for &weather in Weather::ALL {
            for &time_of_day in TimeOfDay::ALL {
                let condition = Condition::of(weather, time_of_day);
                let night = time_of_day == TimeOfDay::Night;
                assert_eq!((condition.weather, condition.time_of_day), (weather, time_of_day));
                assert_eq!(condition.lamps_lit, f32::from(night), "{weather} {time_of_day}");
                assert_eq!(condition.sun_elevation_deg.high < 0.0, night, "{weather} {time_of_day}");
                assert!(condition.visibility_m.low <= condition.visibility_m.high);
            }
        }
    }

    #[test]
    fn a_fixed_quantity_draws_nothing() {
        let (mut a, mut b) = (Stream::named(1, "spread", &[]), Stream::named(1, "spread", &[]));
        assert_eq!(ValueRange::fixed(3.0).draw(&mut a), 3.0);
        assert_eq!(a.next_u64(), b.next_u64());
        assert!((2.0..5.0).contains(&ValueRange::between(2.0, 5.0).draw(&mut a)));
    }
}
