//! Settings of LiDARs that can be bought, from their data sheets.

use super::preset::{LidarPreset, ScanPattern};
use super::settings::LidarSettings;

impl LidarSettings {
    /// Those of a preset. Ranges and noise are those of the data sheets. No data sheet tells how many echoes are lost by
    /// chance: those of named devices lose 1 %, and weak ones more often.
    pub fn of(preset: LidarPreset) -> Self {
        let device = Self {
            preset,
            scan: ScanPattern::Rotating,
            channels: 64,
            range: 120.0,
            min_range: 0.9,
            range_10_percent: 50.0,
            points_per_second: 1_333_000,
            rotation_frequency: 0.0,
            upper_fov: 2.0,
            lower_fov: -73.0 / 3.0,
            horizontal_fov: 360.0,
            beam_divergence: 2.0,
            atmosphere_attenuation_rate: 0.0,
            dropoff_general_rate: 0.01,
            dropoff_intensity_limit: 0.02,
            dropoff_zero_intensity: 0.3,
            noise_stddev: 0.02,
            motion_distortion: true,
            weather_effects: true,
        };
        match preset {
            // Sensors reference of CARLA 0.9: ranges and intensities of its own, points where the frame has them.
            LidarPreset::Carla => Self {
                channels: 32,
                range: 10.0,
                min_range: 0.0,
                range_10_percent: 0.0,
                points_per_second: 56_000,
                rotation_frequency: 10.0,
                upper_fov: 10.0,
                lower_fov: -30.0,
                atmosphere_attenuation_rate: 0.004,
                dropoff_general_rate: 0.45,
                dropoff_intensity_limit: 0.8,
                dropoff_zero_intensity: 0.4,
                noise_stddev: 0.0,
                motion_distortion: false,
                weather_effects: false,
                ..device
            },
            // A firing of all lasers every 55.296 µs; ±3 cm; 100 m.
            LidarPreset::Vlp16 => Self {
                channels: 16,
                range: 100.0,
                range_10_percent: 35.0,
                points_per_second: 289_352,
                upper_fov: 15.0,
                lower_fov: -15.0,
                beam_divergence: 3.0,
                ..device
            },
            // A firing every 46.08 µs; ±2 cm; 80 to 100 m.
            LidarPreset::Hdl32e => Self {
                channels: 32,
                range: 100.0,
                range_10_percent: 35.0,
                points_per_second: 694_444,
                upper_fov: 32.0 / 3.0,
                lower_fov: -92.0 / 3.0,
                beam_divergence: 2.8,
                ..device
            },
            // 120 m for cars and foliage, 50 m for pavement (10 %); below 2 cm.
            LidarPreset::Hdl64e => device,
            // A firing every 53.3 µs; 245 m, of 10 % 220 m; ±3 cm.
            LidarPreset::Vls128 => Self {
                channels: 128,
                range: 245.0,
                range_10_percent: 220.0,
                points_per_second: 2_401_500,
                upper_fov: 15.0,
                lower_fov: -25.0,
                beam_divergence: 1.6,
                ..device
            },
            // 2048 columns at 10 Hz; 120 m of 80 %, 40 m of 10 %; 1.5 cm of strong echoes.
            LidarPreset::Os1128 => Self {
                channels: 128,
                range_10_percent: 40.0,
                min_range: 0.8,
                points_per_second: 2_621_440,
                upper_fov: 22.5,
                lower_fov: -22.5,
                beam_divergence: 3.1,
                noise_stddev: 0.015,
                ..device
            },
            // 120 by 25 degrees, every 0.2 of either; 150 m of 10 %; ±5 cm.
            LidarPreset::SolidState => Self {
                scan: ScanPattern::Raster,
                channels: 125,
                range: 200.0,
                range_10_percent: 150.0,
                min_range: 0.5,
                points_per_second: 750_000,
                upper_fov: 12.5,
                lower_fov: -12.5,
                horizontal_fov: 120.0,
                beam_divergence: 2.0,
                ..device
            },
        }
    }
}
