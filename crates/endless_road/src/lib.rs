//! The lane-level road network: lanes, junctions, signals, crossings and sidewalks, with routing on them.
//!
//! Frame: world (right-handed, metres, z up), double precision. A lane's `s` runs along its centre line in the
//! direction of travel, from 0 to its length; `t` is positive to the left, as in OpenDRIVE.
//!
//! A town generator fills a [`RoadNetwork`] and calls [`RoadNetwork::finish`], which derives what follows from the
//! geometry: predecessors, conflict areas inside junctions, where crossings cut lanes, spawn points.

mod conflict;
mod cut;
mod error;
mod fault;
mod finish;
mod geographic;
mod network;
pub mod opendrive;
pub mod osm;
mod polyline;
mod road_map;
mod route;
mod spawn;
mod terrain;
mod walk;

pub use conflict::{gives_way, near_ranges, swept_overlap};
pub use error::NetworkError;
pub use fault::{Fault, FaultKind};
pub use geographic::Georeference;
pub use network::{
    Conflict, Control, Crossing, CrossingId, Junction, JunctionId, Lane, LaneCut, LaneId, Phase, RoadNetwork,
    SignalProgram, SpawnPoint, Turn, WalkEdge, WalkEdgeId, WalkKind, WalkNetwork, WalkNodeId,
};
pub use polyline::{OnLine, Polyline};
pub use road_map::{Area, AreaKind, Footprint, Mark, Note, Paint, RoadMap, Strip, StripKind, Thing, ThingKind};
pub use terrain::Terrain;
pub use walk::WalkGraph;
