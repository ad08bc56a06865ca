//! The light, the air and the wetness of a condition, as a scene draws them by its seed.

use super::{
    Fog, Sky,
    clouds::CloudLayer,
    sky::{LUMINANCE, SOLAR_ILLUMINANCE_KLX, SkyParameters, sun_transmittance},
};
use crate::accel::Ray;
use crate::scene::SurfaceInteraction;
use crate::settings::RenderSettings;
use crate::variation::SurfaceVariation;
use endless_world::math;
use endless_world::math::UnfusedVec3A;
use glam::Vec3A;
use std::f32::consts::{PI, TAU};

/// Light that a town throws into a clear night sky: radiance at the horizon, kcd/m².
const TOWN_SKYGLOW: Vec3A = Vec3A::new(0.0011, 0.0010, 0.0011);
/// Town light scattered back at night by the air itself, kcd/m².
const TOWN_AIRLIGHT: Vec3A = Vec3A::new(0.0042, 0.0039, 0.0038);

/// Directions towards the sun's disc that one sample tests.
pub(crate) const SUN_SAMPLES: usize = 4;

/// The sun, where it shines.
#[derive(Debug, Clone)]
pub(crate) struct Sun {
    /// Towards the centre of its disc.
    pub(crate) direction: Vec3A,
    /// Illuminance of a surface facing it, klx a channel.
    pub(crate) illuminance: Vec3A,
    /// Directions over the disc: [sub-pixel sample][test].
    pub(crate) disc: [[Vec3A; SUN_SAMPLES]; 4],
}

/// Everything about light, air and wetness in one scene.
#[derive(Debug, Clone)]
pub(crate) struct Environment {
    /// `None` at night and under a closed sky.
    pub(crate) sun: Option<Sun>,
    pub(crate) sky: Sky,
    pub(crate) fog: Fog,
    /// Street lamps, windows and signs are lit, or some of them.
    pub(crate) night: bool,
    /// Share of them that are lit.
    pub(crate) lamps_lit: f32,
    /// 0 dry to 1 soaked.
    pub(crate) wetness: f32,
    /// Share of wet ground that is puddle.
    pub(crate) puddles: f32,
    /// Rain drops in the air, 0 to 1.
    pub(crate) rain: f32,
    /// How much of the middle grey the exposure aims for: night should look like night.
    pub(crate) exposure_key: f32,
    /// Share of the light that spreads around bright objects.
    pub(crate) glare: f32,
    /// What surfaces vary in this scene; `None` where they are as they are made.
    pub(crate) surfaces: Option<SurfaceVariation>,
}

impl Environment {
    /// The light of a scene whose ground lies at this height, metres.
    pub(crate) fn new(settings: &RenderSettings, ground: f32) -> Self {
        let weather = &settings.weather;
        let [sun_light, sky_light] = settings.light().map_or([Vec3A::ONE; 2], |l| [l.sun, l.sky].map(Vec3A::from));
        let sun_direction = Vec3A::from(weather.sun_direction);
        let low_light = Vec3A::from(weather.low_light);
        let dust = Vec3A::from(weather.dust_color);
        let clouds = (weather.cloud_cover > 0.0).then(|| CloudLayer {
            cover: weather.cloud_cover,
            lit: low_light * (14.0 * weather.cloud_brightness),
            dark: Vec3A::new(0.80, 0.9, 1.05) * (6.0 * weather.cloud_brightness),
            seed: weather.cloud_seed,
        });
        let sky = Sky::new(&SkyParameters {
            sun_direction,
            turbidity: weather.turbidity,
            overcast: weather.overcast,
            overcast_klx: weather.overcast_klx,
            glow: TOWN_SKYGLOW * weather.skyglow,
            clouds,
        })
        .tinted(sky_light * dust);
        let night = weather.lamps_lit > 0.0;
        // Lamps are lit when the sun is down.
        let sun = (weather.sun_share > 0.0 && sun_direction.z > 0.0 && !night).then(|| Sun {
            direction: sun_direction,
            illuminance: sun_transmittance(sun_direction, weather.turbidity)
                * (SOLAR_ILLUMINANCE_KLX * weather.sun_share)
                * sun_light
                * dust,
            disc: sun_disc(sun_direction),
        });
        let fog = Fog {
            extinction: Fog::extinction_for_visibility(weather.visibility_m),
            ground,
            scale_height_m: weather.scale_height_m,
            glow: weather.halo,
            airlight: sky.mean * weather.airlight + TOWN_AIRLIGHT * sky_light * weather.town_airlight,
            sunward: low_light * sky.mean * weather.sunward,
            sun_direction,
        };
        Self {
            sun,
            sky,
            fog,
            night,
            lamps_lit: weather.lamps_lit,
            wetness: weather.wetness,
            puddles: weather.puddles,
            rain: weather.rain,
            exposure_key: weather.exposure_key,
            glare: weather.glare,
            surfaces: settings.randomised.as_ref().and_then(SurfaceVariation::new),
        }
    }

    /// Factors by channel with which a camera makes most of the daylight's colour white; at night cameras keep that of a
    /// mean lamp.
    pub(crate) fn white_balance(&self) -> Vec3A {
        const STRENGTH: f32 = 0.7;
        if self.lamps_lit == 1.0 {
            return Vec3A::ONE;
        }
        let sun = self.sun.as_ref().map_or(Vec3A::ZERO, |sun| sun.illuminance * sun.direction.z);
        let light = sun + self.sky.mean * PI;
        let white = light.dot(LUMINANCE) / light.max(Vec3A::splat(1e-6));
        Vec3A::ONE.lerp_unfused(white, STRENGTH * (1.0 - self.lamps_lit))
    }

    /// Whether lamps glow in the air.
    pub(crate) fn halos(&self) -> bool {
        self.night && self.fog.is_dense()
    }
}

impl Sun {
    /// Towards the disc's centre, from where it can light a point.
    pub(crate) fn ray_from(&self, point: &SurfaceInteraction<'_>) -> Option<Ray> {
        let faces = point.geometric_normal.dot(self.direction) > 0.0;
        faces.then(|| Ray { origin: point.ray_origin(), direction: self.direction, tmax: f32::MAX })
    }

    /// The parts of the disc as what moves hides them from a sample: the directions of [`Self::disc`] that a part stands
    /// for, a bit each, and the one to ask. A sample of a `uniform` pixel asks but one: its neighbours ask others.
    pub(crate) fn parts(&self, sample: usize, uniform: bool) -> [(u8, Vec3A); 2] {
        let disc = &self.disc[sample];
        let bits = match (uniform, sample % 2) {
            (false, _) => [0b0011, 0b1100],
            (true, 0) => [0b1111, 0],
            (true, _) => [0, 0b1111],
        };
        [(bits[0], disc[1]), (bits[1], disc[2])]
    }
}

/// A sunflower over the disc, dealt out to the four sub-pixel samples. The disc is drawn half as large again as the
/// sun's 0.27°: thin haze around it shines too.
fn sun_disc(direction: Vec3A) -> [[Vec3A; SUN_SAMPLES]; 4] {
    const RADIUS_RAD: f32 = 0.0070;
    let (a, b) = direction.any_orthonormal_pair();
    let mut disc = [[direction; SUN_SAMPLES]; 4];
    for i in 0..SUN_SAMPLES * 4 {
        let radius = ((i as f32 + 0.5) / (SUN_SAMPLES * 4) as f32).sqrt() * RADIUS_RAD;
        let (sin, cos) = math::sin_cos(i as f32 * TAU * 0.618_034);
        disc[i % 4][i / 4] = (direction + a * (radius * cos) + b * (radius * sin)).normalize();
    }
    disc
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{ImageSize, TimeOfDay, Weather};

    #[test]
    fn conditions_differ_as_they_should() {
        let size = ImageSize { width: 16, height: 9 };
        let light = |w, t| Environment::new(&RenderSettings::new(w, t, 5, size), 0.0);
        let noon = light(Weather::ClearSky, TimeOfDay::Afternoon);
        let dawn = light(Weather::ClearSky, TimeOfDay::Morning);
        let (high, low) = (noon.sun.expect("sun"), dawn.sun.expect("sun"));
        assert!(high.direction.z > 2.0 * low.direction.z);
        assert!(low.illuminance.x / low.illuminance.z > 1.3 * high.illuminance.x / high.illuminance.z);
        for weather in Weather::ALL {
            let night = light(*weather, TimeOfDay::Night);
            assert!(night.sun.is_none() && night.night);
            assert!(night.sky.mean.y * 200.0 < light(*weather, TimeOfDay::Afternoon).sky.mean.y);
        }
        assert!(light(Weather::Rainy, TimeOfDay::Morning).sun.is_none());
        assert!(light(Weather::Foggy, TimeOfDay::Morning).fog.extinction > 50.0 * noon.fog.extinction);
    }
}
