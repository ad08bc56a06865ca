//! Camera sites: candidates, how good their views are, and which are taken.

mod candidate;
mod height_field;
mod lane_spot;
mod mount_draw;
mod occlusion;
mod pedestrian_candidate;
mod raster;
mod roadside;
mod sight_lines;
mod site_drawer;
mod site_selection;
mod surroundings;
mod view_score;

pub(crate) use height_field::{HeightField, TopSurface};
pub(crate) use occlusion::PropOcclusion;
pub(crate) use roadside::blocks_lane;
pub(crate) use sight_lines::{blocks_view, builds_into_view, occludes_view};
pub use site_drawer::SiteDrawer;
pub(crate) use site_selection::choose;
pub(crate) use surroundings::{BuildingPrism, CameraSurroundings, OpenSpace};
pub(crate) use view_score::{ViewContents, ViewScorer};
