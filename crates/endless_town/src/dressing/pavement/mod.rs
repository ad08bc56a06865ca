//! Pavements with their kerbs, bridges and paint.

pub(crate) mod arrow;
pub(crate) mod bump;
pub(crate) mod crossing;
pub(crate) mod features;
pub(crate) mod infill;
pub(crate) mod old_paint;
pub(crate) mod paint;
pub(crate) mod surface;
mod travelled;
