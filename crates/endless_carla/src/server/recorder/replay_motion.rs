//! How actors move, and what lights show, in a replay.

use super::place::transform_of;
use super::replay_frame::{ReplayFrame, between};
use super::replayer::{ReplayPart, Replayer};
use crate::frames;
use crate::recording::{RecordedPosition, RecordedWalker};
use crate::server::actor::Body;
use crate::server::call_error::CallError;
use crate::server::world::World;
use crate::wire::{Transform, Vector3D, VehicleControl};
use std::collections::BTreeMap;

impl World {
    /// Everybody is where they were at a time, between two frames.
    pub(super) fn replay_places(&mut self, replayer: &Replayer, at_s: f64) {
        let Replayer { now, next, part, .. } = replayer;
        let options = &self.recordings.options;
        let (ignores_hero, ignores_spectator, factor) =
            (options.ignores_hero, options.ignores_spectator, options.time_factor);
        let coming: BTreeMap<u32, &RecordedPosition> =
            next.iter().flat_map(|next| &next.positions).map(|position| (position.actor, position)).collect();
        let long_s = next.as_ref().map_or(0.0, |next| next.start.elapsed_s - now.start.elapsed_s);
        let share = if long_s > 0.0 { ((at_s - now.start.elapsed_s) / long_s).clamp(0.0, 1.0) as f32 } else { 0.0 };
        let speeds: BTreeMap<u32, f32> =
            now.walkers.iter().map(|RecordedWalker { actor, speed }| (*actor, *speed)).collect();
        for position in &now.positions {
            let Some(&id) = part.ids.get(&position.actor) else { continue };
            let is_ignored = (ignores_hero && part.heroes.contains(&position.actor))
                || (id == self.episode.spectator && (ignores_spectator || part.follows.is_some()));
            if is_ignored {
                continue;
            }
            let coming = coming.get(&position.actor).copied().unwrap_or(position);
            let place = between(position, coming, share);
            let scale = if long_s > 0.0 { (0.01 * factor / long_s) as f32 } else { 0.0 };
            let [x, y, z] = [0, 1, 2].map(|axis: usize| scale * (coming.location[axis] - position.location[axis]));
            let speed = speeds.get(&position.actor).copied().unwrap_or(0.0);
            let transform = transform_of(place.location, place.rotation);
            if let Err(error) = self.replay_place(id, transform, Vector3D { x, y, z }, speed) {
                tracing::debug!("in a replay: {error}");
            }
        }
        if let Some((followed, offset)) = &part.follows
            && let Some(actor) = part.ids.get(followed).and_then(|id| self.episode.actors.get(id))
        {
            let view = frames::attached(&actor.transform, offset);
            let _ = self.episode.put(self.episode.spectator, view);
        }
    }

    fn replay_place(&mut self, id: u32, at: Transform, velocity: Vector3D, speed: f32) -> Result<(), CallError> {
        match self.episode.actor(id)?.body {
            Body::Walker(_) => self.episode.put_walker(id, at, speed)?,
            Body::Vehicle(_) => {
                self.episode.put(id, at)?;
                self.episode.set_target_velocity(id, &velocity)?;
            }
            _ => self.episode.put(id, at)?,
        }
        if let Some(actor) = self.episode.actors.get_mut(&id) {
            actor.velocity = velocity;
        }
        Ok(())
    }

    /// Pedals, lamps and traffic lights as they were in a frame.
    pub(super) fn replay_states(&mut self, part: &ReplayPart, frame: &ReplayFrame) {
        let ignores_hero = self.recordings.options.ignores_hero;
        let own = |actor: &u32| {
            let is_ignored = ignores_hero && part.heroes.contains(actor);
            part.ids.get(actor).copied().filter(|_| !is_ignored)
        };
        let episode = &mut self.episode;
        for recorded in &frame.vehicles {
            if let Some(id) = own(&recorded.actor)
                && let Ok(vehicle) = episode.vehicle(id)
            {
                vehicle.apply_control(&VehicleControl {
                    throttle: recorded.throttle,
                    steer: recorded.steer,
                    brake: recorded.brake,
                    hand_brake: recorded.hand_brake,
                    reverse: recorded.gear < 0,
                    manual_gear_shift: false,
                    gear: recorded.gear,
                });
            }
        }
        for recorded in &frame.vehicle_lights {
            if let Some(Ok(vehicle)) = own(&recorded.actor).map(|id| episode.vehicle(id)) {
                vehicle.set_lights(recorded.lights);
            }
        }
        for recorded in &frame.light_states {
            if let Some(id) = own(&recorded.actor)
                && let Ok(light) = episode.light(id)
            {
                episode.lights.freeze(light, recorded.frozen);
                let _ = episode.set_light_state(id, recorded.state);
            }
        }
    }
}
