//! Sun, sky, air and ground of one scene at one instant, as numbers.

use crate::math::sin_cos;
use crate::{Condition, LightVariation, Stream, TimeOfDay, Weather};
use glam::{Vec2, Vec3};
use std::ops::Deref;

/// What a scene has drawn of a [`Condition`] by its seed, or what it has come to while the condition changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SceneWeather {
    condition: Condition<f32>,
    /// Of the sun, counter-clockwise from east, radians.
    pub sun_azimuth_rad: f32,
    /// Of the sun above the horizon, radians; below 0 at night.
    pub sun_altitude_rad: f32,
    /// Towards the sun in the world; a unit vector.
    pub sun_direction: Vec3,
    /// Where in the pattern of clouds the scene lies.
    pub cloud_seed: Vec2,
    /// Share of the sky that clouds cover, 0 to 1, also at night.
    pub cloudiness: f32,
}

impl SceneWeather {
    /// Of a scene of this condition and seed.
    pub fn new(weather: Weather, time_of_day: TimeOfDay, seed: u64) -> Self {
        let condition = Condition::of(weather, time_of_day);
        let mut random = Stream::named(seed, "environment", &[]);
        let azimuth = condition.sun_azimuth_deg.draw(&mut random);
        let elevation = condition.sun_elevation_deg.draw(&mut random);
        let cloud_seed = Vec2::new(random.range_f32(-500.0, 500.0), random.range_f32(-500.0, 500.0));
        let visibility_m = condition.visibility_m.draw(&mut random);
        let scale_height_m = condition.scale_height_m.draw(&mut random);
        Self::of(condition.with_values([azimuth, elevation, visibility_m, scale_height_m]), cloud_seed)
    }

    /// Of these quantities.
    pub(crate) fn of(condition: Condition<f32>, cloud_seed: Vec2) -> Self {
        let sun_azimuth_rad = condition.sun_azimuth_deg.to_radians();
        let sun_altitude_rad = condition.sun_elevation_deg.to_radians();
        let (sin_azimuth, cos_azimuth) = sin_cos(sun_azimuth_rad);
        let (sin_altitude, cos_altitude) = sin_cos(sun_altitude_rad);
        let sun_direction = Vec3::new(cos_azimuth * cos_altitude, sin_azimuth * cos_altitude, sin_altitude);
        // The table tells of clouds by day: at night they are seen by the light of the town alone.
        let by_day = Condition::of(condition.weather, TimeOfDay::Afternoon);
        let cloudiness = by_day.overcast.max(by_day.cloud_cover);
        Self { condition, sun_azimuth_rad, sun_altitude_rad, sun_direction, cloud_seed, cloudiness }
    }

    /// The same in a video's own light.
    #[must_use]
    pub fn varied(self, light: &LightVariation) -> Self {
        Self::of(light.of(&self.condition), self.cloud_seed).with_cloudiness(self.cloudiness)
    }

    /// Under so many clouds.
    pub(crate) fn with_cloudiness(self, cloudiness: f32) -> Self {
        Self { cloudiness, ..self }
    }

    /// The same with the sun elsewhere: where an arrow of any length points; one of no length changes nothing.
    #[must_use]
    pub fn with_sun(self, towards: Vec3) -> Self {
        let sun_direction = towards.normalize_or(self.sun_direction);
        let sun_altitude_rad = crate::math::asin(sun_direction.z);
        let sun_azimuth_rad = crate::math::atan2(sun_direction.y, sun_direction.x);
        Self { sun_azimuth_rad, sun_altitude_rad, sun_direction, ..self }
    }
}

impl Deref for SceneWeather {
    type Target = Condition<f32>;

    fn deref(&self) -> &Condition<f32> {
        &self.condition
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math;

    #[test]
    fn the_sun_stands_where_its_angles_say() {
        for seed in 0..20 {
            for &weather in Weather::ALL {
                for &time in TimeOfDay::ALL {
                    let scene = SceneWeather::new(weather, time, seed);
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
