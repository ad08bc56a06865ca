//! Makes a town of any road map, read from a file or written here: pavements from its strips, land that follows them,
//! buildings on footprints or along the roads, and everything that stands in streets.

mod assembly;
mod built_up;
mod camera_poles;
mod dress;
mod ground;
pub(crate) mod near_detail;
mod pavement;
mod planting;
mod preset;
mod road_furniture;

pub(crate) use dress::dress;
pub use dress::dress_map;
pub use near_detail::DetailSource;
pub(crate) use preset::{BuildingZone, TownPreset};
