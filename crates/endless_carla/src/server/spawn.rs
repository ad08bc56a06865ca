//! Actors that come and go.

use super::actor::{Body, PropActor, SensorActor, ServerActor};
use super::call_error::CallError;
use super::episode::Episode;
use super::friction::FrictionTrigger;
use super::sensor_model::sensor_model;
use super::vehicle_actor::VehicleActor;
use super::walker_actor::WalkerActor;
use super::world::World;
use crate::blueprint::{Attributes, BlueprintKind, SensorKind};
use crate::frames;
use crate::wire::{Actor, ActorDescription, BoundingBox, Bytes, Transform};
use endless_world::Stream;

impl World {
    /// Makes an actor where its transform says, in the world or on its parent; gives its number.
    pub(super) fn spawn(
        &mut self,
        description: &ActorDescription,
        transform: Transform,
        parent: Option<u32>,
    ) -> Result<u32, CallError> {
        let invalid = || CallError::refused("Spawn failed because of invalid actor description");
        let blueprint = self.blueprints.spawnable(description).ok_or_else(invalid)?.clone();
        if !frames::is_finite(&transform) {
            return Err(CallError::refused("Spawn failed because of a transform that is no place"));
        }
        let placed = match parent {
            None => transform.clone(),
            Some(parent) => frames::attached(&self.episode.actor(parent)?.transform, &transform),
        };
        let attributes = blueprint.attributes(description);
        let description = attributes.complete()?;
        let episode = &mut self.episode;
        let id = episode.allocate_id();
        let number = episode.number_in_episode(id);
        let body = match blueprint.kind {
            BlueprintKind::Sensor(kind) => sensor(kind, &attributes, parent.is_some(), number, episode)?,
            BlueprintKind::Vehicle(vehicle) => {
                let body = VehicleActor::new(&vehicle, &attributes, self.shelf.catalogue(), number, &placed)?;
                if episode.is_taken(&body.body.outline()) {
                    return Err(CallError::refused("Spawn failed because of collision at spawn position"));
                }
                Body::Vehicle(Box::new(body))
            }
            BlueprintKind::Walker(walker) => {
                Body::Walker(Box::new(WalkerActor::new(&walker, &blueprint, &attributes, &placed)?))
            }
            BlueprintKind::Prop(prop) => Body::Prop(PropActor { body: prop.body, collides: true }),
            BlueprintKind::FrictionTrigger => Body::FrictionTrigger(FrictionTrigger::new(&attributes)?),
            _ => Body::Other,
        };
        let catalogue = self.shelf.catalogue();
        let bounds = match &body {
            Body::Vehicle(vehicle) => self.drawn_boxes.vehicle(catalogue, vehicle.asset),
            Body::Walker(walker) => Some(self.drawn_boxes.person(catalogue, walker.asset, walker.origin_height_m)),
            Body::FrictionTrigger(trigger) => Some(trigger.bounds()),
            _ => None,
        };
        let bounding_box = BoundingBox { actor_id: id, ..bounds.unwrap_or_else(|| blueprint.bounding_box.clone()) };
        let token = match &body {
            Body::Sensor(sensor) if sensor.stream != 0 => {
                self.hub.open(sensor.stream);
                self.token(sensor.stream)
            }
            _ => Bytes::default(),
        };
        let told = Actor {
            id,
            parent_id: parent.unwrap_or(0),
            description,
            bounding_box,
            semantic_tags: Bytes(blueprint.semantic_tags.clone()),
            stream_token: token,
        };
        let actor = ServerActor { on_parent: parent.map(|_| transform), ..ServerActor::new(told, placed, body) };
        self.episode.insert(actor);
        Ok(id)
    }

    /// Takes an actor away, and what is attached to it; gives whether it was there.
    pub(super) fn destroy(&mut self, id: u32) -> bool {
        let is_own = |actor: &ServerActor| matches!(actor.body, Body::Light(_) | Body::Sign(_));
        if id == self.episode.spectator || self.episode.actors.get(&id).is_none_or(is_own) {
            return false;
        }
        let children: Vec<u32> = self
            .episode
            .actors
            .values()
            .filter(|actor| actor.told.parent_id == id)
            .map(|actor| actor.told.id)
            .collect();
        for child in children {
            self.destroy(child);
        }
        if let Some(gone) = self.episode.remove(id)
            && let Body::Sensor(sensor) = gone.body
        {
            self.hub.close(sensor.stream);
            self.sensing.forget(sensor.stream);
        }
        true
    }
}

fn sensor(
    kind: SensorKind,
    attributes: &Attributes<'_>,
    is_carried: bool,
    number: u32,
    episode: &mut Episode,
) -> Result<Body, CallError> {
    let model = sensor_model(kind, attributes, is_carried)?;
    let stream = if kind.streams() { episode.allocate_stream() } else { 0 };
    let tick_s = if attributes.has("sensor_tick") { attributes.sensor_tick_secs()? } else { 0.0 };
    let seed = noise_seed(attributes, number, episode.seed)?;
    let due_s = episode.elapsed_s;
    Ok(Body::Sensor(SensorActor { kind, stream, model, tick_s, due_s, last_s: None, count: 0, seed }))
}

/// The seed of a sensor's noise: that which its attribute says, so that the same noise can be had again; otherwise each sensor
/// of an episode has its own.
fn noise_seed(attributes: &Attributes<'_>, number: u32, seed: u64) -> Result<u64, CallError> {
    let told = if attributes.has("noise_seed") { attributes.integer("noise_seed")? } else { 0 };
    let (name, key) =
        if told == 0 { ("carla sensor", u64::from(number)) } else { ("noise_seed", told.cast_unsigned()) };
    Ok(Stream::named(seed, name, &[key]).next_u64())
}
