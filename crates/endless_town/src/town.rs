//! What a town is.

use endless_asset::Prop;
use endless_road::RoadNetwork;
use endless_scene::{Mesh, StreetLamp};
use endless_world::{CameraSite, ParkedVehicle, SignalId};
use glam::Affine3A;
use std::sync::Arc;

/// What is placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum What {
    /// One of the town's own meshes.
    Own(u32),
    /// A prop of the catalogue and its variant.
    Prop(Prop, u32),
}

/// A mesh standing in the town.
#[derive(Debug, Clone, PartialEq)]
pub struct Placement {
    /// What.
    pub what: What,
    /// Where.
    pub world_from_object: Affine3A,
    /// The signal group that lights its lenses.
    pub signal: Option<SignalId>,
}

/// A whole map. By default an empty one, without a name.
#[derive(Debug, Clone, Default)]
pub struct Town {
    /// `Town01`, ...
    pub name: String,
    /// One sentence on its character.
    pub summary: String,
    /// Roads, junctions, signals, sidewalks.
    pub network: RoadNetwork,
    /// Ground, roads, kerbs, markings and buildings.
    pub meshes: Vec<Arc<Mesh>>,
    /// Everything placed, own meshes included.
    pub placements: Vec<Placement>,
    /// Parked vehicles. Number i carries instance id i + 1 in every video.
    pub parked: Vec<ParkedVehicle>,
    /// Street lamps.
    pub lamps: Vec<StreetLamp>,
    /// At least five camera sites.
    pub cameras: Vec<CameraSite>,
}

/// Why a town could not be made.
#[derive(Debug, thiserror::Error, PartialEq)]
pub enum TownError {
    /// A map with nothing to drive on.
    #[error("map '{name}' has no lane for driving: nothing can be dressed")]
    NoLanes {
        /// The map.
        name: String,
    },
    /// A map that is larger than a town can be.
    #[error("map '{name}' is {width_km:.1} by {height_km:.1} km: cut out a part of at most {most_km} km a side")]
    TooLarge {
        /// The map.
        name: String,
        /// Size from west to east, kilometres.
        width_km: f64,
        /// Size from south to north, kilometres.
        height_km: f64,
        /// The most.
        most_km: f64,
    },
    /// No map of this name.
    #[error("unknown map '{given}': use one of {}", known.join(", "))]
    UnknownMap {
        /// What was asked for.
        given: String,
        /// The names there are.
        known: Vec<&'static str>,
    },
}
