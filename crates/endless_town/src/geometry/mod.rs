//! Plane geometry: rectangles that must not meet, and polygons.

mod polygon;
mod rect;

pub(crate) use polygon::{area, triangulate, with_holes};
pub(crate) use rect::{OccupiedSpace, Rect, around, inside, unit};
