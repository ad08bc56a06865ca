//! Street furniture, plants, parked vehicles and lights.

mod dresser;
mod parking;
mod post;
mod tree;

pub(crate) use dresser::{Dresser, Spot};
pub(crate) use post::{POST_M, add_lamps, add_signals, add_signs};

use crate::plot::Rect;
use endless_asset::Mesh;
use endless_world::CameraSite;

/// Everything that must not spoil the cameras' views, and so comes after them. Returns what lies on the ground.
pub(crate) fn dress(dresser: &mut Dresser<'_>, sites: &[CameraSite], houses: &[Rect]) -> Mesh {
    add_signs(dresser);
    parking::add_parked(dresser);
    let ground = tree::add_street_trees(dresser, sites, houses);
    tree::add_garden_trees(dresser, sites);
    tree::add_woods(dresser);
    ground
}
