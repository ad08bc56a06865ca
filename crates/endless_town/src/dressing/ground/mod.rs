//! The ground: the lie of the land, what covers it, and where pavements lie.

pub(crate) mod area;
pub(crate) mod bare;
pub(crate) mod land;
pub(crate) mod pavement_index;
