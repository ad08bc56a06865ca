//! Collision sensors: who meets whom.

use crate::blueprint::SensorKind;
use crate::frames;
use crate::physics::{Contact, Party};
use crate::server::actor::Body;
use crate::server::episode::Episode;
use crate::stream::{SensorHeader, StreamHub};
use crate::wire::{Actor, Bytes, Wire};
use endless_world::ClassTag;
use glam::DVec3;
use rmpv::Value;

/// What collision sensors tell of the contacts of this frame: `[who carries the sensor, whom it met, impulse]`, N s.
pub(super) fn collisions(episode: &Episode, hub: &StreamHub) -> Vec<(u32, Vec<u8>)> {
    let mut messages = Vec::new();
    for contact in &episode.contacts {
        for (own, other, impulse) in sides(contact) {
            let Party::Body(own) = own else { continue };
            for (stream, header) in sensors_of(episode, own) {
                if !hub.is_heard(stream) {
                    continue;
                }
                let (Some(carrier), other) = (episode.actors.get(&own), told(episode, other)) else { continue };
                let impulse = frames::to_carla(impulse.as_vec3()).to_value();
                let payload = Value::Array(vec![carrier.told.to_value(), other.to_value(), impulse]);
                messages.push((stream, header.with_msgpack(&payload)));
            }
        }
    }
    messages
}

/// A contact as each of both feels it.
fn sides(contact: &Contact) -> [(Party, Party, DVec3); 2] {
    [(contact.a, contact.b, -contact.impulse), (contact.b, contact.a, contact.impulse)]
}

/// Whom something met: an actor, or a thing of the map.
fn told(episode: &Episode, party: Party) -> Actor {
    let actor = match party {
        Party::Body(id) => Some(id),
        Party::Obstacle(id) => u32::try_from(id).ok(),
    };
    if let Some(actor) = actor.and_then(|id| episode.actors.get(&id)) {
        return actor.told.clone();
    }
    let tag = match party {
        Party::Obstacle(id) => episode.map.obstacles.tag(id),
        Party::Body(_) => None,
    };
    thing(tag.unwrap_or(ClassTag::Unlabeled))
}

/// A thing of the map: CARLA's actor without a number.
pub(super) fn thing(tag: ClassTag) -> Actor {
    let mut thing = Actor::default();
    thing.description.id = format!("static.{}", kind(tag));
    thing.semantic_tags = Bytes(vec![tag.value()]);
    thing
}

/// The word for a class in the names of things.
fn kind(tag: ClassTag) -> String {
    match tag {
        ClassTag::Unlabeled => "unknown".to_owned(),
        ClassTag::Roads => "road".to_owned(),
        ClassTag::Sidewalks => "sidewalk".to_owned(),
        ClassTag::Buildings => "building".to_owned(),
        ClassTag::Walls => "wall".to_owned(),
        ClassTag::Fences => "fence".to_owned(),
        ClassTag::Poles => "pole".to_owned(),
        ClassTag::TrafficSigns => "trafficsign".to_owned(),
        other => other.name().to_lowercase(),
    }
}

fn sensors_of(episode: &Episode, carrier: u32) -> impl Iterator<Item = (u32, SensorHeader)> {
    episode.actors.values().filter_map(move |actor| match &actor.body {
        Body::Sensor(sensor) if sensor.kind == SensorKind::Collision && actor.told.parent_id == carrier => {
            Some((sensor.stream, sensor.header(&actor.transform, episode.frame, episode.elapsed_s)))
        }
        _ => None,
    })
}
