//! What a sensor's attributes make of it.

use super::actor::{CameraSettings, ObstacleSettings, SensorModel};
use super::call_error::CallError;
use crate::blueprint::{Attributes, SensorKind};
use endless_world::{
    EventCameraSettings, GnssSettings, ImageSize, ImuSettings, LidarPreset, LidarSettings, RadarSettings,
};

/// Nothing is looked for farther away, metres.
const FARTHEST_M: f64 = 1000.0;

/// How a sensor of this kind and these attributes measures.
pub(super) fn sensor_model(
    kind: SensorKind,
    attributes: &Attributes<'_>,
    is_carried: bool,
) -> Result<SensorModel, CallError> {
    let number = |id: &str| attributes.number(id).map_err(CallError::from);
    let float = |id: &str| number(id).map(|number| number as f32);
    Ok(match kind {
        _ if kind.is_camera() => {
            let [width, height] = attributes.image_size()?;
            let fov_deg = attributes.fov_degrees()? as f32;
            let camera = CameraSettings { size: ImageSize { width, height }, fov_deg, is_carried };
            match kind {
                SensorKind::Dvs => SensorModel::Events(camera, Box::new(events(attributes, camera.size)?)),
                _ => SensorModel::Camera(camera),
            }
        }
        SensorKind::Obstacle => SensorModel::Obstacle(ObstacleSettings {
            distance_m: number("distance")?.clamp(0.0, FARTHEST_M),
            hit_radius_m: number("hit_radius")?.clamp(0.0, FARTHEST_M),
            only_dynamics: attributes.flag("only_dynamics")?,
        }),
        SensorKind::Lidar | SensorKind::SemanticLidar => SensorModel::Lidar(Box::new(lidar(kind, attributes)?)),
        SensorKind::Radar => {
            let settings = RadarSettings {
                horizontal_fov: float("horizontal_fov")?,
                vertical_fov: float("vertical_fov")?,
                range: float("range")?,
                points_per_second: count(number("points_per_second")?),
                ..RadarSettings::default()
            };
            settings.check().map_err(CallError::refused)?;
            SensorModel::Radar(Box::new(settings))
        }
        SensorKind::Imu => {
            let settings = ImuSettings {
                noise_accel_stddev_x: number("noise_accel_stddev_x")?,
                noise_accel_stddev_y: number("noise_accel_stddev_y")?,
                noise_accel_stddev_z: number("noise_accel_stddev_z")?,
                noise_gyro_stddev_x: number("noise_gyro_stddev_x")?,
                noise_gyro_stddev_y: number("noise_gyro_stddev_y")?,
                noise_gyro_stddev_z: number("noise_gyro_stddev_z")?,
                noise_gyro_bias_x: number("noise_gyro_bias_x")?,
                noise_gyro_bias_y: number("noise_gyro_bias_y")?,
                noise_gyro_bias_z: number("noise_gyro_bias_z")?,
                ..ImuSettings::default()
            };
            settings.check().map_err(CallError::refused)?;
            SensorModel::Imu(Box::new(settings), None)
        }
        SensorKind::Gnss => {
            let settings = GnssSettings {
                noise_lat_bias: number("noise_lat_bias")?,
                noise_lat_stddev: number("noise_lat_stddev")?,
                noise_lon_bias: number("noise_lon_bias")?,
                noise_lon_stddev: number("noise_lon_stddev")?,
                noise_alt_bias: number("noise_alt_bias")?,
                noise_alt_stddev: number("noise_alt_stddev")?,
            };
            settings.check().map_err(CallError::refused)?;
            SensorModel::Gnss(Box::new(settings))
        }
        _ => SensorModel::Event,
    })
}

/// When pixels of an event camera give events.
fn events(attributes: &Attributes<'_>, size: ImageSize) -> Result<EventCameraSettings, CallError> {
    let number = |id: &str| attributes.number(id).map_err(CallError::from);
    let settings = EventCameraSettings {
        positive_threshold: number("positive_threshold")?,
        negative_threshold: number("negative_threshold")?,
        sigma_positive_threshold: number("sigma_positive_threshold")?,
        sigma_negative_threshold: number("sigma_negative_threshold")?,
        refractory_period_ns: number("refractory_period_ns")?.max(0.0) as u64,
        use_log: attributes.flag("use_log")?,
        log_eps: number("log_eps")?,
    };
    settings.check().map_err(CallError::refused)?;
    if size.width > 1 << 16 || size.height > 1 << 16 {
        return Err(CallError::refused("an event camera has at most 65,536 columns and rows"));
    }
    Ok(settings)
}

/// A LiDAR as CARLA's is: all that is in range is found, whatever the weather; the semantic one loses nothing.
fn lidar(kind: SensorKind, attributes: &Attributes<'_>) -> Result<LidarSettings, CallError> {
    let number = |id: &str| attributes.number(id).map_err(CallError::from);
    let float = |id: &str| number(id).map(|number| number as f32);
    let plain = LidarSettings {
        channels: count(number("channels")?),
        range: float("range")?,
        min_range: 0.0,
        range_10_percent: 0.0,
        points_per_second: count(number("points_per_second")?),
        rotation_frequency: float("rotation_frequency")?,
        upper_fov: float("upper_fov")?,
        lower_fov: float("lower_fov")?,
        horizontal_fov: float("horizontal_fov")?,
        beam_divergence: 0.01,
        atmosphere_attenuation_rate: 0.0,
        dropoff_general_rate: 0.0,
        dropoff_intensity_limit: 1.0,
        dropoff_zero_intensity: 0.0,
        noise_stddev: 0.0,
        motion_distortion: false,
        weather_effects: false,
        ..LidarSettings::of(LidarPreset::default())
    };
    let settings = match kind {
        SensorKind::Lidar => LidarSettings {
            atmosphere_attenuation_rate: float("atmosphere_attenuation_rate")?,
            dropoff_general_rate: float("dropoff_general_rate")?,
            dropoff_intensity_limit: float("dropoff_intensity_limit")?,
            dropoff_zero_intensity: float("dropoff_zero_intensity")?,
            noise_stddev: float("noise_stddev")?,
            ..plain
        },
        _ => plain,
    };
    settings.check().map_err(CallError::refused)?;
    Ok(settings)
}

/// A number that counts something; what is none is refused later.
fn count(number: f64) -> u32 {
    number.clamp(0.0, f64::from(u32::MAX)) as u32
}
