//! Camera sites: candidates, how good their views are, and which are taken.

mod candidate;
mod choose;
mod height_field;
mod judge;
mod occlusion;
mod pedestrian_candidate;
mod raster;
mod sight;
mod surroundings;

pub(crate) use choose::choose;
pub(crate) use height_field::HeightField;
pub(crate) use occlusion::PropOcclusion;
pub(crate) use sight::{in_the_way, spoils};
pub(crate) use surroundings::{BuildingPrism, CameraSurroundings, OpenSpace};
