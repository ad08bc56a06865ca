//! The streets of a town: reference lines on a bent grid, lanes, junctions, signals, crossings and sidewalks.

mod connector;
mod crossing;
mod cut;
mod lane;
mod layout;
mod plan;
mod profile;
mod signal;
mod walk;

pub(crate) use plan::{Arm, Node, Plan, Rule, Street};
pub(crate) use profile::{FURNITURE_M, KERB_HEIGHT_M, KERB_M, MAIN, Profile, RESIDENTIAL};
pub(crate) use walk::subdivided;

use crate::character::Character;
use endless_road::{Junction, RoadNetwork};

/// Lays out a town's streets and everything that moves on them.
pub(crate) fn build(character: &Character) -> (Plan, RoadNetwork) {
    let mut plan = layout::lay_out(&character.layout, character.seed);
    let mut network = RoadNetwork { junctions: vec![Junction::default(); plan.nodes.len()], ..RoadNetwork::default() };
    signal::number_signals(&mut plan, &mut network);
    crossing::add_crossings(&mut plan, &mut network, &character.layout);
    lane::add_lanes(&mut plan, &mut network);
    connector::add_connectors(&plan, &mut network);
    signal::add_programs(&plan, &mut network, character.seed);
    walk::add_walks(&plan, &mut network);
    let network = network.finish().expect("a generated network is consistent");
    (plan, network)
}
