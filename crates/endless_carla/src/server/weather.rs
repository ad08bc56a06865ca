//! CARLA's fourteen parameters of weather as quantities of ours.

use crate::wire::WeatherParameters;
use endless_world::math::pow;
use endless_world::{SceneWeather, WeatherQuantities};

/// CARLA's preset of this name: what episodes begin with.
pub(super) const CLEAR_NOON: WeatherParameters = WeatherParameters {
    cloudiness: 5.0,
    precipitation: 0.0,
    precipitation_deposits: 0.0,
    wind_intensity: 10.0,
    sun_azimuth_angle: 0.0,
    sun_altitude_angle: 45.0,
    fog_density: 2.0,
    fog_distance: 0.75,
    fog_falloff: 0.1,
    wetness: 0.0,
    scattering_intensity: 1.0,
    mie_scattering_scale: 0.03,
    rayleigh_scattering_scale: 0.0331,
    dust_storm: 0.0,
};

/// Below this altitude of the sun it is night, degrees: lamps are on.
const NIGHT_DEG: f32 = -2.5;

/// The weather that is drawn.
pub(super) fn scene_weather(parameters: &WeatherParameters, seed: u64) -> SceneWeather {
    SceneWeather::of_quantities(&quantities(parameters), seed)
}

/// Whether street lamps are lit.
pub(super) fn is_night(parameters: &WeatherParameters) -> bool {
    parameters.sun_altitude_angle < NIGHT_DEG
}

/// CARLA's presets, and what `endless generate` asks of a server, come near to our conditions of these names.
fn quantities(parameters: &WeatherParameters) -> WeatherQuantities {
    // Of a hundred; what is no number is none.
    let share = |value: f32| if value > 0.0 { 0.01 * value.min(100.0) } else { 0.0 };
    let part = |value: f32, from: f32, to: f32| ((value - from) / (to - from)).clamp(0.0, 1.0);
    let (clouds, deposits) = (share(parameters.cloudiness), share(parameters.precipitation_deposits));
    // Rain at 60 is our moderate to heavy one.
    let rain = part(share(parameters.precipitation), 0.0, 0.6);
    // Deposits are water on the ground: they wet it, whatever CARLA's wetness of roads says, which is 0 in presets by day.
    let wetness = part(share(parameters.wetness), 0.0, 0.8).max(part(deposits, 0.0, 0.8));
    WeatherQuantities {
        // CARLA's y axis points south.
        sun_azimuth_rad: -parameters.sun_azimuth_angle.rem_euclid(360.0).to_radians(),
        sun_altitude_rad: parameters.sun_altitude_angle.clamp(-90.0, 90.0).to_radians(),
        // At 5 the sky is our clear one; wet streets lie under clouds that break up.
        broken_clouds: (0.5 * part(clouds, 0.0, 0.05) + 0.5 * part(clouds, 0.05, 0.25)).max(part(wetness, 0.0, 0.75)),
        overcast: part(clouds, 0.25, 0.6),
        rain,
        wetness,
        puddles: (0.6 * deposits + 0.06 * rain).min(0.55),
        fog_visibility_m: fog_visibility_m(parameters),
        // At 1 it reaches as high as houses.
        fog_height_m: 40.0 / parameters.fog_falloff.max(0.03),
        dust: share(parameters.dust_storm),
    }
}

/// How far one sees in the fog, metres.
fn fog_visibility_m(parameters: &WeatherParameters) -> f32 {
    /// Density of our fog, and how far one sees in it, metres.
    const USUAL: [f32; 2] = [60.0, 155.0];
    /// Of this density CARLA's presets are at night that are called clear or cloudy: thin, or far away.
    const CLEAR_NIGHT: f32 = 60.0;
    const THIN_FALLOFF: f32 = 0.2;
    const FAR_M: f32 = 50.0;
    let WeatherParameters { fog_density, fog_falloff, fog_distance, .. } = *parameters;
    let is_preset = is_night(parameters) && (fog_falloff <= THIN_FALLOFF || fog_distance >= FAR_M);
    let density = if is_preset { fog_density - CLEAR_NIGHT } else { fog_density };
    if density > 0.0 { USUAL[1] * pow(USUAL[0] / density.min(100.0), 2.5) } else { f32::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{TimeOfDay, Weather};
    use glam::Vec3;

    fn preset(cloudiness: f32, precipitation: f32, deposits: f32, fog: f32, altitude: f32) -> WeatherParameters {
        WeatherParameters {
            cloudiness,
            precipitation,
            precipitation_deposits: deposits,
            fog_density: fog,
            sun_altitude_angle: altitude,
            ..WeatherParameters::default()
        }
    }

    #[test]
    fn light_in_dust_is_brown() {
        let light = |dust_storm: f32| {
            scene_weather(&WeatherParameters { dust_storm, ..preset(5.0, 0.0, 0.0, 2.0, 45.0) }, 0).dust_color
        };
        let ([r, g, b], [_, half_g, half_b]) = (light(100.0), light(50.0));
        assert!(r == 1.0 && g < 0.9 && b < g - 0.1);
        assert!(half_g > g && half_b > b);
        assert_eq!(light(0.0), [1.0; 3]);
    }

    #[test]
    fn presets_are_the_conditions_of_their_names() {
        use TimeOfDay::{Afternoon, Morning, Night};
        let named = |parameters: &WeatherParameters| {
            let scene = scene_weather(parameters, 0);
            (scene.weather, scene.time_of_day)
        };
        // ClearNoon, CloudySunset, WetNoon, HardRainNight, and a fog.
        assert_eq!(named(&preset(5.0, 0.0, 0.0, 2.0, 45.0)), (Weather::ClearSky, Afternoon));
        assert_eq!(named(&preset(60.0, 0.0, 0.0, 3.0, 15.0)), (Weather::Cloudy, Morning));
        assert_eq!(named(&preset(5.0, 0.0, 50.0, 3.0, 45.0)), (Weather::AfterRain, Afternoon));
        assert_eq!(named(&preset(100.0, 100.0, 90.0, 100.0, -90.0)), (Weather::Rainy, Night));
        assert_eq!(named(&preset(50.0, 0.0, 0.0, 60.0, 40.0)), (Weather::Foggy, Afternoon));
        // ClearNight and CloudyNight are full of fog that nobody sees.
        let clear = WeatherParameters { fog_distance: 75.0, fog_falloff: 1.0, ..preset(5.0, 0.0, 0.0, 60.0, -90.0) };
        assert_eq!(named(&clear), (Weather::ClearSky, Night));
        let cloudy = WeatherParameters { fog_distance: 0.75, fog_falloff: 0.1, ..preset(60.0, 0.0, 0.0, 60.0, -90.0) };
        assert_eq!(named(&cloudy), (Weather::Cloudy, Night));
        assert!(is_night(&cloudy) && !is_night(&preset(5.0, 0.0, 0.0, 0.0, -1.0)));
    }

    #[test]
    fn more_of_it_is_more() {
        let scene = |clouds, rain, deposits, fog| scene_weather(&preset(clouds, rain, deposits, fog, 45.0), 0);
        let steps = [0.0f32, 10.0, 30.0, 50.0, 59.0];
        for pair in steps.windows(2) {
            let (less, more) = (pair[0], pair[1]);
            let [a, b] = [less, more].map(|clouds| scene(clouds, 0.0, 0.0, 0.0));
            assert!(a.overcast + a.cloud_cover + a.cloudiness < b.overcast + b.cloud_cover + b.cloudiness, "{more}");
            let [a, b] = [less, more].map(|rain| scene(60.0, rain, 0.0, 0.0));
            assert!(a.rain < b.rain && a.visibility_m > b.visibility_m);
            let [a, b] = [less, more].map(|deposits| scene(5.0, 0.0, deposits, 0.0));
            assert!(a.wetness < b.wetness && a.puddles < b.puddles);
            let [a, b] = [less, more].map(|fog| scene(60.0, 0.0, 0.0, fog));
            assert!(a.visibility_m > b.visibility_m);
        }
    }

    #[test]
    fn the_sun_stands_where_it_is_put() {
        let parameters = WeatherParameters { sun_azimuth_angle: 90.0, ..preset(0.0, 0.0, 0.0, 0.0, 45.0) };
        let towards = scene_weather(&parameters, 0).sun_direction;
        assert!(towards.distance(Vec3::new(0.0, -0.5f32.sqrt(), 0.5f32.sqrt())) < 1e-5);
        let wrong = WeatherParameters { sun_azimuth_angle: f32::NAN, ..parameters };
        assert!(scene_weather(&wrong, 0).sun_direction.is_finite());
    }
}
