//! Conditions between those of the table.
//!
//! While the sun moves on evenly, what follows from where it stands (twilight, lamps, exposure) does not. The weather changes
//! in the order in which it does outdoors: clouds, then rain, then wet roads, then puddles; rain stops before anything
//! dries.

use crate::math::{exp, lerp, ln, smoothstep};
use crate::{Condition, TimeOfDay, Weather};

/// The lowest sun of a morning's record, degrees: the record holds from here up to [`MORNING_SUN_DEG`].
const LOW_SUN_DEG: f32 = 11.0;
/// The highest sun of a morning's record, degrees.
const MORNING_SUN_DEG: f32 = 19.0;
/// The lowest sun of an afternoon's record, degrees.
const AFTERNOON_SUN_DEG: f32 = 42.0;
/// Where it is night, degrees: little less than the end of civil twilight.
const NIGHT_SUN_DEG: f32 = -8.0;

/// The record of a weather with the sun at this elevation, degrees: those of afternoon, morning and night, and what lies
/// between. What scenes draw, and the name of the time, are left to whoever asks.
pub(crate) fn by_elevation(weather: Weather, elevation: f32) -> Condition<f32> {
    let record = |time| Condition::of(weather, time).with_values([1.0; 4]);
    let morning = record(TimeOfDay::Morning);
    if elevation >= LOW_SUN_DEG {
        let high = (elevation - MORNING_SUN_DEG) / (AFTERNOON_SUN_DEG - MORNING_SUN_DEG);
        return linear(&morning, &record(TimeOfDay::Afternoon), high.clamp(0.0, 1.0));
    }
    let night = record(TimeOfDay::Night);
    if elevation <= NIGHT_SUN_DEG {
        return night;
    }
    let below = LOW_SUN_DEG - elevation;
    let dark = 1.0 - smoothstep(NIGHT_SUN_DEG, 1.0, elevation);
    // Twilight falls by e every four degrees; of the sky itself the model of the clear sky tells.
    let dusk = exp(-0.25 * below) * (1.0 - smoothstep(-3.0, NIGHT_SUN_DEG, elevation));
    let red = smoothstep(LOW_SUN_DEG, 0.0, elevation);
    let [r, g, b] = morning.low_light;
    Condition {
        sun_share: morning.sun_share * smoothstep(NIGHT_SUN_DEG, 0.0, elevation),
        // At night the sky is clear and black: clouds throw back the light of the town, of which the glow tells.
        overcast: morning.overcast * smoothstep(NIGHT_SUN_DEG, -4.0, elevation),
        overcast_klx: morning.overcast_klx * dusk,
        cloud_cover: morning.cloud_cover * smoothstep(NIGHT_SUN_DEG, -4.0, elevation),
        cloud_brightness: morning.cloud_brightness * dusk,
        low_light: [r, g * lerp(1.0, 0.74, red), b * lerp(1.0, 0.55, red)],
        skyglow: night.skyglow * dark,
        airlight: morning.airlight * (1.0 - dark),
        town_airlight: night.town_airlight * dark,
        sunward: morning.sunward * smoothstep(-2.0, 3.0, elevation),
        glare: lerp(morning.glare, night.glare, dark),
        exposure_key: lerp(morning.exposure_key, night.exposure_key, smoothstep(4.0, NIGHT_SUN_DEG, elevation)),
        lamps_lit: smoothstep(0.0, -5.0, elevation),
        headlights_on: morning.headlights_on.max(smoothstep(3.0, -2.0, elevation)),
        ..morning
    }
}

/// Every quantity on the way from one record to another.
fn linear(from: &Condition<f32>, to: &Condition<f32>, share: f32) -> Condition<f32> {
    Groups { sky: share, air: share, rain: share, wetness: share, puddles: share }.mix(from, to)
}

/// What a change of weather has come to, and how far that of the sky is.
pub(crate) struct Mixed {
    /// All quantities.
    pub(crate) condition: Condition<f32>,
    /// Of the sky, 0 to 1.
    pub(crate) sky: f32,
}

/// Between two records of a change of weather, at a share of the way.
pub(crate) fn mixed(from: &Condition<f32>, to: &Condition<f32>, share: f32) -> Mixed {
    // Evenly, so that no moment sees more of the change than others.
    let part = |[begin, end]: [f32; 2]| ((share - begin) / (end - begin)).clamp(0.0, 1.0);
    let comes = |rising: bool, grows: [f32; 2], shrinks: [f32; 2]| part(if rising { grows } else { shrinks });
    let groups = Groups {
        sky: part([0.0, 0.6]),
        air: part([0.1, 1.0]),
        rain: comes(to.rain > from.rain, [0.15, 0.75], [0.0, 0.4]),
        wetness: comes(to.wetness > from.wetness, [0.2, 0.95], [0.3, 1.0]),
        puddles: comes(to.puddles > from.puddles, [0.4, 1.0], [0.2, 0.9]),
    };
    Mixed { condition: groups.mix(from, to), sky: groups.sky }
}

/// How far each group of quantities is on its way, 0 to 1.
pub(crate) struct Groups {
    pub(crate) sky: f32,
    pub(crate) air: f32,
    pub(crate) rain: f32,
    pub(crate) wetness: f32,
    pub(crate) puddles: f32,
}

impl Groups {
    /// Between two records.
    pub(crate) fn mix(&self, from: &Condition<f32>, to: &Condition<f32>) -> Condition<f32> {
        let Self { sky, air, rain, wetness, puddles } = *self;
        // One sees by contrast, which falls exponentially.
        let by_ratio = |from: f32, to: f32| from * exp(air * ln(to / from));
        let nearer = if sky < 0.5 { from } else { to };
        // Shadows are seen by how much brighter the sun is than the sky: most of it may go at first, and come at last.
        let sun = if to.sun_share < from.sun_share { sky * (2.0 - sky) } else { sky * sky };
        Condition {
            weather: nearer.weather,
            time_of_day: from.time_of_day,
            sun_azimuth_deg: lerp(from.sun_azimuth_deg, to.sun_azimuth_deg, sky),
            sun_elevation_deg: lerp(from.sun_elevation_deg, to.sun_elevation_deg, sky),
            sun_share: lerp(from.sun_share, to.sun_share, sun),
            turbidity: lerp(from.turbidity, to.turbidity, sky),
            overcast: lerp(from.overcast, to.overcast, sky),
            overcast_klx: lerp(from.overcast_klx, to.overcast_klx, sky),
            cloud_cover: lerp(from.cloud_cover, to.cloud_cover, sky),
            cloud_brightness: lerp(from.cloud_brightness, to.cloud_brightness, sky),
            low_light: [0, 1, 2].map(|k| lerp(from.low_light[k], to.low_light[k], sky)),
            dust_color: [0, 1, 2].map(|k| lerp(from.dust_color[k], to.dust_color[k], sky)),
            skyglow: lerp(from.skyglow, to.skyglow, sky),
            visibility_m: by_ratio(from.visibility_m, to.visibility_m),
            scale_height_m: by_ratio(from.scale_height_m, to.scale_height_m),
            airlight: lerp(from.airlight, to.airlight, air),
            town_airlight: lerp(from.town_airlight, to.town_airlight, air),
            sunward: lerp(from.sunward, to.sunward, air),
            halo: lerp(from.halo, to.halo, air),
            rain: lerp(from.rain, to.rain, rain),
            wetness: lerp(from.wetness, to.wetness, wetness),
            puddles: lerp(from.puddles, to.puddles, puddles),
            glare: lerp(from.glare, to.glare, air),
            exposure_key: lerp(from.exposure_key, to.exposure_key, air),
            lamps_lit: lerp(from.lamps_lit, to.lamps_lit, sky),
            headlights_on: lerp(from.headlights_on, to.headlights_on, rain),
        }
    }
}
