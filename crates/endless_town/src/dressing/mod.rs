//! Makes a town of any road map, read from a file or written here: pavements from its strips, land that follows them,
//! buildings on footprints or along the roads, and everything that stands in streets.

mod assembly;
mod built_up;
mod camera_poles;
mod drawn_preset;
mod dress;
mod ground;
pub(crate) mod near_detail;
mod options;
mod pavement;
mod planting;
mod preset;
mod road_furniture;

pub(crate) use drawn_preset::DrawnPreset;
pub use dress::{draw_map_sites, dress_map, dress_map_with};
pub(crate) use dress::{draw_sites, dress};
pub use near_detail::DetailSource;
pub use options::{DressOptions, TownSites};
pub(crate) use preset::{BuildingZone, TownPreset};
