//! LiDARs: their settings, their beams, and what they deliver.

mod beams;
mod devices;
mod preset;
mod settings;
mod sweep;

pub use beams::LidarBeam;
pub use preset::{LidarPreset, ScanPattern};
pub use settings::LidarSettings;
pub use sweep::{LidarPoint, LidarSweep};
