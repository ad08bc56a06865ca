//! The paper's weathers and times of day as CARLA's parameters.

use crate::wire::WeatherParameters;
use endless_world::math::f64::{asin, atan2};
use endless_world::{SceneWeather, Weather};

/// Below this the sun gives no light to the sky, degrees: the end of astronomical twilight.
const DARK_SUN_DEG: f64 = -18.0;

/// CARLA's parameters of a scene's weather. By day, at dusk and at dawn the sun stands where it stands in the built-in city.
pub(super) fn parameters(scene: &SceneWeather) -> WeatherParameters {
    let sun = scene.sun_direction.as_dvec3();
    let (azimuth, altitude) = (atan2(-sun.y, sun.x).to_degrees(), asin(sun.z.clamp(-1.0, 1.0)).to_degrees());
    let altitude = if altitude < DARK_SUN_DEG { -90.0 } else { altitude };
    let air = WeatherParameters {
        wind_intensity: 10.0,
        fog_distance: 0.75,
        fog_falloff: 0.1,
        scattering_intensity: 1.0,
        mie_scattering_scale: 0.03,
        sun_azimuth_angle: azimuth.rem_euclid(360.0) as f32,
        sun_altitude_angle: altitude as f32,
        ..WeatherParameters::default()
    };
    match scene.weather {
        Weather::ClearSky => WeatherParameters { cloudiness: 5.0, fog_density: 2.0, ..air },
        Weather::Cloudy => WeatherParameters { cloudiness: 75.0, fog_density: 3.0, ..air },
        Weather::Rainy => WeatherParameters {
            cloudiness: 90.0,
            precipitation: 60.0,
            precipitation_deposits: 60.0,
            wetness: 80.0,
            wind_intensity: 50.0,
            fog_density: 5.0,
            ..air
        },
        Weather::Foggy => {
            WeatherParameters { cloudiness: 60.0, fog_density: 60.0, fog_distance: 5.0, fog_falloff: 0.8, ..air }
        }
        Weather::AfterRain => {
            WeatherParameters { cloudiness: 25.0, precipitation_deposits: 60.0, wetness: 60.0, fog_density: 3.0, ..air }
        }
    }
}
