//! LiDARs.

mod echo;
mod fog;
mod rain;
mod receiver;
mod reflectance;
mod scan;
#[cfg(test)]
mod tests;

use crate::{Atmosphere, SweepInterval};
use endless_render::{Ray, RayCaster, RayHit, RayStream};
use endless_world::{LidarPoint, LidarSettings, LidarSweep, Stream};
use glam::{DQuat, DVec3, Vec3A};
use rayon::prelude::*;
use receiver::Receiver;
use scan::{Scan, ScanGroup};

/// A LiDAR: it measures distances in a grid of directions, one after another.
///
/// Lasers are rays without width, which meet the surface behind their middle. The strongest echo of each counts: that of the
/// surface, or that of a drop before it. See `docs/lidar.md` for what the models are taken from.
#[derive(Debug, Clone)]
pub struct Lidar {
    settings: LidarSettings,
    seed: u64,
}

/// A direction of a group in the sensor's frame, and what its ray met.
#[derive(Clone, Copy)]
struct Cell {
    direction: Vec3A,
    /// Cosine of the angle of incidence.
    facing: f32,
    hit: Option<RayHit>,
}

impl Lidar {
    /// Of settings that [`LidarSettings::check`] passes; `seed` tells the noise of sensors apart.
    pub fn new(settings: &LidarSettings, seed: u64) -> Self {
        Self { settings: settings.clone(), seed }
    }

    /// Its settings.
    pub fn settings(&self) -> &LidarSettings {
        &self.settings
    }

    /// The points of a sweep, in the order in which they are measured. Uses all threads; the points do not depend on how many
    /// there are.
    pub fn sweep(&self, caster: &RayCaster<'_>, atmosphere: &Atmosphere, interval: &SweepInterval) -> LidarSweep {
        let scan = Scan::new(&self.settings, interval.sweep_s, interval.frame);
        let receiver = Receiver::new(&self.settings, atmosphere);
        let groups = scan.groups();
        let measure = |(number, group): (usize, &ScanGroup)| {
            let mut random = Stream::named(self.seed, "lidar", &[u64::from(interval.frame), number as u64]);
            let mut points = Vec::with_capacity(group.len());
            let cells = self.cast(caster, &scan, group, interval);
            for column in group.columns.clone() {
                for channel in group.channels.clone() {
                    let Cell { direction, facing, hit } = &cells[group.place(channel, column)];
                    let surface = hit.as_ref().map(|hit| (hit, *facing));
                    let Some(found) = receiver.receive(surface, *direction, &mut random) else { continue };
                    let time_s = (scan.time(channel, column) * interval.sweep_s) as f32;
                    points.push(LidarPoint { channel: channel as u16, time_s, ..found });
                }
            }
            points
        };
        let points: Vec<Vec<LidarPoint>> = groups.par_iter().enumerate().map(measure).collect();
        LidarSweep { points: points.concat() }
    }

    /// What the rays of a group meet, in the order of time.
    fn cast(&self, caster: &RayCaster<'_>, scan: &Scan, group: &ScanGroup, interval: &SweepInterval) -> Vec<Cell> {
        let near = self.settings.min_range;
        let mut cells = vec![Cell { direction: Vec3A::ZERO, facing: 0.0, hit: None }; group.len()];
        let mut place = (f64::NAN, (DVec3::ZERO, DQuat::IDENTITY));
        for bundle in group.bundles() {
            let mut rays = RayStream::<4>::NONE;
            let mut directions = [Vec3A::ZERO; 32];
            let mut active = 0;
            for (lane, &(channel, column)) in bundle.iter().enumerate() {
                let time = if self.settings.motion_distortion { scan.time(channel, column) } else { 1.0 };
                if time != place.0 {
                    place = (time, interval.place_at(time));
                }
                let (position, turn) = place.1;
                let in_sensor = scan.direction(channel, column);
                let in_world = turn * in_sensor;
                let origin = (position + in_world * f64::from(near)).as_vec3a();
                directions[lane] = in_world.as_vec3a();
                rays.set(lane, &Ray { origin, direction: directions[lane], tmax: self.settings.range - near });
                cells[group.place(channel, column)].direction = in_sensor.as_vec3a();
                active |= 1 << lane;
            }
            caster.closest32(&rays, active, |lane, hit| {
                let (channel, column) = bundle[lane];
                let cell = &mut cells[group.place(channel, column)];
                cell.facing = -hit.normal.dot(directions[lane]);
                cell.hit = Some(RayHit { distance: hit.distance + near, ..hit });
            });
        }
        cells
    }
}
