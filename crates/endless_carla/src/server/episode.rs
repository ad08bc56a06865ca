//! What happens from one load of a map to the next.

use super::actor::{Body, ServerActor};
use super::lamps::Lamps;
use super::loaded_map::{LoadedMap, NamedMap};
use super::map_layer::MapLayer;
use super::scenery::Scenery;
use super::weather::CLEAR_NOON;
use crate::blueprint::{BlueprintLibrary, VehicleBlueprint};
use crate::frames;
use crate::map::LightCycle;
use crate::physics::Contact;
use crate::stream::{
    ActorRecord, ActorRecordState, EpisodeHeader, SensorHeader, VehicleRecord, WORLD_OBSERVER, WalkerRecord, snapshot,
};
use crate::wire::{Transform, Vector3D, WeatherParameters};
use endless_asset::Catalogue;
use std::collections::BTreeMap;
use std::sync::Arc;

/// From one load of a map to the next.
pub(super) struct Episode {
    pub(super) id: u64,
    /// Never goes back, not even in another episode.
    pub(super) frame: u64,
    /// Seconds since it began.
    pub(super) elapsed_s: f64,
    /// Of the last step.
    pub(super) delta_s: f64,
    /// As it is seen and felt.
    pub(super) map: Arc<LoadedMap>,
    /// What of it is shown.
    pub(super) scenery: Scenery,
    /// The name by which it was loaded.
    pub(super) map_name: String,
    pub(super) weather: WeatherParameters,
    pub(super) actors: BTreeMap<u32, ServerActor>,
    pub(super) spectator: u32,
    pub(super) seed: u64,
    /// Changes when actors come and go.
    pub(super) population: u64,
    /// Of the last step.
    pub(super) contacts: Vec<Contact>,
    pub(super) lights: LightCycle,
    pub(super) lamps: Lamps,
    /// The actors of the map's lights, in the order of its list.
    pub(super) light_ids: Vec<u32>,
    next_id: u32,
    /// How many numbers had been given in other episodes, or somewhat more: whole rounds of [`VehicleBlueprint::LOOKS`].
    ids_before: u32,
    next_stream: u32,
    own_stream: u32,
    /// No snapshot has told of the map yet.
    is_new: bool,
}

impl Episode {
    /// The first one on a map, or the one after another.
    pub(super) fn new(
        map: NamedMap,
        layers: u16,
        seed: u64,
        blueprints: &BlueprintLibrary,
        before: Option<&Self>,
    ) -> Self {
        let NamedMap { name: map_name, loaded: map } = map;
        // Clients that did not load the map hear of it through the stream of snapshots, which stays. All other numbers are never
        // used twice: what sensors of an ended episode send must not reach those of this one.
        let own_stream = before.map_or(1, |before| before.own_stream);
        let next_stream = before.map_or(own_stream, |before| before.next_stream);
        // Nor are numbers of actors: clients keep what they were told of one.
        let parked = map.town.parked.len() as u32;
        // Clients know an actor's id, not its number in the episode: both name the same look.
        let ids_before =
            before.map_or(0, |before| before.next_id.saturating_sub(parked).next_multiple_of(VehicleBlueprint::LOOKS));
        let (id, frame) = before.map_or((1, 0), |before| (before.id + 1, before.frame));
        let mut episode = Self {
            id,
            frame,
            elapsed_s: 0.0,
            delta_s: 0.0,
            weather: CLEAR_NOON,
            actors: BTreeMap::new(),
            spectator: 0,
            seed,
            population: 0,
            contacts: Vec::new(),
            lights: map.roads.light_cycle(),
            lamps: Lamps::new(&map.town),
            light_ids: Vec::new(),
            // Parked vehicles have the first numbers in pictures.
            next_id: ids_before + parked,
            ids_before,
            next_stream,
            own_stream,
            is_new: true,
            scenery: Scenery::new(Arc::clone(&map), layers),
            map,
            map_name,
        };
        episode.populate(blueprints);
        episode.light_layer();
        episode
    }

    /// Its map, for another episode.
    pub(super) fn named_map(&self) -> NamedMap {
        NamedMap { name: self.map_name.clone(), loaded: Arc::clone(self.scenery.whole()) }
    }

    /// Loads layers of its map, named by their bits, or takes them away: street lamps go with theirs.
    pub(super) fn set_layers(&mut self, layers: u16, loaded: bool) {
        self.scenery.set_layers(layers, loaded);
        self.light_layer();
    }

    fn light_layer(&mut self) {
        self.lamps.set_standing(self.scenery.has(MapLayer::StreetLights));
    }

    /// Shows what of the map is to be shown by now.
    pub(super) fn show_scenery(&mut self, catalogue: &Catalogue) {
        if let Some(map) = self.scenery.changed(catalogue) {
            self.map = map;
        }
    }

    /// The number of the stream of snapshots.
    pub(super) fn stream(&self) -> u32 {
        self.own_stream
    }

    /// The streams of its sensors.
    pub(super) fn sensor_streams(&self) -> Vec<u32> {
        let sensors = self.actors.values().filter_map(|actor| match &actor.body {
            Body::Sensor(sensor) => Some(sensor.stream),
            _ => None,
        });
        sensors.collect()
    }

    /// The actors that every episode has.
    fn populate(&mut self, blueprints: &BlueprintLibrary) {
        self.spectator = self.allocate_id();
        let above = Transform { location: Vector3D { z: 50.0, ..Vector3D::default() }, ..Transform::default() };
        if let Some(blueprint) = blueprints.find("spectator") {
            self.insert(ServerActor::own(blueprint, self.spectator, above, Body::Other));
        }
        self.put_up_signals(blueprints);
    }

    pub(super) fn insert(&mut self, actor: ServerActor) {
        self.population += 1;
        self.actors.insert(actor.told.id, actor);
    }

    pub(super) fn remove(&mut self, id: u32) -> Option<ServerActor> {
        self.population += 1;
        self.actors.remove(&id)
    }

    fn record(&self, actor: &ServerActor) -> ActorRecord {
        let state = match &actor.body {
            Body::Vehicle(vehicle) => {
                let c = &vehicle.control;
                ActorRecordState::Vehicle(VehicleRecord {
                    throttle: c.throttle,
                    steer: c.steer,
                    brake: c.brake,
                    hand_brake: c.hand_brake,
                    reverse: c.reverse,
                    manual_gear_shift: c.manual_gear_shift,
                    gear: vehicle.body.gear(),
                    ..self.on_road(actor)
                })
            }
            Body::Light(light) => ActorRecordState::Light(self.light_record(*light)),
            Body::Walker(walker) => ActorRecordState::Walker(WalkerRecord {
                direction: walker.control.direction.clone(),
                speed: walker.control.speed,
                jump: walker.control.jump,
            }),
            Body::Sign(id) => ActorRecordState::Sign(id.clone()),
            _ => ActorRecordState::Other,
        };
        ActorRecord {
            id: actor.told.id,
            transform: actor.transform.clone(),
            velocity: actor.velocity.clone(),
            angular_velocity: actor.angular_velocity.clone(),
            acceleration: actor.acceleration.clone(),
            state,
        }
    }

    /// A number for another actor.
    pub(super) fn allocate_id(&mut self) -> u32 {
        // In pictures an object has the last 16 bits: parked vehicles keep theirs, and nobody has 0.
        let parked = self.map.town.parked.len() as u32;
        self.next_id += 1;
        while self.next_id & 0xffff <= parked {
            self.next_id += 1;
        }
        self.next_id
    }

    /// The number that an actor would have in the first episode of a server: what is drawn by it is the same in each.
    pub(super) fn number_in_episode(&self, id: u32) -> u32 {
        id.saturating_sub(self.ids_before)
    }

    /// Whether an actor has ever had this number.
    pub(super) fn has_given(&self, id: u32) -> bool {
        id != 0 && id <= self.next_id
    }

    /// A number for another stream.
    pub(super) fn allocate_stream(&mut self) -> u32 {
        self.next_stream += 1;
        self.next_stream
    }

    /// Time passes.
    pub(super) fn step(&mut self, step_s: f64) {
        self.frame += 1;
        self.elapsed_s += step_s;
        self.delta_s = step_s;
        self.lights.tick(step_s);
        self.feel_friction();
        self.move_bodies(step_s);
        self.turn_arms(step_s);
        self.carry_attached();
    }

    /// What is attached goes with whom it is attached to, who always has a lower number.
    pub(super) fn carry_attached(&mut self) {
        let ids: Vec<u32> = self.actors.keys().copied().collect();
        for id in ids {
            let Some(actor) = self.actors.get(&id) else { continue };
            let Some(on_parent) = &actor.on_parent else { continue };
            let Some(parent) = self.actors.get(&actor.told.parent_id) else { continue };
            let transform = match &actor.arm {
                Some(arm) => self.on_arm(arm, parent, on_parent),
                None => frames::attached(&parent.transform, on_parent),
            };
            let velocity = parent.velocity.clone();
            let (angular, acceleration) = (parent.angular_velocity.clone(), parent.acceleration.clone());
            if let Some(actor) = self.actors.get_mut(&id) {
                actor.transform = transform;
                actor.velocity = velocity;
                actor.angular_velocity = angular;
                actor.acceleration = acceleration;
            }
        }
    }

    /// The message that tells of this instant.
    pub(super) fn snapshot(&mut self, platform_timestamp: f64) -> Vec<u8> {
        let header = SensorHeader {
            type_id: WORLD_OBSERVER,
            frame: self.frame,
            timestamp: self.elapsed_s,
            transform: Transform::default(),
        };
        let episode = EpisodeHeader {
            id: self.id,
            platform_timestamp,
            delta_seconds: self.delta_s as f32,
            map_change: std::mem::take(&mut self.is_new),
            light_update: self.lamps.take_news(),
        };
        let records: Vec<_> = self.actors.values().map(|actor| self.record(actor)).collect();
        snapshot(&header, &episode, &records)
    }
}
