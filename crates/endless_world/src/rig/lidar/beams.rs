//! Directions of a LiDAR's beams, from the makers' tables.

use super::preset::LidarPreset;

/// Direction of one channel while the head looks straight ahead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LidarBeam {
    /// Above the horizontal plane of the sensor, radians.
    pub elevation_rad: f64,
    /// To the left of where the head looks, radians.
    pub azimuth_rad: f64,
}

impl LidarBeam {
    fn of_degrees(elevation: f64, azimuth: f64) -> Self {
        Self { elevation_rad: elevation.to_radians(), azimuth_rad: azimuth.to_radians() }
    }

    /// So many, evenly spaced, lowest first; a lone one is at the lower end. Degrees.
    pub(super) fn even(count: u32, lower: f64, upper: f64) -> Vec<Self> {
        let step = (upper - lower) / f64::from(count.max(2) - 1);
        (0..count).map(|i| Self::of_degrees(lower + step * f64::from(i), 0.0)).collect()
    }

    /// Those of a preset, lowest first.
    pub(super) fn of_preset(preset: LidarPreset) -> Vec<Self> {
        match preset {
            // CARLA 0.9, sensors reference.
            LidarPreset::Carla => Self::even(32, -30.0, 10.0),
            // VLP-16 user's manual (63-9243 rev. D), table 9-1: every 2 degrees.
            LidarPreset::Vlp16 => Self::even(16, -15.0, 15.0),
            // HDL-32E user's manual (63-9113 rev. M), table 9-1: every 4/3 degrees.
            LidarPreset::Hdl32e => Self::even(32, -92.0 / 3.0, 32.0 / 3.0),
            LidarPreset::Hdl64e => hdl_64e(),
            LidarPreset::Vls128 => vls_128(),
            // OS1 data sheet: 45 degrees, 128 beams, uniform.
            LidarPreset::Os1128 => Self::even(128, -22.5, 22.5),
            // RS-LiDAR-M1 data sheet: 25 degrees, 125 lines.
            LidarPreset::SolidState => Self::even(125, -12.5, 12.5),
        }
    }
}

/// HDL-64E S2 user's manual (63-HDL64ES2 rev. D), specifications: an upper block of 32 lasers from +2 to -8.33 degrees, every
/// third of a degree, and a lower one from -8.83 to -24.33, every half. What single devices are calibrated to differs by some
/// hundredths; their lasers also look to the sides, which a driver corrects, and which is left out.
fn hdl_64e() -> Vec<LidarBeam> {
    let lower = (0..32).map(|i| -73.0 / 3.0 + 0.5 * f64::from(i));
    let upper = (0..32).map(|i| 2.0 - f64::from(31 - i) / 3.0);
    lower.chain(upper).map(|elevation| LidarBeam::of_degrees(elevation, 0.0)).collect()
}

/// VLS-128 user's manual (63-9483 rev. B), table of elevations and azimuth offsets; the same as in the calibration that the
/// `velodyne` driver of ROS has of it.
fn vls_128() -> Vec<LidarBeam> {
    const BELOW: [f64; 12] =
        [-25.0, -19.582, -16.042, -13.565, -11.742, -10.346, -9.244, -8.352, -7.65, -7.15, -6.85, -6.65];
    /// The dense part, every 0.11 degrees.
    const DENSE: u32 = 104;
    const ABOVE: [f64; 12] = [4.98, 5.18, 5.43, 5.73, 6.08, 6.48, 6.98, 7.58, 8.43, 9.7, 11.75, 15.0];
    /// Of each of eight beams above one another.
    const AZIMUTHS: [f64; 8] = [0.911, 2.732, 4.548, 6.354, -6.354, -4.548, -2.732, -0.911];
    let dense = (0..DENSE).map(|i| -6.5 + 0.11 * f64::from(i));
    let elevations = BELOW.into_iter().chain(dense).chain(ABOVE);
    elevations.zip(AZIMUTHS.into_iter().cycle()).map(|(e, a)| LidarBeam::of_degrees(e, a)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_complete_and_ascend() {
        let counts = [32, 16, 32, 64, 128, 128, 125];
        for (&preset, count) in LidarPreset::ALL.iter().zip(counts) {
            let beams = LidarBeam::of_preset(preset);
            assert_eq!(beams.len(), count, "{preset}");
            assert!(beams.windows(2).all(|pair| pair[0].elevation_rad < pair[1].elevation_rad), "{preset}");
        }
    }

    #[test]
    fn ends_are_those_of_the_data_sheets() {
        let ends = |preset| {
            let beams = LidarBeam::of_preset(preset);
            [beams[0], beams[beams.len() - 1]].map(|beam| (beam.elevation_rad.to_degrees() * 100.0).round() / 100.0)
        };
        assert_eq!(ends(LidarPreset::Vlp16), [-15.0, 15.0]);
        assert_eq!(ends(LidarPreset::Hdl32e), [-30.67, 10.67]);
        assert_eq!(ends(LidarPreset::Hdl64e), [-24.33, 2.0]);
        assert_eq!(ends(LidarPreset::Vls128), [-25.0, 15.0]);
        assert_eq!(ends(LidarPreset::Os1128), [-22.5, 22.5]);
        // Between the two blocks, and where the dense part ends.
        let degrees = |preset, i: usize| LidarBeam::of_preset(preset)[i].elevation_rad.to_degrees();
        assert!((degrees(LidarPreset::Hdl64e, 31) + 8.8333).abs() < 1e-3);
        assert!((degrees(LidarPreset::Hdl64e, 32) + 8.3333).abs() < 1e-3);
        assert!((degrees(LidarPreset::Vls128, 115) - 4.83).abs() < 1e-9);
    }
}
