//! Actors as recordings tell of them.

use super::place::recorded_place;
use crate::frames;
use crate::physics::Party;
use crate::recording::{
    RecordedActor, RecordedActorType, RecordedAttribute, RecordedBox, RecordedCollision, RecordedKinematics,
    RecordedLightState, RecordedLightTimes, RecordedPhysics, RecordedPosition, RecordedSceneLight, RecordedVehicle,
    RecordedVehicleLights, RecordedWalker,
};
use crate::server::actor::{Body, ServerActor};
use crate::server::episode::Episode;
use crate::wire::{Color, LightState, Transform, Vector3D};

fn numbers(vector: &Vector3D, scale: f32) -> [f32; 3] {
    [vector.x, vector.y, vector.z].map(|number| scale * number)
}

/// An actor that has come.
pub(super) fn created(actor: &ServerActor) -> RecordedActor {
    let (told, (location, rotation)) = (&actor.told.description, recorded_place(&actor.transform));
    let attribute = |attribute: &crate::wire::ActorAttributeValue| RecordedAttribute {
        kind: attribute.kind as u8,
        id: attribute.id.clone(),
        value: attribute.value.clone(),
    };
    RecordedActor {
        id: actor.told.id,
        kind: RecordedActorType::of(&told.id) as u8,
        location,
        rotation,
        uid: told.uid,
        blueprint: told.id.clone(),
        attributes: told.attributes.iter().map(attribute).collect(),
    }
}

/// Where it is; lights, signs and what is carried are where they were, or with whom carries them.
pub(super) fn position(actor: &ServerActor) -> Option<RecordedPosition> {
    let (location, rotation) = recorded_place(&actor.transform);
    let stands = matches!(actor.body, Body::Light(_) | Body::Sign(_) | Body::Sensor(_));
    (!stands).then_some(RecordedPosition { actor: actor.told.id, location, rotation })
}

pub(super) fn light_state(episode: &Episode, actor: &ServerActor) -> Option<RecordedLightState> {
    let Body::Light(light) = actor.body else { return None };
    let record = episode.light_record(light);
    let (frozen, elapsed_s, state) = (record.frozen, record.elapsed_time, record.state);
    Some(RecordedLightState { actor: actor.told.id, frozen, elapsed_s, state })
}

pub(super) fn vehicle(actor: &ServerActor) -> Option<RecordedVehicle> {
    let Body::Vehicle(vehicle) = &actor.body else { return None };
    let control = &vehicle.control;
    Some(RecordedVehicle {
        actor: actor.told.id,
        steer: control.steer,
        throttle: control.throttle,
        brake: control.brake,
        hand_brake: control.hand_brake,
        gear: vehicle.body.gear(),
    })
}

pub(super) fn walker(actor: &ServerActor) -> Option<RecordedWalker> {
    let Body::Walker(walker) = &actor.body else { return None };
    Some(RecordedWalker { actor: actor.told.id, speed: walker.body.walking_mps() as f32 })
}

pub(super) fn vehicle_lights(actor: &ServerActor) -> Option<RecordedVehicleLights> {
    let Body::Vehicle(vehicle) = &actor.body else { return None };
    Some(RecordedVehicleLights { actor: actor.told.id, lights: vehicle.lights() })
}

pub(super) fn kinematics(actor: &ServerActor) -> Option<RecordedKinematics> {
    let moves = matches!(actor.body, Body::Vehicle(_) | Body::Walker(_));
    moves.then(|| RecordedKinematics {
        actor: actor.told.id,
        velocity: numbers(&actor.velocity, 1.0),
        angular_velocity: numbers(&actor.angular_velocity, 1.0),
    })
}

/// Its box, in its own frame.
pub(super) fn bounds(actor: &ServerActor) -> Option<RecordedBox> {
    let bounds = &actor.told.bounding_box;
    let (origin, extent) = (numbers(&bounds.location, 100.0), numbers(&bounds.extent, 100.0));
    let stands = matches!(actor.body, Body::Light(_) | Body::Sign(_));
    (!stands).then_some(RecordedBox { actor: actor.told.id, origin, extent })
}

/// Where vehicles stand at a light or sign, in the world.
pub(super) fn trigger(actor: &ServerActor) -> Option<RecordedBox> {
    let bounds = &actor.told.bounding_box;
    let own = Transform { location: bounds.location.clone(), rotation: bounds.rotation.clone() };
    let origin = numbers(&frames::attached(&actor.transform, &own).location, 100.0);
    let stands = matches!(actor.body, Body::Light(_) | Body::Sign(_));
    stands.then(|| RecordedBox { actor: actor.told.id, origin, extent: numbers(&bounds.extent, 100.0) })
}

pub(super) fn physics(actor: &ServerActor) -> Option<RecordedPhysics> {
    let Body::Vehicle(vehicle) = &actor.body else { return None };
    Some(RecordedPhysics { actor: actor.told.id, physics: vehicle.physics_control() })
}

pub(super) fn light_times(episode: &Episode, actor: &ServerActor) -> Option<RecordedLightTimes> {
    let Body::Light(light) = actor.body else { return None };
    let times = episode.lights.times(light);
    let (green_s, yellow_s, red_s) = (times.green_s, times.yellow_s, times.red_s);
    Some(RecordedLightTimes { actor: actor.told.id, green_s, yellow_s, red_s })
}

pub(super) fn lamp(lamp: &LightState) -> RecordedSceneLight {
    let [r, g, b] = [lamp.color.r, lamp.color.g, lamp.color.b].map(|part| f32::from(part) / 255.0);
    let (light, intensity, color) = (lamp.id as i32, lamp.intensity, [r, g, b, 1.0]);
    RecordedSceneLight { light, intensity, color, active: lamp.active, group: lamp.group }
}

/// The same the other way.
pub(super) fn lamp_state(recorded: &RecordedSceneLight) -> Option<LightState> {
    let [r, g, b, _] = recorded.color.map(|part| (255.0 * part.clamp(0.0, 1.0)).round() as u8);
    Some(LightState {
        id: u32::try_from(recorded.light).ok()?,
        intensity: recorded.intensity,
        group: recorded.group,
        color: Color { r, g, b },
        active: recorded.active,
        ..LightState::default()
    })
}

/// Who met whom in the last step, with numbers from `next` on; a hero comes first.
pub(super) fn collisions(episode: &Episode, next: u32) -> Vec<RecordedCollision> {
    let number = |party| if let Party::Body(id) = party { id } else { 0 };
    let is_hero = |id| {
        let actor = episode.actors.get(&id);
        actor.is_some_and(|actor| actor.told.description.attribute("role_name") == Some("hero"))
    };
    let recorded = |(id, contact): (u32, &crate::physics::Contact)| {
        let (a, b) = (number(contact.a), number(contact.b));
        let (first, second) = if is_hero(b) && !is_hero(a) { (b, a) } else { (a, b) };
        let [first_is_hero, second_is_hero] = [first, second].map(is_hero);
        RecordedCollision { id, first, second, first_is_hero, second_is_hero }
    };
    (next..).zip(&episode.contacts).map(recorded).collect()
}
