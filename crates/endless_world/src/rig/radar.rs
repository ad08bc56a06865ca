//! Radars: their settings, and what they deliver.

use crate::{ClassTag, InstanceId};
use serde::{Deserialize, Serialize};

/// Settings of a radar. What CARLA knows has the name and the unit of the attribute of its blueprint `sensor.other.radar`: so
/// angles are degrees here.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RadarSettings {
    /// Horizontal field of view, degrees.
    pub horizontal_fov: f32,
    /// Vertical field of view, degrees.
    pub vertical_fov: f32,
    /// Farthest distance, metres.
    pub range: f32,
    /// The most detections a second: of more, the strongest are kept.
    pub points_per_second: u32,
    /// Reflectors that differ by less are one detection, metres.
    pub range_resolution: f32,
    /// Reflectors that differ by less are one detection, degrees.
    pub azimuth_resolution: f32,
    /// Reflectors that differ by less are one detection, degrees.
    pub altitude_resolution: f32,
    /// Reflectors that differ by less are one detection, m/s.
    pub velocity_resolution: f32,
    /// The weakest echo that is detected, decibels over that of a reflecting area of 1 m² at 1 m.
    pub min_power: f32,
    /// Standard deviation of the distance, metres.
    pub noise_depth_stddev: f32,
    /// Standard deviation of azimuth and altitude, degrees.
    pub noise_angle_stddev: f32,
    /// Standard deviation of the velocity, m/s.
    pub noise_velocity_stddev: f32,
}

impl Default for RadarSettings {
    /// Field of view, range and number of detections are CARLA's. Resolutions are those of a usual radar of 77 GHz with two
    /// to four thousand cells. The weakest echo is that of a person (0.5 m²) at 65 m. There is no noise.
    fn default() -> Self {
        Self {
            horizontal_fov: 30.0,
            vertical_fov: 30.0,
            range: 100.0,
            points_per_second: 1500,
            range_resolution: 0.4,
            azimuth_resolution: 1.6,
            altitude_resolution: 3.2,
            velocity_resolution: 0.2,
            min_power: -75.0,
            noise_depth_stddev: 0.0,
            noise_angle_stddev: 0.0,
            noise_velocity_stddev: 0.0,
        }
    }
}

impl RadarSettings {
    /// The most detections a second.
    pub const MAX_POINTS_PER_SECOND: u32 = 1_000_000;

    /// Attributes of CARLA's blueprint `sensor.other.radar` with these values.
    pub fn carla_attributes(&self) -> [(&'static str, f32); 4] {
        [
            ("horizontal_fov", self.horizontal_fov),
            ("vertical_fov", self.vertical_fov),
            ("range", self.range),
            ("points_per_second", self.points_per_second as f32),
        ]
    }

    /// Whether a radar can be like this.
    ///
    /// # Errors
    /// One line: the setting, what it is, and what it may be.
    pub fn check(&self) -> Result<(), String> {
        let bounds = [
            ("horizontal_fov", self.horizontal_fov, 0.1, 170.0),
            ("vertical_fov", self.vertical_fov, 0.1, 170.0),
            ("range", self.range, 0.1, 1000.0),
            ("points_per_second", self.points_per_second as f32, 1.0, Self::MAX_POINTS_PER_SECOND as f32),
            ("range_resolution", self.range_resolution, 0.01, 100.0),
            ("azimuth_resolution", self.azimuth_resolution, 0.01, 90.0),
            ("altitude_resolution", self.altitude_resolution, 0.01, 90.0),
            ("velocity_resolution", self.velocity_resolution, 0.001, 100.0),
            ("min_power", self.min_power, -300.0, 100.0),
            ("noise_depth_stddev", self.noise_depth_stddev, 0.0, 10.0),
            ("noise_angle_stddev", self.noise_angle_stddev, 0.0, 10.0),
            ("noise_velocity_stddev", self.noise_velocity_stddev, 0.0, 10.0),
        ];
        let wrong = bounds.iter().find(|(_, value, low, high)| !(*low..=*high).contains(value));
        wrong.map_or(Ok(()), |(name, value, low, high)| Err(format!("{name}: {value}, must be {low} to {high}")))
    }
}

/// What a radar tells of one reflector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RadarDetection {
    /// Distance from the sensor, metres.
    pub depth_m: f32,
    /// To the left of straight ahead, in the horizontal plane of the sensor, radians. CARLA's grows to the right.
    pub azimuth_rad: f32,
    /// Above that plane, radians.
    pub altitude_rad: f32,
    /// Change of the distance, m/s: negative when coming nearer, as CARLA's program has it (`ARadar::CalculateRelativeVelocity`:
    /// the difference of the velocities of target and radar, along the ray from the radar).
    pub velocity_mps: f32,
    /// Echo, decibels over that of a reflecting area of 1 m² at 1 m.
    pub power_db: f32,
    /// Class of the strongest part of the reflector.
    pub tag: ClassTag,
    /// Object that it belongs to.
    pub id: InstanceId,
}

/// The detections of one scan, strongest first.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RadarScan {
    /// Its detections.
    pub detections: Vec<RadarDetection>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_out_is_the_default() {
        let radar: RadarSettings = serde_json::from_str(r#"{"range": 60.0}"#).expect("fine");
        assert_eq!(radar, RadarSettings { range: 60.0, ..RadarSettings::default() });
        assert_eq!(radar.check(), Ok(()));
        assert!(serde_json::from_str::<RadarSettings>(r#"{"rang": 60.0}"#).is_err());
        let none = RadarSettings { points_per_second: 0, ..radar };
        assert_eq!(none.check(), Err("points_per_second: 0, must be 1 to 1000000".to_owned()));
    }
}
