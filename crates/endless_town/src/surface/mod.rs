//! The ground of a town: carriageways, kerbs, sidewalks, markings, lots and the hills around.

mod furniture;
mod ground;
mod junction;
mod marking;
mod polygon;
mod street;
mod strip;

pub(crate) use ground::{Slopes, blocks, is_paved, outline};
pub(crate) use polygon::{area, triangulate, with_holes};
pub(crate) use street::{BAY_M, bays, island_ranges};

use crate::character::Character;
use crate::network::Plan;
use endless_road::RoadNetwork;
use endless_scene::{Mesh, MeshBuilder};

/// Height of paint above the asphalt, metres.
const PAINT_M: f32 = 0.003;
/// Height of manholes and grates.
const IRON_M: f32 = 0.005;
/// `v` of asphalt that belongs to no lane: far from any wheel path.
pub(crate) const NO_LANE: f32 = 50.0;

/// Everything flat (and the hills), as one mesh in the world frame.
pub(crate) fn build(character: &Character, plan: &Plan, network: &RoadNetwork) -> Mesh {
    let mut mesh = MeshBuilder::new();
    for street in &plan.streets {
        street::add(&mut mesh, street);
        marking::add_street(&mut mesh, street, character);
        furniture::add_iron(&mut mesh, street, character.seed);
    }
    for node in &plan.nodes {
        junction::add(&mut mesh, plan, node);
        marking::add_node(&mut mesh, plan, network, node);
    }
    ground::add(&mut mesh, character, plan);
    mesh.finish()
}
