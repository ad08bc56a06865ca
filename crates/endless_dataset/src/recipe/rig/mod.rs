//! The sensors of a rig as users write them: `[[sensor]]` tables of TOML, metres and degrees.

mod camera_spec;
mod mount_spec;
mod sensor_spec;

pub use camera_spec::CameraSpec;
pub use mount_spec::{CarrierClass, MountSpec, Origin, PanTiltZoomKey, WayPointSpec};
pub use sensor_spec::{ModelSpec, SensorSpec};
