//! Rigs: sensors of any kind, fixed or carried.

mod event_camera;
mod gnss;
mod imu;
mod mount;
mod mounted;
mod noise_check;
mod rotation;
mod scene_sensor;
mod sensor_pose;
mod trajectory;

pub use event_camera::{EventCameraSettings, PixelEvent};
pub use gnss::{GnssMeasurement, GnssRecord, GnssSettings};
pub use imu::{ImuMeasurement, ImuRecord, ImuSettings};
pub use mount::{Carrier, Placement, SensorMount, WayPoint};
pub use mounted::{carried, moving_to};
pub use rotation::{rotation_from_angles, rotation_from_vector, rotation_vector};
pub use scene_sensor::{RigCamera, SceneSensor, SensorModel};
pub use sensor_pose::SensorPose;
