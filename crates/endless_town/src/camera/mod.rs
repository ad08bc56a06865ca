//! Camera sites: candidates, how good their views are, and which are taken.

mod candidate;
mod height_field;
mod occlusion;
mod pedestrian_candidate;
mod raster;
mod sight_lines;
mod site_selection;
mod surroundings;
mod view_score;

pub(crate) use height_field::{HeightField, TopSurface};
pub(crate) use occlusion::PropOcclusion;
pub(crate) use sight_lines::{blocks_view, occludes_view};
pub(crate) use site_selection::choose;
pub(crate) use surroundings::{BuildingPrism, CameraSurroundings, OpenSpace};
pub(crate) use view_score::{ViewContents, ViewScorer};
