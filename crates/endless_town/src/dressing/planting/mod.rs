//! Trees, lawns, gardens, parks and squares.

pub(crate) mod garden;
pub(crate) mod square;
pub(crate) mod trees;
