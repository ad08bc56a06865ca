//! Satellite navigation: settings and measurements.

use super::noise_check::{at_least_0, finite};
use serde::{Deserialize, Serialize};

/// Noise of a receiver, under the names and in the units of CARLA's attributes; all 0 by default, as there.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct GnssSettings {
    /// Degrees.
    pub noise_lat_bias: f64,
    /// Degrees; a metre to the north is 9.0e-6.
    pub noise_lat_stddev: f64,
    /// Degrees.
    pub noise_lon_bias: f64,
    /// Degrees; a metre to the east is 9.0e-6 over the cosine of the latitude.
    pub noise_lon_stddev: f64,
    /// Metres.
    pub noise_alt_bias: f64,
    /// Metres.
    pub noise_alt_stddev: f64,
}

impl GnssSettings {
    /// Fails with one line on the first setting that cannot be.
    ///
    /// # Errors
    /// When a standard deviation is below 0, or a number is not finite.
    pub fn check(&self) -> Result<(), String> {
        at_least_0(&[
            ("noise_lat_stddev", self.noise_lat_stddev),
            ("noise_lon_stddev", self.noise_lon_stddev),
            ("noise_alt_stddev", self.noise_alt_stddev),
        ])?;
        finite(&[
            ("noise_lat_bias", self.noise_lat_bias),
            ("noise_lon_bias", self.noise_lon_bias),
            ("noise_alt_bias", self.noise_alt_bias),
        ])
    }
}

/// A place on Earth, WGS 84.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct GnssMeasurement {
    /// North is positive, degrees.
    pub latitude_deg: f64,
    /// East is positive, degrees.
    pub longitude_deg: f64,
    /// Metres above the height 0 of the map.
    pub altitude_m: f64,
}

/// One line of `gnss.jsonl`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct GnssRecord {
    /// Simulation frame.
    pub frame: u32,
    /// Seconds since frame 0.
    pub time_s: f64,
    /// The measurement.
    #[serde(flatten)]
    pub measurement: GnssMeasurement,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrong_settings_are_named() {
        assert_eq!(GnssSettings::default().check(), Ok(()));
        let wrong = GnssSettings { noise_alt_stddev: f64::INFINITY, ..GnssSettings::default() };
        assert_eq!(wrong.check(), Err("noise_alt_stddev is inf: use a number of at least 0".to_owned()));
        assert!(GnssSettings { noise_lat_bias: f64::NAN, ..GnssSettings::default() }.check().is_err());
    }
}
