//! CARLA's fourteen parameters of weather as our conditions.

use crate::wire::WeatherParameters;
use endless_world::math::sin_cos;
use endless_world::{SceneWeather, TimeOfDay, Weather};
use glam::Vec3;

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

/// Below this altitude of the sun it is night, degrees.
const NIGHT_DEG: f32 = 0.0;
/// Below this one it is low, degrees.
const LOW_SUN_DEG: f32 = 30.0;

/// The condition that is nearest, with the sun where CARLA has it.
pub(super) fn scene_weather(parameters: &WeatherParameters, seed: u64) -> SceneWeather {
    let (weather, time) = condition(parameters);
    let scene = SceneWeather::new(weather, time, seed);
    if time == TimeOfDay::Night {
        return scene;
    }
    // No sun so low that the records of the day no longer hold.
    let altitude = parameters.sun_altitude_angle.clamp(4.0, 90.0).to_radians();
    let (sin_altitude, cos_altitude) = sin_cos(altitude);
    let (sin_azimuth, cos_azimuth) = sin_cos(parameters.sun_azimuth_angle.rem_euclid(360.0).to_radians());
    // CARLA's y axis points south.
    scene.with_sun(Vec3::new(cos_azimuth * cos_altitude, -sin_azimuth * cos_altitude, sin_altitude))
}

/// The weather and time of day that are nearest to CARLA's presets of these names.
pub(super) fn condition(parameters: &WeatherParameters) -> (Weather, TimeOfDay) {
    let WeatherParameters { cloudiness, precipitation, precipitation_deposits, fog_density, wetness, .. } = *parameters;
    let weather = if precipitation >= 10.0 {
        Weather::Rainy
    } else if fog_density >= 25.0 {
        Weather::Foggy
    } else if precipitation_deposits >= 25.0 || wetness >= 25.0 {
        Weather::AfterRain
    } else if cloudiness >= 50.0 {
        Weather::Cloudy
    } else {
        Weather::ClearSky
    };
    let altitude = parameters.sun_altitude_angle;
    let time = if altitude < NIGHT_DEG {
        TimeOfDay::Night
    } else if altitude < LOW_SUN_DEG {
        TimeOfDay::Morning
    } else {
        TimeOfDay::Afternoon
    };
    (weather, time)
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn presets_are_the_conditions_of_their_names() {
        use TimeOfDay::{Afternoon, Morning, Night};
        // ClearNoon, CloudySunset, WetNoon, HardRainNight, and a fog.
        assert_eq!(condition(&preset(5.0, 0.0, 0.0, 2.0, 45.0)), (Weather::ClearSky, Afternoon));
        assert_eq!(condition(&preset(60.0, 0.0, 0.0, 3.0, 15.0)), (Weather::Cloudy, Morning));
        assert_eq!(condition(&preset(5.0, 0.0, 50.0, 3.0, 45.0)), (Weather::AfterRain, Afternoon));
        assert_eq!(condition(&preset(100.0, 100.0, 90.0, 100.0, -90.0)), (Weather::Rainy, Night));
        assert_eq!(condition(&preset(50.0, 0.0, 0.0, 60.0, 40.0)), (Weather::Foggy, Afternoon));
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
