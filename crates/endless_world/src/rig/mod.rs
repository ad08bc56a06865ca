//! Rigs: sensors of any kind, fixed or carried.

mod mount;
mod scene_sensor;
mod sensor_pose;
mod trajectory;

pub use mount::{Carrier, Placement, SensorMount, WayPoint};
pub use scene_sensor::{RigCamera, SceneSensor, SensorModel};
pub use sensor_pose::SensorPose;
