//! The sun of a video that draws how high it stands.

use crate::condition_mix::by_elevation;
use crate::{Condition, SceneWeather};

/// Where the sun of such a video stands on its way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnSun {
    /// Above the horizon, degrees.
    pub elevation_deg: f32,
    /// Whether it comes up, rather than going down.
    pub rises: bool,
}

impl SceneWeather {
    /// The same with the sun so high, in the light that there is then. It keeps the name of its time, its direction, its air
    /// and its clouds.
    pub(crate) fn with_sun_as_high_as(&self, sun: &DrawnSun) -> Self {
        let values = [self.sun_azimuth_deg, sun.elevation_deg, self.visibility_m, self.scale_height_m];
        let condition = by_elevation(self.weather, sun.elevation_deg).with_values(values);
        Self::of(Condition { time_of_day: self.time_of_day, ..condition }, self.cloud_seed)
    }
}
