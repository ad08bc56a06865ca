//! The sensors of a rig as users write them: `[[sensor]]` tables of TOML, metres and degrees.

mod camera_spec;
mod event_camera_spec;
mod json_fields;
mod lidar_spec;
mod mount_spec;
mod sensor_spec;

pub use camera_spec::CameraSpec;
pub use event_camera_spec::EventCameraSpec;
pub use lidar_spec::{LidarSpec, PointCloudFormat};
pub use mount_spec::{CarrierClass, MountSpec, Origin, PanTiltZoomKey, WayPointSpec};
pub use sensor_spec::{ModelSpec, SensorSpec};
