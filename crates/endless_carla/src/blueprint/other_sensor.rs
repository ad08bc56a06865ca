//! Attributes of sensors that are neither cameras nor LiDARs.

use super::attribute::{float, floats, int, sensor_tick, switch};
use super::sensor::SensorKind;
use crate::wire::ActorAttribute;

/// Those of a sensor of this kind.
pub(super) fn attributes(kind: SensorKind) -> Vec<ActorAttribute> {
    match kind {
        SensorKind::Radar => radar(),
        SensorKind::Imu => imu(),
        SensorKind::Gnss => gnss(),
        SensorKind::Obstacle => obstacle(),
        _ => Vec::new(),
    }
}

fn radar() -> Vec<ActorAttribute> {
    vec![
        sensor_tick(),
        float("horizontal_fov", "30.0"),
        float("vertical_fov", "30.0"),
        float("range", "100.0"),
        int("points_per_second", "1500"),
        int("noise_seed", "0"),
    ]
}

fn imu() -> Vec<ActorAttribute> {
    let mut attributes = vec![sensor_tick(), int("noise_seed", "0")];
    attributes.extend(floats(&["noise_accel_stddev_x", "noise_accel_stddev_y", "noise_accel_stddev_z"], "0.0"));
    attributes.extend(floats(&["noise_gyro_stddev_x", "noise_gyro_stddev_y", "noise_gyro_stddev_z"], "0.0"));
    attributes.extend(floats(&["noise_gyro_bias_x", "noise_gyro_bias_y", "noise_gyro_bias_z"], "0.0"));
    attributes
}

fn gnss() -> Vec<ActorAttribute> {
    let mut attributes = vec![sensor_tick(), int("noise_seed", "0")];
    attributes.extend(floats(&["noise_lat_stddev", "noise_lon_stddev", "noise_alt_stddev"], "0.0"));
    attributes.extend(floats(&["noise_lat_bias", "noise_lon_bias", "noise_alt_bias"], "0.0"));
    attributes
}

fn obstacle() -> Vec<ActorAttribute> {
    vec![
        sensor_tick(),
        float("distance", "5.0"),
        float("hit_radius", "0.5"),
        switch("only_dynamics", false),
        switch("debug_linetrace", false),
    ]
}
