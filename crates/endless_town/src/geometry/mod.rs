//! Plane geometry: rectangles that must not meet, and polygons.

mod polygon;
mod rect;

pub(crate) use polygon::{area, triangulate};
pub(crate) use rect::{OccupiedSpace, Rect, around, inside, unit};
