//! Rigs: sensors of any kind, fixed or carried.

mod event_camera;
mod gnss;
mod imu;
mod lidar;
mod mount;
mod mounted;
mod noise_check;
mod radar;
mod rotation;
mod scene_sensor;
mod sensor_pose;
mod trajectory;

pub use event_camera::{EventCameraSettings, PixelEvent};
pub use gnss::{GnssMeasurement, GnssRecord, GnssSettings};
pub use imu::{ImuMeasurement, ImuRecord, ImuSettings};
pub use lidar::{LidarBeam, LidarPoint, LidarPreset, LidarSettings, LidarSweep, ScanPattern};
pub use mount::{Carrier, Placement, SensorMount, WayPoint};
pub use mounted::{carried, moving_to};
pub use radar::{RadarDetection, RadarScan, RadarSettings};
pub use rotation::{rotation_from_angles, rotation_from_vector, rotation_vector};
pub use scene_sensor::{RigCamera, RigEventCamera, SceneSensor, SensorModel};
pub use sensor_pose::SensorPose;
