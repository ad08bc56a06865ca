//! Maps of a server.

use super::error::ClientError;
use super::fleet::Fleet;
use super::still::{LABELS, StillObjects};
use super::world::World;
use endless_road::{Georeference, RoadMap, opendrive};
use endless_traffic::TrafficMap;
use endless_world::CameraSite;
use std::sync::Arc;

/// What is known of a map before it is filmed.
pub(super) struct PlannedMap {
    pub(super) road_map: RoadMap,
    /// BLAKE3 of its OpenDRIVE text.
    pub(super) hash: String,
    /// None, if nobody asked for them.
    pub(super) sites: Vec<CameraSite>,
}

impl PlannedMap {
    /// Of a map's OpenDRIVE text.
    pub(super) fn new(name: &str, text: &str) -> Result<Self, ClientError> {
        let road_map = opendrive::read(text).map_err(|error| {
            ClientError::Unusable(format!("the OpenDRIVE text of its map {name} is wrong: {error}"))
        })?;
        Ok(Self { road_map, hash: hash(text), sites: Vec::new() })
    }
}

/// BLAKE3 of an OpenDRIVE text.
pub(super) fn hash(text: &str) -> String {
    blake3::hash(text.as_bytes()).to_hex().to_string()
}

/// A map that is being filmed.
pub struct CarlaMap {
    pub(super) planned: Arc<PlannedMap>,
    pub(super) fleet: Arc<Fleet>,
    /// Its roads as traffic of this fleet knows them.
    pub(super) traffic: TrafficMap,
    /// Parked vehicles.
    pub(super) stills: StillObjects,
}

impl CarlaMap {
    /// Of the map that is loaded.
    pub(super) fn new(world: &mut World, planned: Arc<PlannedMap>, fleet: Arc<Fleet>) -> Result<Self, ClientError> {
        let traffic = TrafficMap::closed(planned.road_map.network.clone(), &fleet.specs);
        let mut objects = Vec::new();
        for label in LABELS {
            objects.extend(world.environment_objects(label.value())?);
        }
        Ok(Self { planned, fleet, traffic, stills: StillObjects::new(&objects) })
    }

    /// Where on Earth it lies.
    pub(super) fn georeference(&self) -> Georeference {
        self.planned.road_map.georeference.as_deref().and_then(Georeference::parse).unwrap_or_default()
    }
}
