//! Where the sun of a scene stands, as its settings tell.

use crate::{DrawnSun, SceneSettings, SceneWeather, TimeOfDay};

impl DrawnSun {
    /// Of a scene, if its video draws it. While the time of day changes the sun goes its own way, and nothing is drawn.
    pub fn of(settings: &SceneSettings) -> Option<Self> {
        let SceneSettings { weather, time_of_day, seed, changing_to, .. } = *settings;
        let moves = changing_to.is_some_and(|to| to.time_of_day != time_of_day);
        let elevation_deg = settings.sun_elevation_deg.filter(|_| !moves)?;
        let rises = match time_of_day {
            TimeOfDay::Morning => true,
            TimeOfDay::Afternoon => false,
            // It goes round all the sky by night: dawns are in the east.
            TimeOfDay::Night => SceneWeather::new(weather, time_of_day, seed).sun_direction.x > 0.0,
        };
        Some(Self { elevation_deg, rises })
    }
}

impl SceneWeather {
    /// Of a scene at its first frame, in the light that nothing varies.
    pub fn of_scene(settings: &SceneSettings) -> Self {
        let usual = Self::new(settings.weather, settings.time_of_day, settings.seed);
        DrawnSun::of(settings).map_or(usual, |sun| usual.with_sun_as_high_as(&sun))
    }
}
