//! Inertial measurement units: settings and measurements.

use super::noise_check::{at_least_0, finite};
use serde::{Deserialize, Serialize};

/// Noise of an inertial measurement unit, under the names and in the units of CARLA's attributes; all 0 by default, as
/// there. The two random walks are our own.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ImuSettings {
    /// Standard deviation of a sample of the accelerometer, m/s².
    pub noise_accel_stddev_x: f64,
    /// As for x.
    pub noise_accel_stddev_y: f64,
    /// As for x.
    pub noise_accel_stddev_z: f64,
    /// Bias of the accelerometer at sample 0, m/s².
    pub noise_accel_bias_x: f64,
    /// As for x.
    pub noise_accel_bias_y: f64,
    /// As for x.
    pub noise_accel_bias_z: f64,
    /// Standard deviation of a sample of the gyroscope, rad/s.
    pub noise_gyro_stddev_x: f64,
    /// As for x.
    pub noise_gyro_stddev_y: f64,
    /// As for x.
    pub noise_gyro_stddev_z: f64,
    /// Bias of the gyroscope at sample 0, rad/s.
    pub noise_gyro_bias_x: f64,
    /// As for x.
    pub noise_gyro_bias_y: f64,
    /// As for x.
    pub noise_gyro_bias_z: f64,
    /// How far the bias of the accelerometer wanders in a second, each axis: m/s² a root of a second.
    pub accel_bias_walk: f64,
    /// How far the bias of the gyroscope wanders in a second, each axis: rad/s a root of a second.
    pub gyro_bias_walk: f64,
}

impl ImuSettings {
    /// Standard deviation of the accelerometer, m/s².
    pub fn accel_stddev(&self) -> [f64; 3] {
        [self.noise_accel_stddev_x, self.noise_accel_stddev_y, self.noise_accel_stddev_z]
    }

    /// First bias of the accelerometer, m/s².
    pub fn accel_bias(&self) -> [f64; 3] {
        [self.noise_accel_bias_x, self.noise_accel_bias_y, self.noise_accel_bias_z]
    }

    /// Standard deviation of the gyroscope, rad/s.
    pub fn gyro_stddev(&self) -> [f64; 3] {
        [self.noise_gyro_stddev_x, self.noise_gyro_stddev_y, self.noise_gyro_stddev_z]
    }

    /// First bias of the gyroscope, rad/s.
    pub fn gyro_bias(&self) -> [f64; 3] {
        [self.noise_gyro_bias_x, self.noise_gyro_bias_y, self.noise_gyro_bias_z]
    }

    /// Fails with one line on the first setting that cannot be.
    ///
    /// # Errors
    /// When a standard deviation or a walk is below 0, or a number is not finite.
    pub fn check(&self) -> Result<(), String> {
        at_least_0(&[
            ("noise_accel_stddev_x", self.noise_accel_stddev_x),
            ("noise_accel_stddev_y", self.noise_accel_stddev_y),
            ("noise_accel_stddev_z", self.noise_accel_stddev_z),
            ("noise_gyro_stddev_x", self.noise_gyro_stddev_x),
            ("noise_gyro_stddev_y", self.noise_gyro_stddev_y),
            ("noise_gyro_stddev_z", self.noise_gyro_stddev_z),
            ("accel_bias_walk", self.accel_bias_walk),
            ("gyro_bias_walk", self.gyro_bias_walk),
        ])?;
        finite(&[
            ("noise_accel_bias_x", self.noise_accel_bias_x),
            ("noise_accel_bias_y", self.noise_accel_bias_y),
            ("noise_accel_bias_z", self.noise_accel_bias_z),
            ("noise_gyro_bias_x", self.noise_gyro_bias_x),
            ("noise_gyro_bias_y", self.noise_gyro_bias_y),
            ("noise_gyro_bias_z", self.noise_gyro_bias_z),
        ])
    }
}

/// What an inertial measurement unit measures: means over the period that ends at the sample.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ImuMeasurement {
    /// Specific force in the sensor's body frame (x forward, y left, z up), m/s²: 9.81 upwards at rest.
    pub accelerometer_mps2: [f64; 3],
    /// Angular velocity in the body frame, rad/s: positive z turns to the left.
    pub gyroscope_radps: [f64; 3],
    /// Heading of the x axis clockwise from north, 0 to 2π, radians. Without noise.
    pub compass_rad: f64,
}

/// One line of `imu.jsonl`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ImuRecord {
    /// Simulation frame.
    pub frame: u32,
    /// Seconds since frame 0.
    pub time_s: f64,
    /// The measurement.
    #[serde(flatten)]
    pub measurement: ImuMeasurement,
    /// No measurement, but what an integration of those after this line begins with: the velocity in the world, m/s.
    pub velocity_mps: [f64; 3],
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrong_settings_are_named() {
        assert_eq!(ImuSettings::default().check(), Ok(()));
        let wrong = ImuSettings { noise_gyro_stddev_y: -0.1, ..ImuSettings::default() };
        assert_eq!(wrong.check(), Err("noise_gyro_stddev_y is -0.1: use a number of at least 0".to_owned()));
        assert!(ImuSettings { noise_accel_bias_z: f64::NAN, ..ImuSettings::default() }.check().is_err());
    }
}
