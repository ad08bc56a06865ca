//! The ground: its heights, its land cover, and the pavements on it.

pub(crate) mod bare_ground;
pub(crate) mod ground_grid;
mod ground_mesh;
mod hills;
pub(crate) mod land_use_map;
pub(crate) mod pavement_index;
