//! Actors that come and go in a replay.

use super::place::transform_of;
use super::recorded;
use super::replay_frame::ReplayFrame;
use super::replayer::ReplayPart;
use crate::frames;
use crate::recording::RecordedActor;
use crate::server::call_error::CallError;
use crate::server::world::World;
use crate::wire::{ActorAttributeValue, ActorDescription, AttributeType, Transform, Wire as _};
use rmpv::Value;

/// So near is a light or sign of the map the one that was recorded, metres.
const SAME_M: f32 = 1.0;
/// So high are those that come before they are put into their place, metres: nobody is in their way.
const HIGH_M: f32 = 5000.0;

impl World {
    /// Those come and go who did so at the beginning of a frame.
    pub(super) fn replay_events(&mut self, part: &mut ReplayPart, frame: &ReplayFrame) {
        for recorded in &frame.created {
            match self.replayed(part, frame, recorded) {
                Ok(None) => {}
                Ok(Some(id)) => {
                    part.ids.insert(recorded.id, id);
                    if recorded.is_hero() {
                        part.heroes.insert(recorded.id);
                    }
                    let is_left_alone = self.recordings.options.ignores_hero && recorded.is_hero();
                    let _ = self.episode.simulate_physics(id, is_left_alone);
                }
                Err(error) => tracing::warn!("a replay cannot make {}: {error}", recorded.blueprint),
            }
        }
        let lamps: Vec<_> = frame.scene_lights.iter().filter_map(recorded::lamp_state).collect();
        self.episode.lamps.set(&lamps);
        for gone in &frame.destroyed {
            if let Some(id) = part.ids.remove(gone) {
                self.destroy(id);
            }
        }
    }

    /// The actor that takes the part of one that was recorded: one that is there, or a new one; nobody for what is not replayed.
    fn replayed(
        &mut self,
        part: &mut ReplayPart,
        frame: &ReplayFrame,
        recorded: &RecordedActor,
    ) -> Result<Option<u32>, CallError> {
        let transform = transform_of(recorded.location, recorded.rotation);
        match recorded.blueprint.split('.').next() {
            Some("spectator") => return Ok(Some(self.episode.spectator)),
            Some("traffic") => return Ok(self.standing(recorded, &transform)),
            // Clients move walkers by these, and a recording does it here.
            Some("controller") => return Ok(None),
            Some("sensor") if !part.has_sensors => return Ok(None),
            _ => {}
        }
        let there = self.episode.actors.get(&recorded.id);
        if there.is_some_and(|actor| actor.told.description.id == recorded.blueprint) {
            return Ok(Some(recorded.id));
        }
        let parent = frame.parents.iter().find(|pair| pair.child == recorded.id).map(|pair| pair.parent);
        let id = match parent.and_then(|parent| part.ids.get(&parent)) {
            Some(&parent) => {
                let on_parent = frames::detached(&self.recorded_place(frame, parent, part)?, &transform);
                self.spawn(&description(recorded), on_parent, Some(parent))?
            }
            None => {
                let mut high = transform.clone();
                high.location.z += HIGH_M;
                let id = self.spawn(&description(recorded), high, None)?;
                self.episode.put(id, transform)?;
                id
            }
        };
        part.made.insert(id);
        Ok(Some(id))
    }

    /// Where an actor was at the beginning of a frame in which another one came onto it.
    fn recorded_place(&self, frame: &ReplayFrame, id: u32, part: &ReplayPart) -> Result<Transform, CallError> {
        let recorded = part.ids.iter().find(|(_, own)| **own == id).map(|(recorded, _)| *recorded);
        let then = frame.positions.iter().find(|position| Some(position.actor) == recorded);
        match then {
            Some(position) => Ok(transform_of(position.location, position.rotation)),
            None => Ok(self.episode.actor(id)?.transform.clone()),
        }
    }

    /// The light or sign of the map that stands where one was recorded.
    fn standing(&self, recorded: &RecordedActor, transform: &Transform) -> Option<u32> {
        let place = frames::from_carla(&transform.location);
        let away =
            |actor: &crate::server::actor::ServerActor| frames::from_carla(&actor.transform.location).distance(place);
        let alike = self.episode.actors.values().filter(|actor| actor.told.description.id == recorded.blueprint);
        let nearest = alike.min_by(|a, b| away(a).total_cmp(&away(b)))?;
        (away(nearest) <= SAME_M).then_some(nearest.told.id)
    }
}

fn description(recorded: &RecordedActor) -> ActorDescription {
    let attributes = recorded.attributes.iter().map(|attribute| ActorAttributeValue {
        id: attribute.id.clone(),
        kind: AttributeType::from_value(&Value::from(attribute.kind)).unwrap_or_default(),
        value: attribute.value.clone(),
    });
    ActorDescription { uid: recorded.uid, id: recorded.blueprint.clone(), attributes: attributes.collect() }
}
