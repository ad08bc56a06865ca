//! Plants: grown by branching, with many small leaves; and rocks.

mod conifer;
mod corn;
mod grow;
mod leaf;
mod low;
mod palm;
mod tree;

pub(crate) use conifer::{CONIFER_VARIANTS, conifer, cypress};
pub(crate) use corn::corn;
pub(crate) use low::{bush, flower_bed, grass, hedge, planter, rock, wheat};
pub(crate) use palm::palm;
pub(crate) use tree::{BARE_VARIANTS, BROADLEAF_VARIANTS, bare, broadleaf};
