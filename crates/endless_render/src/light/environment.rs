//! Weather and time of day as light: fifteen conditions, varied by the scene's seed within each.

use super::{
    Fog, Sky,
    clouds::Clouds,
    sky::{LUMINANCE, SOLAR_ILLUMINANCE_KLX, SkyParameters, sun_transmittance},
};
use crate::accel::Ray;
use crate::scene::SurfaceInteraction;
use endless_world::{Stream, TimeOfDay, Weather, math};
use glam::{Vec2, Vec3A};
use std::f32::consts::{PI, TAU};

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
    /// Street lamps, windows and signs are lit.
    pub(crate) night: bool,
    /// 0 dry to 1 soaked.
    pub(crate) wetness: f32,
    /// Share of wet ground that is puddle.
    pub(crate) puddles: f32,
    /// Rain drops in the air, 0 to 1.
    pub(crate) rain: f32,
    /// How much of the middle grey the exposure aims for: night should look like night.
    pub(crate) exposure_key: f32,
    /// Share of the light that spreads around bright things.
    pub(crate) glare: f32,
}

impl Environment {
    /// The light of a scene whose ground lies at this height, metres.
    pub(crate) fn new(weather: Weather, time: TimeOfDay, seed: u64, ground: f32) -> Self {
        let mut random = Stream::named(seed, "environment", &[]);
        let sun_direction = sun_direction(time, &mut random);
        let night = time == TimeOfDay::Night;
        let morning = time == TimeOfDay::Morning;
        let day_light = if morning { 0.45 } else { 1.0 };
        let glow = if night { Vec3A::new(0.0011, 0.0010, 0.0011) } else { Vec3A::ZERO };
        let cloud_seed = Vec2::new(random.range_f32(-500.0, 500.0), random.range_f32(-500.0, 500.0));
        let warm = if morning { Vec3A::new(1.0, 0.86, 0.72) } else { Vec3A::ONE };
        let (turbidity, overcast, overcast_klx, cover) = match weather {
            Weather::ClearSky => (if morning { 3.0 } else { 2.2 }, 0.0, 0.0, 0.28),
            Weather::Cloudy => (3.0, 0.93, 17.0, 0.0),
            Weather::Rainy => (4.0, 1.0, 8.0, 0.0),
            Weather::Foggy => (5.0, 0.96, 12.0, 0.0),
            Weather::AfterRain => (2.0, 0.12, 10.0, 0.55),
        };
        let clouds = (cover > 0.0 && !night).then(|| Clouds {
            cover,
            lit: warm * (14.0 * day_light),
            dark: Vec3A::new(0.80, 0.9, 1.05) * (6.0 * day_light),
            seed: cloud_seed,
        });
        let sky = Sky::new(&SkyParameters {
            sun_direction,
            turbidity,
            overcast: if night { 0.0 } else { overcast },
            overcast_klx: overcast_klx * day_light,
            glow: glow * if matches!(weather, Weather::ClearSky) { 1.0 } else { 1.9 },
            clouds,
        });
        // What haze and clouds leave of the sun.
        let sun_share = match weather {
            Weather::ClearSky => 1.0,
            Weather::AfterRain => 0.8,
            Weather::Cloudy | Weather::Rainy | Weather::Foggy => 0.0,
        };
        let sun = (!night && sun_share > 0.0).then(|| Sun {
            direction: sun_direction,
            illuminance: sun_transmittance(sun_direction, turbidity) * (SOLAR_ILLUMINANCE_KLX * sun_share),
            disc: sun_disc(sun_direction),
        });
        let visibility_m = match weather {
            Weather::ClearSky => 14_000.0,
            Weather::Cloudy => 7_000.0,
            Weather::AfterRain => 9_000.0,
            Weather::Rainy => random.range_f32(900.0, 1600.0),
            Weather::Foggy => random.range_f32(110.0, 200.0),
        };
        let horizon = sky.mean;
        let sunward = match (weather, night) {
            (_, true) => Vec3A::ZERO,
            (Weather::Foggy, _) => warm * horizon * if morning { 0.9 } else { 0.35 },
            (Weather::ClearSky | Weather::AfterRain, _) => warm * horizon * 0.8,
            _ => Vec3A::ZERO,
        };
        let airlight = if night {
            // Town light scattered back by the air itself.
            Vec3A::new(0.0042, 0.0039, 0.0038)
                * match weather {
                    Weather::Foggy => 0.42,
                    Weather::Rainy => 0.12,
                    _ => 0.30,
                }
        } else {
            horizon * if weather == Weather::Foggy { 0.9 } else { 0.85 }
        };
        let (wetness, puddles, rain) = match weather {
            Weather::Rainy => (1.0, 0.42, 1.0),
            Weather::AfterRain => (0.75, 0.36, 0.0),
            Weather::Foggy => (0.12, 0.0, 0.0),
            Weather::ClearSky | Weather::Cloudy => (0.0, 0.0, 0.0),
        };
        // Droplets in the air and on the lens spread bright light.
        let glare = match weather {
            _ if !night => 0.0,
            Weather::Foggy => 0.13,
            Weather::Rainy => 0.10,
            _ => 0.06,
        };
        let exposure_key = match (time, weather) {
            (TimeOfDay::Night, Weather::Foggy | Weather::Rainy) => 0.075,
            (TimeOfDay::Night, _) => 0.065,
            (TimeOfDay::Morning, Weather::ClearSky | Weather::AfterRain) => 0.19,
            (TimeOfDay::Morning, Weather::Foggy) => 0.27,
            (TimeOfDay::Morning, _) => 0.165,
            (TimeOfDay::Afternoon, Weather::Foggy) => 0.34,
            (TimeOfDay::Afternoon, Weather::Rainy) => 0.20,
            (TimeOfDay::Afternoon, Weather::Cloudy) => 0.235,
            (TimeOfDay::Afternoon, _) => 0.235,
        };
        Self {
            sun,
            sky,
            fog: Fog {
                extinction: Fog::extinction_for_visibility(visibility_m),
                ground,
                // Haze and rain reach high up; fog lies on the ground as it cools.
                scale_height_m: if weather == Weather::Foggy { random.range_f32(35.0, 70.0) } else { 1200.0 },
                glow: if weather == Weather::Rainy { 0.5 } else { 0.65 },
                airlight,
                sunward,
                sun_direction,
            },
            night,
            wetness,
            puddles,
            rain,
            exposure_key,
            glare,
        }
    }

    /// Factors by channel with which a camera makes most of the daylight's colour white; at night cameras keep that of a
    /// mean lamp.
    pub(crate) fn white_balance(&self) -> Vec3A {
        const STRENGTH: f32 = 0.7;
        if self.night {
            return Vec3A::ONE;
        }
        let sun = self.sun.as_ref().map_or(Vec3A::ZERO, |sun| sun.illuminance * sun.direction.z);
        let light = sun + self.sky.mean * PI;
        let white = light.dot(LUMINANCE) / light.max(Vec3A::splat(1e-6));
        Vec3A::ONE.lerp(white, STRENGTH)
    }

    /// Whether lamps glow in the air.
    pub(crate) fn halos(&self) -> bool {
        self.night && self.fog.is_dense()
    }
}

/// Morning: low in the east; afternoon: high in the south to south-west; night: below the horizon.
fn sun_direction(time: TimeOfDay, random: &mut Stream) -> Vec3A {
    let (azimuth_deg, elevation_deg) = match time {
        TimeOfDay::Morning => (random.range_f32(-25.0, 35.0), random.range_f32(11.0, 19.0)),
        TimeOfDay::Afternoon => (random.range_f32(215.0, 285.0), random.range_f32(42.0, 60.0)),
        TimeOfDay::Night => (random.range_f32(0.0, 360.0), -40.0),
    };
    let (sin_azimuth, cos_azimuth) = math::sin_cos(azimuth_deg.to_radians());
    let (sin_elevation, cos_elevation) = math::sin_cos(elevation_deg.to_radians());
    Vec3A::new(cos_azimuth * cos_elevation, sin_azimuth * cos_elevation, sin_elevation)
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

    #[test]
    fn conditions_differ_as_they_should() {
        let light = |w, t| Environment::new(w, t, 5, 0.0);
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
