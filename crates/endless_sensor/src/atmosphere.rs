//! What the air holds that light has to pass.

use endless_world::SceneWeather;

/// Air and ground as a LiDAR meets them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Atmosphere {
    /// Meteorological visibility, metres (Koschmieder 1924: contrast falls to 2 %); infinite in a vacuum.
    pub visibility_m: f32,
    /// Rain that falls, millimetres an hour.
    pub rain_mm_per_h: f32,
    /// Wetness of the ground, 0 dry to 1 soaked.
    pub wetness: f32,
}

impl Atmosphere {
    /// Nothing at all.
    pub const VACUUM: Self = Self { visibility_m: f32::INFINITY, rain_mm_per_h: 0.0, wetness: 0.0 };
    /// Rain of a scene in which it rains fully: the border of moderate and heavy rain (WMO-No. 8).
    const FULL_RAIN_MM_PER_H: f32 = 10.0;
    /// Fog by definition (WMO-No. 8), metres.
    const FOG_VISIBILITY_M: f32 = 1000.0;

    /// Loss of light along a path, 1/m: drops of fog and rain are far larger than the waves of visible and of near infrared
    /// light, and take as much of either.
    pub(crate) fn extinction_per_m(&self) -> f32 {
        3.912 / self.visibility_m
    }

    /// The part of it that droplets of fog are the cause of.
    pub(crate) fn fog_extinction_per_m(&self) -> f32 {
        let foggy = self.rain_mm_per_h == 0.0 && self.visibility_m < Self::FOG_VISIBILITY_M;
        if foggy { self.extinction_per_m() } else { 0.0 }
    }
}

impl From<&SceneWeather> for Atmosphere {
    fn from(weather: &SceneWeather) -> Self {
        Self {
            visibility_m: weather.visibility_m,
            rain_mm_per_h: weather.rain * Self::FULL_RAIN_MM_PER_H,
            wetness: weather.wetness,
        }
    }
}
