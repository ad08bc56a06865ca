//! LiDARs: points by channel, in the sensor's left-handed frame.

use crate::blueprint::SensorKind;
use crate::stream::SensorHeader;
use endless_render::{Ray, RayCaster};
use endless_sensor::{Atmosphere, Lidar, SweepInterval};
use endless_world::{LidarPoint, LidarSettings};
use glam::Vec3A;

/// A sweep: the angle of the head, the number of channels, points in each, and the points.
pub(super) fn message(
    header: &SensorHeader,
    kind: SensorKind,
    settings: &LidarSettings,
    caster: &RayCaster<'_>,
    atmosphere: &Atmosphere,
    interval: &SweepInterval,
    seed: u64,
) -> Vec<u8> {
    let sweep = Lidar::new(settings, seed).sweep(caster, atmosphere, interval);
    let mut channels: Vec<Vec<&LidarPoint>> = vec![Vec::new(); settings.channels as usize];
    for point in &sweep.points {
        if let Some(channel) = channels.get_mut(usize::from(point.channel)) {
            channel.push(point);
        }
    }
    let turned = header.timestamp * f64::from(settings.rotation_frequency) * f64::from(settings.horizontal_fov);
    let angle_rad = turned.rem_euclid(f64::from(settings.horizontal_fov).max(1.0)).to_radians() as f32;
    let mut message = header.begin(8 + 4 * channels.len() + 24 * sweep.points.len());
    message.extend(angle_rad.to_le_bytes());
    message.extend(settings.channels.to_le_bytes());
    // CARLA counts channels from the highest.
    channels.reverse();
    message.extend(channels.iter().flat_map(|points| (points.len() as u32).to_le_bytes()));
    for point in channels.into_iter().flatten() {
        let place = [point.position.x, -point.position.y, point.position.z];
        message.extend(place.iter().flat_map(|number| number.to_le_bytes()));
        if kind == SensorKind::SemanticLidar {
            message.extend(cos_incidence(point, caster, interval).to_le_bytes());
            message.extend(u32::from(point.id.0).to_le_bytes());
            message.extend(u32::from(point.tag.value()).to_le_bytes());
        } else {
            message.extend(point.intensity.to_le_bytes());
        }
    }
    message
}

/// The cosine of the angle between a point's ray and the normal of what it met: a sweep does not keep it.
fn cos_incidence(point: &LidarPoint, caster: &RayCaster<'_>, interval: &SweepInterval) -> f32 {
    let pose = &interval.now;
    let direction = (pose.world_from_sensor * point.position.as_dvec3()).as_vec3().normalize_or_zero();
    let origin = Vec3A::from(pose.position.as_vec3());
    let direction = Vec3A::from(direction);
    let hit = caster.closest(&Ray { origin, direction, tmax: f32::MAX });
    hit.map_or(0.0, |hit| hit.normal.dot(direction).abs().min(1.0))
}
