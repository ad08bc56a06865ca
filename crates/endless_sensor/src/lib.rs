//! Models of sensors other than cameras: what they measure of a scene at an instant.
//!
//! Each is a pure function of where the sensor is ([`endless_world::SensorPose`]), of the scene, of its settings and of a seed;
//! [`Imu`] and [`EventCamera`] also of what they have been shown before.

mod event_camera;
mod gnss;
mod imu;

pub use event_camera::EventCamera;
pub use gnss::Gnss;
pub use imu::Imu;
