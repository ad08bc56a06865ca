//! Rigs: sensors of any kind, fixed or carried.

mod sensor_pose;

pub use sensor_pose::SensorPose;
