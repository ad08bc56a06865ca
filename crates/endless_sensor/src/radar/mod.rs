//! Radars.

mod reflecting_area;
#[cfg(test)]
mod tests;

use crate::SweepInterval;
use endless_render::{Ray, RayCaster, RayHit, RayStream};
use endless_world::math::f64::{asin, atan2, ln, sin_cos, tan};
use endless_world::{RadarDetection, RadarScan, RadarSettings, SensorPose, Stream};
use glam::DVec3;
use rayon::prelude::*;
use reflecting_area::reflecting_share;

/// A radar: it tells of reflectors by distance, direction and radial velocity.
///
/// Rays fill the view evenly, each for a small solid angle. What a ray meets has that angle's area, and reflects a share of it
/// that depends on material and incidence. All that falls into one cell of distance, angles and velocity is one reflector: its
/// areas add up, and its place and velocity are those of its strongest part. Waves neither bounce twice nor pass through
/// things; rain and fog, which take about a decibel at 100 m, change nothing.
#[derive(Debug, Clone)]
pub struct Radar {
    settings: RadarSettings,
    seed: u64,
}

/// What one ray brought back.
#[derive(Clone, Copy)]
struct Reflection {
    cell: [i32; 4],
    /// m².
    area: f64,
    detection: RadarDetection,
}

impl Radar {
    /// Rays for each detection that may be delivered, and how many there are at least and at most.
    const RAYS_EACH: f64 = 16.0;
    const LEAST_RAYS: f64 = 4096.0;
    const MOST_RAYS: f64 = 262_144.0;

    /// Of settings that [`RadarSettings::check`] passes; `seed` tells the noise of sensors apart.
    pub fn new(settings: &RadarSettings, seed: u64) -> Self {
        Self { settings: settings.clone(), seed }
    }

    /// Its settings.
    pub fn settings(&self) -> &RadarSettings {
        &self.settings
    }

    /// The detections of a scan at the end of an interval: as many as the interval allows, strongest first. Uses all threads;
    /// the detections do not depend on how many there are.
    pub fn scan(&self, caster: &RayCaster<'_>, interval: &SweepInterval) -> RadarScan {
        let most = (f64::from(self.settings.points_per_second) * interval.sweep_s).round().max(1.0);
        let mut random = Stream::named(self.seed, "radar", &[u64::from(interval.frame)]);
        let mut reflections = self.reflections(caster, &interval.now, most, random.f64());
        // Cells one after another, the strongest of each first. The order of rays is kept where all else is equal.
        reflections.sort_by(|a, b| a.cell.cmp(&b.cell).then(b.area.total_cmp(&a.area)));
        let mut detections: Vec<RadarDetection> =
            reflections.chunk_by(|a, b| a.cell == b.cell).filter_map(|cell| self.detected(cell)).collect();
        detections.sort_by(|a, b| b.power_db.total_cmp(&a.power_db));
        detections.truncate(most as usize);
        detections.iter_mut().for_each(|detection| self.disturb(detection, &mut random));
        RadarScan { detections }
    }

    /// What all rays bring back.
    fn reflections(&self, caster: &RayCaster<'_>, pose: &SensorPose, most: f64, turn: f64) -> Vec<Reflection> {
        /// A turn that never comes near one that was before, as seeds of a sunflower.
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let RadarSettings { horizontal_fov, vertical_fov, range, .. } = self.settings;
        let [wide, high] = [horizontal_fov, vertical_fov].map(|fov| tan(0.5 * f64::from(fov).to_radians()));
        let rays = (Self::RAYS_EACH * most).clamp(Self::LEAST_RAYS, Self::MOST_RAYS).round() as u32;
        // On the plane 1 m ahead the view is an ellipse, as in CARLA.
        let each_m2 = std::f64::consts::PI * wide * high / f64::from(rays);
        let direction = |ray: u32| {
            let out = ((f64::from(ray) + 0.5) / f64::from(rays)).sqrt();
            let (sin, cos) = sin_cos(std::f64::consts::TAU * (turn + GOLDEN * f64::from(ray)).fract());
            DVec3::new(1.0, out * cos * wide, out * sin * high).normalize()
        };
        let bundles: Vec<u32> = (0..rays).step_by(32).collect();
        let of_bundle = |&first: &u32| {
            let mut stream = RayStream::<4>::NONE;
            let count = (rays - first).min(32);
            let directions: Vec<DVec3> = (first..first + count).map(direction).collect();
            for (lane, &in_sensor) in directions.iter().enumerate() {
                let in_world = (pose.world_from_sensor * in_sensor).as_vec3a();
                stream.set(lane, &Ray { origin: pose.position.as_vec3a(), direction: in_world, tmax: range });
            }
            let mut found = Vec::with_capacity(32);
            caster.closest32(&stream, u32::MAX >> (32 - count), |lane, hit| {
                let in_sensor = directions[lane];
                let solid_angle = each_m2 * in_sensor.x * in_sensor.x * in_sensor.x;
                found.extend(self.reflection(&hit, in_sensor, solid_angle, pose));
            });
            found
        };
        let found: Vec<Vec<Reflection>> = bundles.par_iter().map(of_bundle).collect();
        found.concat()
    }

    fn reflection(&self, hit: &RayHit, in_sensor: DVec3, solid_angle: f64, pose: &SensorPose) -> Option<Reflection> {
        let settings = &self.settings;
        let direction = pose.world_from_sensor * in_sensor;
        let depth = f64::from(hit.distance);
        let facing = -hit.normal.dot(direction.as_vec3a());
        let area = f64::from(reflecting_share(hit.surface, facing)) * solid_angle * depth * depth;
        let velocity = (hit.velocity_mps.as_dvec3() - pose.velocity_mps).dot(direction);
        let (azimuth, altitude) = (atan2(in_sensor.y, in_sensor.x), asin(in_sensor.z.clamp(-1.0, 1.0)));
        let bin = |value: f64, step: f32| (value / f64::from(step)).floor() as i32;
        let cell = [
            bin(depth, settings.range_resolution),
            bin(azimuth.to_degrees(), settings.azimuth_resolution),
            bin(altitude.to_degrees(), settings.altitude_resolution),
            bin(velocity, settings.velocity_resolution),
        ];
        let detection = RadarDetection {
            depth_m: hit.distance,
            azimuth_rad: azimuth as f32,
            altitude_rad: altitude as f32,
            velocity_mps: velocity as f32,
            power_db: 0.0,
            tag: hit.tag,
            id: hit.id,
        };
        (area > 0.0).then_some(Reflection { cell, area, detection })
    }

    /// The reflector of a cell, if its echo is strong enough.
    fn detected(&self, cell: &[Reflection]) -> Option<RadarDetection> {
        let area: f64 = cell.iter().map(|reflection| reflection.area).sum();
        let strongest = cell.first()?.detection;
        let decibels = |ratio: f64| 10.0 / std::f64::consts::LN_10 * ln(ratio);
        let power_db = (decibels(area) - 4.0 * decibels(f64::from(strongest.depth_m))) as f32;
        (power_db >= self.settings.min_power).then_some(RadarDetection { power_db, ..strongest })
    }

    fn disturb(&self, detection: &mut RadarDetection, random: &mut Stream) {
        let settings = &self.settings;
        let mut error = |stddev: f32| if stddev > 0.0 { stddev * random.normal() as f32 } else { 0.0 };
        detection.depth_m = (detection.depth_m + error(settings.noise_depth_stddev)).max(0.0);
        detection.azimuth_rad += error(settings.noise_angle_stddev.to_radians());
        detection.altitude_rad += error(settings.noise_angle_stddev.to_radians());
        detection.velocity_mps += error(settings.noise_velocity_stddev);
    }
}
