//! Models of sensors other than cameras: what they measure of a scene at an instant.
//!
//! Each is a pure function of where the sensor is ([`endless_world::SensorPose`]), of the scene, of its settings and of a seed;
//! [`Imu`] and [`EventCamera`] also of what they have been shown before.

mod atmosphere;
mod event_camera;
mod gnss;
mod imu;
mod lidar;
mod radar;
mod sweep_interval;
#[cfg(test)]
mod test_scene;

pub use atmosphere::Atmosphere;
pub use event_camera::EventCamera;
pub use gnss::Gnss;
pub use imu::Imu;
pub use lidar::Lidar;
pub use radar::Radar;
pub use sweep_interval::SweepInterval;
