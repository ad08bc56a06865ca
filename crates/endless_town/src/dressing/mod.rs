//! Street furniture, plants, parked vehicles and lights.

mod dresser;
mod furniture;
mod garden;
mod parking;
mod post;
mod tree;
mod wire;

pub(crate) use dresser::{Dresser, Spot, Stage};
pub(crate) use parking::{add_parked, keep_the_seen};
pub(crate) use post::{add_lamps, add_signals, add_signs};
pub(crate) use wire::hang;

use crate::building::Lot;
use crate::plot::Rect;
use endless_scene::{Mesh, MeshBuilder};
use endless_world::CameraSite;

/// Everything that must not spoil the cameras' views, and so comes after them. Returns slabs, tree pits and wires.
pub(crate) fn dress(dresser: &mut Dresser<'_>, sites: &[CameraSite], lots: &[Lot]) -> Mesh {
    let houses: Vec<Rect> = lots.iter().map(|lot| lot.footprint).collect();
    let mut mesh = MeshBuilder::new();
    wire::add(dresser, &mut mesh, sites);
    garden::add(dresser, &mut mesh, lots);
    tree::add_street_trees(dresser, &mut mesh, sites, &houses);
    furniture::add(dresser, sites);
    tree::add_garden_trees(dresser, &mut mesh, sites);
    tree::add_woods(dresser);
    mesh.finish()
}
