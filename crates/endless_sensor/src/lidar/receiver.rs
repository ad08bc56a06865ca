//! Which echo of a ray counts, and what is measured of it.

use super::echo::Echo;
use super::fog::FogEchoes;
use super::rain::RainEchoes;
use super::reflectance::returned_share;
use crate::Atmosphere;
use endless_render::RayHit;
use endless_world::math::exp;
use endless_world::{ClassTag, InstanceId, LidarPoint, LidarSettings, Stream};
use glam::{Vec3, Vec3A};

/// What makes points of hits, in one state of the air.
pub(super) struct Receiver<'a> {
    settings: &'a LidarSettings,
    wetness: f32,
    extinction_per_m: f32,
    /// The weakest signal that is told from noise, of that of a white surface at 1 m.
    least_power: f32,
    /// What a drop must be as strong as: also where every surface counts, drops have to be seen.
    least_drop_power: f32,
    rain: Option<RainEchoes>,
    fog: Option<FogEchoes>,
}

impl<'a> Receiver<'a> {
    pub(super) fn new(settings: &'a LidarSettings, atmosphere: &Atmosphere) -> Self {
        let air = if settings.weather_effects { *atmosphere } else { Atmosphere::VACUUM };
        let extinction_per_m = air.extinction_per_m();
        let power_of_10_percent = |distance: f32| 0.1 / (distance * distance);
        let reach = settings.range_10_percent;
        let least_power = if reach > 0.0 { power_of_10_percent(reach) } else { 0.0 };
        let least_drop_power = least_power.max(power_of_10_percent(settings.range));
        let (beam_rad, near_m) = (settings.beam_divergence * 1e-3, settings.min_range.max(0.1));
        Self {
            settings,
            wetness: air.wetness,
            extinction_per_m,
            least_power,
            least_drop_power,
            rain: RainEchoes::new(air.rain_mm_per_h, beam_rad, near_m, extinction_per_m, least_drop_power),
            fog: FogEchoes::new(air.fog_extinction_per_m(), near_m),
        }
    }

    /// What is measured in a direction of the sensor's frame, if anything: `surface` is what the ray meets, and the cosine of
    /// its angle of incidence. Channel and time are left to the caller.
    pub(super) fn receive(
        &self,
        surface: Option<(&RayHit, f32)>,
        direction: Vec3A,
        random: &mut Stream,
    ) -> Option<LidarPoint> {
        let solid = surface.map(|(hit, facing)| {
            let clear = returned_share(hit, facing, self.wetness);
            let strength = clear * exp(-2.0 * self.extinction_per_m * hit.distance);
            (hit, Echo { distance: hit.distance, strength })
        });
        // A surface hides the drops behind it, whether or not its own echo is found.
        let far = solid.as_ref().map_or(self.settings.range, |(hit, _)| hit.distance);
        let solid = solid.filter(|(_, echo)| echo.power() >= self.least_power);
        let beaten = solid.as_ref().map_or(0.0, |(_, echo)| echo.power());
        let drop = self.drop(far, beaten, random);
        let (echo, tag, id, moving) = match (drop, solid) {
            (Some(drop), _) => (drop, ClassTag::Unlabeled, InstanceId::STUFF, false),
            (None, Some((hit, echo))) => {
                let moving = hit.velocity_mps.length_squared() > LidarPoint::MOVING_MPS * LidarPoint::MOVING_MPS;
                (echo, hit.tag, hit.id, moving)
            }
            (None, None) => return None,
        };
        let intensity = (echo.strength * exp(-self.settings.atmosphere_attenuation_rate * echo.distance)).min(1.0);
        if self.dropped(intensity, random) {
            return None;
        }
        let noise = self.settings.noise_stddev;
        let error = if noise > 0.0 { noise * random.normal() as f32 } else { 0.0 };
        let position = Vec3::from(direction * (echo.distance + error).max(0.0));
        Some(LidarPoint { position, intensity, channel: 0, time_s: 0.0, tag, id, moving })
    }

    /// The echo of rain or fog nearer than `far` that beats all others.
    fn drop(&self, far: f32, beaten: f32, random: &mut Stream) -> Option<Echo> {
        let needed = beaten.max(self.least_drop_power);
        let rain = self.rain.as_ref().and_then(|rain| rain.draw(random));
        let fog = self.fog.as_ref().and_then(|fog| fog.draw(random, needed));
        let counts = |echo: &Echo| echo.distance < far;
        rain.filter(|echo| counts(echo) && echo.power() > needed).or(fog.filter(counts))
    }

    /// Whether a point gets lost: CARLA's model.
    fn dropped(&self, intensity: f32, random: &mut Stream) -> bool {
        let LidarSettings { dropoff_general_rate, dropoff_intensity_limit, dropoff_zero_intensity, .. } =
            *self.settings;
        if dropoff_general_rate > 0.0 && random.f32() < dropoff_general_rate {
            return true;
        }
        intensity < dropoff_intensity_limit
            && random.f32() < dropoff_zero_intensity * (1.0 - intensity / dropoff_intensity_limit)
    }
}
