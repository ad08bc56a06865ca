//! Tools to make smooth solids by code: creased normals, cutting by planes, lofts, tubes and lathes.

mod cut;
mod face;
mod monotone_cubic;
mod runs;
mod sculpt;
mod solids;
mod weld;

pub(crate) use cut::{Region, rounded};
pub(crate) use monotone_cubic::MonotoneCubic;
pub(crate) use sculpt::Sculpt;
