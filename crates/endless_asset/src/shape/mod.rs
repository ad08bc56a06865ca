//! Tools to make smooth solids by code: creased normals, cutting by planes, lofts, tubes and lathes.

mod curve;
mod cut;
mod face;
mod runs;
mod sculpt;
mod solids;
mod weld;

pub(crate) use curve::Curve;
pub(crate) use cut::{Region, rounded};
pub(crate) use sculpt::Sculpt;
