//! The ground: its heights, its land cover, and the pavements on it.

pub(crate) mod bare_ground;
pub(crate) mod ground_grid;
pub(crate) mod land_use_map;
pub(crate) mod pavement_index;
