//! Attributes of LiDARs.

use super::attribute::{float, int, sensor_tick};
use super::sensor::SensorKind;
use crate::wire::ActorAttribute;

/// Those of a LiDAR of this kind.
pub(super) fn attributes(kind: SensorKind) -> Vec<ActorAttribute> {
    let mut attributes = vec![
        sensor_tick(),
        int("channels", "32"),
        float("range", "10.0"),
        int("points_per_second", "56000"),
        float("rotation_frequency", "10.0"),
        float("upper_fov", "10.0"),
        float("lower_fov", "-30.0"),
        float("horizontal_fov", "360.0"),
    ];
    if kind == SensorKind::Lidar {
        attributes.extend([
            float("atmosphere_attenuation_rate", "0.004"),
            float("dropoff_general_rate", "0.45"),
            float("dropoff_intensity_limit", "0.8"),
            float("dropoff_zero_intensity", "0.4"),
            float("noise_stddev", "0.0"),
            int("noise_seed", "0"),
        ]);
    }
    attributes
}
