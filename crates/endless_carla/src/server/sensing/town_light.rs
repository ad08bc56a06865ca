//! Sun, sky and lamps of an episode, and what bounces off its streets: the same for all its cameras.

use crate::server::loaded_map::LoadedMap;
use crate::server::quality_level::QualityLevel;
use endless_render::{LocalLight, RenderSettings, RoamingLight, StaticScene};
use endless_world::math::ln;
use endless_world::{ImageSize, SceneWeather, SensorPose, TimeOfDay, Weather};

/// What does not depend on the camera.
#[derive(Clone, Copy)]
pub(super) struct Light<'a> {
    pub(super) still: &'a StaticScene,
    pub(super) weather: SceneWeather,
    pub(super) seed: u64,
    pub(super) quality: QualityLevel,
    /// Since the frame before, seconds.
    pub(super) step_s: f64,
}

impl Light<'_> {
    /// How pictures of this size are made.
    pub(super) fn settings(&self, size: ImageSize) -> RenderSettings {
        RenderSettings {
            weather: self.weather,
            fps: if self.step_s > 0.0 { 1.0 / self.step_s } else { 30.0 },
            ..RenderSettings::new(Weather::ClearSky, TimeOfDay::Afternoon, self.seed, size)
        }
    }

    /// Whether what was found in another weather does for this one.
    pub(super) fn is_as_in(&self, other: &SceneWeather) -> bool {
        difference(&self.weather, other) < 1.0
    }
}

/// The light for cameras that move.
#[derive(Default)]
pub(super) struct TownLight(Option<RoamingLight>);

impl TownLight {
    /// Around a camera.
    pub(super) fn around(&mut self, map: &LoadedMap, light: &Light<'_>, pose: &SensorPose) -> LocalLight {
        /// Of a weather so different nothing is kept.
        const ANOTHER: f32 = 8.0;
        let known = self.0.take().and_then(|mut known| {
            let difference = difference(&light.weather, known.weather());
            if (1.0..ANOTHER).contains(&difference) {
                known.change(light.still, light.weather);
            }
            (difference < ANOTHER).then_some(known)
        });
        let anew = || {
            let settings = light.settings(ImageSize { width: 1, height: 1 });
            RoamingLight::new(light.still, &settings, map.roads.lowest_m())
        };
        self.0.insert(known.unwrap_or_else(anew)).around(light.still, pose.position.as_vec3())
    }
}

/// How different two weathers are: below 1, nobody sees it.
fn difference(a: &SceneWeather, b: &SceneWeather) -> f32 {
    /// The sun's way in some four minutes, radians.
    const SUN_RAD: f32 = 0.0175;
    if (a.lamps_lit > 0.0) != (b.lamps_lit > 0.0) {
        return f32::INFINITY;
    }
    let apart = |of: fn(&SceneWeather) -> f32, least: f32| (of(a) - of(b)).abs() / least;
    let ratio = |of: fn(&SceneWeather) -> f32| ln(of(a) / of(b)).abs() / 0.05;
    [
        a.sun_direction.distance(b.sun_direction) / SUN_RAD,
        apart(|w| w.sun_share, 0.02),
        apart(|w| w.overcast, 0.02),
        apart(|w| w.cloud_cover, 0.02),
        apart(|w| w.skyglow, 0.05),
        apart(|w| w.rain, 0.02),
        apart(|w| w.wetness, 0.02),
        apart(|w| w.puddles, 0.02),
        apart(|w| w.lamps_lit, 0.02),
        apart(|w| w.airlight, 0.02),
        apart(|w| w.town_airlight, 0.02),
        apart(|w| w.sunward, 0.05),
        apart(|w| w.cloud_brightness, 0.05),
        apart(|w| w.low_light[2], 0.02),
        apart(|w| w.dust_color[2], 0.02),
        apart(|w| w.glare, 0.01),
        apart(|w| w.exposure_key, 0.004),
        apart(|w| w.turbidity, 0.1),
        apart(|w| w.overcast_klx, 0.3),
        ratio(|w| w.visibility_m),
        ratio(|w| w.scale_height_m),
    ]
    .into_iter()
    .fold(0.0, f32::max)
}
