//! Plants: grown by branching, with many small leaves.

mod corn;
mod leaf;
mod low;
mod palm;
mod tree;

pub(crate) use corn::corn;
pub(crate) use low::{bush, hedge, planter};
pub(crate) use palm::palm;
pub(crate) use tree::{BROADLEAF_VARIANTS, CONIFER_VARIANTS, broadleaf, conifer};
