//! All blueprints.

use super::attribute::role_name;
use super::entry::Blueprint;
use super::kind::BlueprintKind;
use super::sensor::SensorKind;
use super::{camera, lidar, other_sensor, prop, scenery, vehicle, walker};
use crate::wire::{ActorDefinition, ActorDescription, BoundingBox};
use endless_asset::Catalogue;

/// All blueprints.
#[derive(Debug, Clone)]
pub struct BlueprintLibrary {
    /// In the order of the definitions, then those of the server.
    blueprints: Vec<Blueprint>,
    definitions: Vec<ActorDefinition>,
}

impl Default for BlueprintLibrary {
    fn default() -> Self {
        Self::new()
    }
}

impl BlueprintLibrary {
    /// The library, the same each time. Making it takes some tens of milliseconds.
    pub fn new() -> Self {
        let catalogue = Catalogue::builtin();
        let mut blueprints = scenery::spawnable();
        blueprints.extend(SensorKind::ALL.map(sensor));
        blueprints.extend(prop::blueprints(&catalogue));
        blueprints.extend(vehicle::blueprints(&catalogue));
        blueprints.extend(walker::blueprints());
        blueprints.sort_by(|a, b| a.definition.id.cmp(&b.definition.id));
        let spawnable = blueprints.len();
        blueprints.extend(scenery::of_the_server());
        for (uid, blueprint) in (1..).zip(&mut blueprints) {
            blueprint.definition.uid = uid;
        }
        let definitions = blueprints[..spawnable].iter().map(|blueprint| blueprint.definition.clone()).collect();
        Self { blueprints, definitions }
    }

    /// What clients may spawn, in the order of ids; numbers are from 1 on.
    pub fn definitions(&self) -> &[ActorDefinition] {
        &self.definitions
    }

    /// The blueprint of an id, be it one that clients may spawn or one of the server's own.
    pub fn find(&self, id: &str) -> Option<&Blueprint> {
        self.blueprints.iter().find(|blueprint| blueprint.definition.id == id)
    }

    /// The blueprint that a client wants an actor of; none if there is no such, or clients may not spawn it.
    pub fn spawnable(&self, description: &ActorDescription) -> Option<&Blueprint> {
        let spawnable = &self.blueprints[..self.definitions.len()];
        spawnable.iter().find(|blueprint| blueprint.definition.id == description.id)
    }

    /// All, those of the server last.
    pub fn blueprints(&self) -> &[Blueprint] {
        &self.blueprints
    }
}

fn sensor(kind: SensorKind) -> Blueprint {
    let places = ["front", "back", "left", "right", "front_left", "front_right", "back_left", "back_right"];
    let places: &[&str] = match kind {
        SensorKind::Gnss | SensorKind::Imu | SensorKind::Radar => &["default"],
        _ => &places,
    };
    let mut attributes = vec![role_name(places)];
    attributes.extend(match kind {
        _ if kind.is_camera() => camera::attributes(kind),
        SensorKind::Lidar | SensorKind::SemanticLidar => lidar::attributes(kind),
        _ => other_sensor::attributes(kind),
    });
    Blueprint::new(kind.id(), attributes, BlueprintKind::Sensor(kind), BoundingBox::default(), Vec::new())
}
