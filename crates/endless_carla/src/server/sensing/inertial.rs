//! IMU and GNSS: what a body feels and where on Earth it is, as msgpack.

use crate::stream::SensorHeader;
use crate::wire::{GeoLocation, Vector3D, Wire};
use endless_sensor::{Gnss, Imu};
use endless_world::{GnssMeasurement, GnssSettings, ImuSettings, SensorPose};
use rmpv::Value;

/// An IMU that measures at this interval.
pub(super) fn imu(settings: &ImuSettings, interval_s: f64, seed: u64) -> Box<Imu> {
    Box::new(Imu::new(settings, interval_s, seed))
}

/// `[accelerometer, gyroscope, compass]`: m/s² and rad/s in the sensor's left-handed frame, radians clockwise from north.
pub(super) fn imu_message(header: &SensorHeader, imu: &mut Imu, pose: &SensorPose) -> Vec<u8> {
    let measured = imu.measure(pose);
    let [ax, ay, az] = measured.accelerometer_mps2.map(|a| a as f32);
    let [gx, gy, gz] = measured.gyroscope_radps.map(|g| g as f32);
    // The y axis points the other way; so do turns about the others.
    let accelerometer = Vector3D { x: ax, y: -ay, z: az };
    let gyroscope = Vector3D { x: -gx, y: gy, z: -gz };
    let compass = Value::F32(measured.compass_rad as f32);
    header.with_msgpack(&Value::Array(vec![accelerometer.to_value(), gyroscope.to_value(), compass]))
}

/// `[latitude, longitude, altitude]`: degrees and metres.
pub(super) fn gnss_message(
    header: &SensorHeader,
    settings: &GnssSettings,
    truth: GnssMeasurement,
    number: u32,
    seed: u64,
) -> Vec<u8> {
    let GnssMeasurement { latitude_deg, longitude_deg, altitude_m } =
        Gnss::new(settings, seed).measure(number.into(), truth);
    let place = GeoLocation { latitude: latitude_deg, longitude: longitude_deg, altitude: altitude_m };
    header.with_msgpack(&place.to_value())
}
