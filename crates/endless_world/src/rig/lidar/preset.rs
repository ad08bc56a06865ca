//! LiDARs by name.

use crate::UnknownName;
use serde::{Deserialize, Serialize};
use strum::VariantArray as _;

/// A LiDAR whose data sheet gives the defaults of all settings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum LidarPreset {
    /// `sensor.lidar.ray_cast` as CARLA has it without attributes.
    Carla,
    /// Velodyne VLP-16 "Puck": 16 channels.
    #[serde(rename = "vlp_16")]
    #[strum(serialize = "vlp_16")]
    Vlp16,
    /// Velodyne HDL-32E, of nuScenes: 32 channels.
    #[serde(rename = "hdl_32e")]
    #[strum(serialize = "hdl_32e")]
    Hdl32e,
    /// Velodyne HDL-64E S2, of KITTI: 64 channels.
    #[default]
    #[serde(rename = "hdl_64e")]
    #[strum(serialize = "hdl_64e")]
    Hdl64e,
    /// Velodyne VLS-128 "Alpha Prime": 128 channels, denser about the horizon.
    #[serde(rename = "vls_128")]
    #[strum(serialize = "vls_128")]
    Vls128,
    /// Ouster OS1-128: 128 evenly spaced channels.
    #[serde(rename = "os1_128")]
    #[strum(serialize = "os1_128")]
    Os1128,
    /// A mirror that scans a raster ahead, with the figures of RoboSense's RS-LiDAR-M1.
    SolidState,
}

impl LidarPreset {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// The name in recipes.
    pub fn name(self) -> &'static str {
        self.into()
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("LiDAR preset", given, Self::ALL)
    }
}

/// In which order a LiDAR measures its directions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum ScanPattern {
    /// All channels at once, turning clockwise as seen from above: a spinning head.
    #[default]
    Rotating,
    /// One channel after another, from the uppermost, each from left to right: a scanning mirror.
    Raster,
    /// Everything at one instant, the end of the sweep: a flash LiDAR.
    Flash,
}

impl ScanPattern {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("scan pattern", given, Self::ALL)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_the_same_in_files_and_on_the_command_line() {
        for &preset in LidarPreset::ALL {
            assert_eq!(preset.name().parse(), Ok(preset));
            assert_eq!(serde_json::to_value(preset).expect("a word"), preset.name());
        }
        assert!("hdl_65".parse::<LidarPreset>().is_err());
        assert_eq!("raster".parse(), Ok(ScanPattern::Raster));
    }
}
