//! What the seed draws of a scene's weather: where the sun stands, and how far one sees.

use endless_world::{Condition, Stream, math};
use glam::{Vec2, Vec3};

/// Sun and air of one scene, as its seed draws them from its [`Condition`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SceneWeather {
    /// Of the sun, counter-clockwise from east, radians.
    pub sun_azimuth_rad: f32,
    /// Of the sun above the horizon, radians; below 0 at night.
    pub sun_altitude_rad: f32,
    /// Towards the sun in the world; a unit vector.
    pub sun_direction: Vec3,
    /// Where in the pattern of clouds the scene lies.
    pub(crate) cloud_seed: Vec2,
    /// Meteorological visibility at the ground, metres.
    pub visibility_m: f32,
    /// How much higher the air is thinner by the factor e, metres.
    pub scale_height_m: f32,
}

impl SceneWeather {
    /// Of a scene of this condition and seed.
    pub fn new(condition: &Condition, seed: u64) -> Self {
        let mut random = Stream::named(seed, "environment", &[]);
        let sun_azimuth_rad = condition.sun_azimuth_deg.draw(&mut random).to_radians();
        let sun_altitude_rad = condition.sun_elevation_deg.draw(&mut random).to_radians();
        let (sin_azimuth, cos_azimuth) = math::sin_cos(sun_azimuth_rad);
        let (sin_altitude, cos_altitude) = math::sin_cos(sun_altitude_rad);
        Self {
            sun_azimuth_rad,
            sun_altitude_rad,
            sun_direction: Vec3::new(cos_azimuth * cos_altitude, sin_azimuth * cos_altitude, sin_altitude),
            cloud_seed: Vec2::new(random.range_f32(-500.0, 500.0), random.range_f32(-500.0, 500.0)),
            visibility_m: condition.visibility_m.draw(&mut random),
            scale_height_m: condition.scale_height_m.draw(&mut random),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{TimeOfDay, Weather};

    #[test]
    fn the_sun_stands_where_its_angles_say() {
        for seed in 0..20 {
            for &weather in Weather::ALL {
                for &time in TimeOfDay::ALL {
                    let scene = SceneWeather::new(Condition::of(weather, time), seed);
                    let towards = scene.sun_direction;
                    assert!((towards.length() - 1.0).abs() < 1e-6);
                    assert!((math::asin(towards.z) - scene.sun_altitude_rad).abs() < 1e-5);
                    let turned = math::atan2(towards.y, towards.x) - scene.sun_azimuth_rad;
                    assert!(math::sin(turned).abs() < 1e-5 && math::cos(turned) > 0.9);
                    assert_eq!(towards.z > 0.0, time != TimeOfDay::Night);
                }
            }
        }
    }
}
