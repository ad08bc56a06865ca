//! Settings of a LiDAR.

use super::beams::LidarBeam;
use super::preset::{LidarPreset, ScanPattern};
use serde::{Deserialize, Serialize};

macro_rules! lidar_settings {
    ($($(#[$doc:meta])* $name:ident: $kind:ty,)*) => {
        /// Settings of a LiDAR. What CARLA knows has the name and the unit of the attribute of its blueprint
        /// `sensor.lidar.ray_cast`: so angles are degrees here. In files, whatever is left out is as the preset has it.
        #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
        #[serde(from = "LidarKeys")]
        pub struct LidarSettings {
            /// Device that the others are defaults of.
            pub preset: LidarPreset,
            $($(#[$doc])* pub $name: $kind,)*
        }

        /// Those that a file gives.
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct LidarKeys {
            preset: Option<LidarPreset>,
            $($name: Option<$kind>,)*
        }

        impl From<LidarKeys> for LidarSettings {
            fn from(keys: LidarKeys) -> Self {
                let preset = LidarSettings::of(keys.preset.unwrap_or_default());
                Self { preset: preset.preset, $($name: keys.$name.unwrap_or(preset.$name),)* }
            }
        }
    };
}

lidar_settings! {
    /// In which order directions are measured.
    scan: ScanPattern,
    /// Number of lasers above one another.
    channels: u32,
    /// Farthest distance, metres.
    range: f32,
    /// Nearest distance, metres: what is nearer is looked through.
    min_range: f32,
    /// Distance at which a surface of 10 % reflectance that faces the sensor is just found in clear air, metres; that of other
    /// surfaces follows. 0: whatever lies within `range` is found, as in CARLA.
    range_10_percent: f32,
    /// Directions measured a second, by all lasers.
    points_per_second: u32,
    /// Turns (of the horizontal field of view) a second; 0: one in each sweep.
    rotation_frequency: f32,
    /// Angle of the highest laser above the horizontal, degrees.
    upper_fov: f32,
    /// Angle of the lowest laser above the horizontal, degrees.
    lower_fov: f32,
    /// Horizontal field of view about straight ahead, degrees.
    horizontal_fov: f32,
    /// Full angle at which a beam widens, milliradians.
    beam_divergence: f32,
    /// Loss of intensity with distance, 1/m: `exp(-rate × distance)`.
    atmosphere_attenuation_rate: f32,
    /// Share of points that are dropped at random.
    dropoff_general_rate: f32,
    /// Intensity above which no point is dropped for its weakness.
    dropoff_intensity_limit: f32,
    /// Share of points of no intensity that are dropped.
    dropoff_zero_intensity: f32,
    /// Standard deviation of the distance, metres.
    noise_stddev: f32,
    /// Whether the sensor's own motion during a sweep moves its points.
    motion_distortion: bool,
    /// Whether rain, fog and wet ground take points away and add false ones.
    weather_effects: bool,
}

impl LidarSettings {
    /// The most channels.
    pub const MAX_CHANNELS: u32 = 1024;
    /// The most directions a second.
    pub const MAX_POINTS_PER_SECOND: u32 = 20_000_000;

    /// Directions of the channels, lowest first: the preset's table, or evenly spaced ones if their number or the vertical
    /// field of view is another.
    pub fn beams(&self) -> Vec<LidarBeam> {
        let device = Self::of(self.preset);
        let vertical = |settings: &Self| (settings.channels, settings.lower_fov, settings.upper_fov);
        if vertical(self) == vertical(&device) {
            LidarBeam::of_preset(self.preset)
        } else {
            LidarBeam::even(self.channels, f64::from(self.lower_fov), f64::from(self.upper_fov))
        }
    }

    /// Attributes of CARLA's blueprint `sensor.lidar.ray_cast` with these values.
    pub fn carla_attributes(&self) -> [(&'static str, f32); 12] {
        [
            ("channels", self.channels as f32),
            ("range", self.range),
            ("points_per_second", self.points_per_second as f32),
            ("rotation_frequency", self.rotation_frequency),
            ("upper_fov", self.upper_fov),
            ("lower_fov", self.lower_fov),
            ("horizontal_fov", self.horizontal_fov),
            ("atmosphere_attenuation_rate", self.atmosphere_attenuation_rate),
            ("dropoff_general_rate", self.dropoff_general_rate),
            ("dropoff_intensity_limit", self.dropoff_intensity_limit),
            ("dropoff_zero_intensity", self.dropoff_zero_intensity),
            ("noise_stddev", self.noise_stddev),
        ]
    }

    /// Whether a LiDAR can be like this.
    ///
    /// # Errors
    /// One line: the setting, what it is, and what it may be.
    pub fn check(&self) -> Result<(), String> {
        let within = |name: &str, value: f32, low: f32, high: f32| {
            let fine = (low..=high).contains(&value);
            if fine { Ok(()) } else { Err(format!("{name}: {value}, must be {low} to {high}")) }
        };
        let count = |name: &str, value: u32, high: u32| {
            let fine = (1..=high).contains(&value);
            if fine { Ok(()) } else { Err(format!("{name}: {value}, must be 1 to {high}")) }
        };
        count("channels", self.channels, Self::MAX_CHANNELS)?;
        count("points_per_second", self.points_per_second, Self::MAX_POINTS_PER_SECOND)?;
        within("range", self.range, 0.1, 1000.0)?;
        within("min_range", self.min_range, 0.0, 100.0)?;
        if self.min_range >= self.range {
            return Err(format!("min_range: {}, must be less than range, {}", self.min_range, self.range));
        }
        within("range_10_percent", self.range_10_percent, 0.0, 1000.0)?;
        within("rotation_frequency", self.rotation_frequency, 0.0, 1000.0)?;
        within("upper_fov", self.upper_fov, -90.0, 90.0)?;
        within("lower_fov", self.lower_fov, -90.0, 90.0)?;
        if self.lower_fov > self.upper_fov {
            return Err(format!("lower_fov: {}, must not be above upper_fov, {}", self.lower_fov, self.upper_fov));
        }
        within("horizontal_fov", self.horizontal_fov, 0.1, 360.0)?;
        within("beam_divergence", self.beam_divergence, 0.01, 100.0)?;
        within("atmosphere_attenuation_rate", self.atmosphere_attenuation_rate, 0.0, 10.0)?;
        within("dropoff_general_rate", self.dropoff_general_rate, 0.0, 1.0)?;
        within("dropoff_intensity_limit", self.dropoff_intensity_limit, 0.0, 1.0)?;
        within("dropoff_zero_intensity", self.dropoff_zero_intensity, 0.0, 1.0)?;
        within("noise_stddev", self.noise_stddev, 0.0, 10.0)
    }
}

impl Default for LidarSettings {
    fn default() -> Self {
        Self::of(LidarPreset::default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(json: &str) -> Result<LidarSettings, serde_json::Error> {
        serde_json::from_str(json)
    }

    #[test]
    fn what_is_left_out_is_the_presets() {
        assert_eq!(read("{}").expect("fine"), LidarSettings::default());
        let puck = read(r#"{"preset": "vlp_16", "range": 60.0}"#).expect("fine");
        assert_eq!(puck, LidarSettings { range: 60.0, ..LidarSettings::of(LidarPreset::Vlp16) });
        assert!(read(r#"{"prest": "vlp_16"}"#).is_err());
        for &preset in LidarPreset::ALL {
            let settings = LidarSettings::of(preset);
            settings.check().expect("a preset is possible");
            let json = serde_json::to_string(&settings).expect("plain data");
            assert_eq!(read(&json).expect("what was written"), settings);
            assert_eq!(settings.beams().len() as u32, settings.channels);
        }
    }

    #[test]
    fn beams_spread_evenly_if_the_preset_has_none_like_them() {
        let settings = LidarSettings { channels: 3, lower_fov: -10.0, upper_fov: 10.0, ..LidarSettings::default() };
        let degrees: Vec<f64> = settings.beams().iter().map(|b| b.elevation_rad.to_degrees()).collect();
        assert!(degrees.iter().zip([-10.0, 0.0, 10.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{degrees:?}");
    }

    #[test]
    fn messages_tell_what_was_given_and_what_may_be() {
        let of = |change: fn(&mut LidarSettings)| {
            let mut settings = LidarSettings::default();
            change(&mut settings);
            settings.check().expect_err("impossible")
        };
        assert_eq!(of(|s| s.channels = 0), "channels: 0, must be 1 to 1024");
        assert_eq!(of(|s| s.noise_stddev = f32::NAN), "noise_stddev: NaN, must be 0 to 10");
        assert_eq!(of(|s| s.min_range = 1000.0), "min_range: 1000, must be 0 to 100");
        assert_eq!(of(|s| s.lower_fov = 5.0), "lower_fov: 5, must not be above upper_fov, 2");
    }
}
