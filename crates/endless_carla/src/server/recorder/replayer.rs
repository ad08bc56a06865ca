//! Replays a recording: its actors come, go and move as they did.

use super::replay_frame::{ReplayFrame, between};
use super::transform_of;
use crate::frames;
use crate::recording::{LogReader, RecordedPosition, RecordedWalker};
use crate::server::actor::Body;
use crate::server::call_error::CallError;
use crate::server::world::World;
use crate::wire::{Transform, Vector3D, VehicleControl, WalkerControl};
use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;
use std::io::BufReader;

/// A recording that is replayed.
pub(super) struct Replayer {
    log: LogReader<BufReader<File>>,
    /// The last frame that has begun.
    now: ReplayFrame,
    /// The one after it.
    next: Option<ReplayFrame>,
    /// Since the first frame, seconds.
    time_s: f64,
    end_s: f64,
    pub(super) part: ReplayPart,
}

/// Who takes part.
pub(super) struct ReplayPart {
    /// Actors here, by their numbers in the recording.
    pub(super) ids: BTreeMap<u32, u32>,
    /// Those that have come for the recording, by their numbers here.
    pub(super) made: BTreeSet<u32>,
    /// By their numbers in the recording.
    pub(super) heroes: BTreeSet<u32>,
    pub(super) has_sensors: bool,
    /// Whom the spectator follows, by its number in the recording, and from where.
    follows: Option<(u32, Transform)>,
}

/// What is to be replayed.
pub(in crate::server) struct ReplayRequest {
    /// The recording.
    pub(in crate::server) name: String,
    /// Seconds after its beginning; before its end if negative.
    pub(in crate::server) start_s: f64,
    /// Seconds; 0 for all of it.
    pub(in crate::server) duration_s: f64,
    /// Whom the spectator follows, by its number in the recording; 0 for nobody.
    pub(in crate::server) follow: u32,
    /// Whether sensors come, too.
    pub(in crate::server) sensors: bool,
    /// Where the spectator is on whom it follows.
    pub(in crate::server) offset: Transform,
}

impl World {
    /// Begins to replay a recording; gives what CARLA says of it.
    pub(in crate::server) fn replay_file(&mut self, request: ReplayRequest) -> Result<String, CallError> {
        self.stop_recorder();
        self.stop_replayer(false);
        let ReplayRequest { name, start_s, duration_s, follow, sensors, offset } = request;
        if !start_s.is_finite() || !duration_s.is_finite() || !frames::is_finite(&offset) {
            return Err(CallError::refused("start, duration and offset must be numbers"));
        }
        let path = self.recordings.folder()?.path(&name)?;
        let mut text = format!("Replaying File: {}\n", path.display());
        let Ok(file) = File::open(&path) else {
            return Ok(text + &format!("File {} not found on server\n", path.display()));
        };
        let unread = |error: crate::recording::RecordingError| CallError::refused(format!("'{name}': {error}"));
        let mut log = LogReader::new(BufReader::new(file)).map_err(unread)?;
        let map = log.header().map.rsplit('/').next().unwrap_or_default().to_owned();
        if map != self.episode.map.name {
            if self.load(&map, false).is_err() {
                return Ok(text + &format!("Could not load mapfile {map}\n"));
            }
            text += &format!("Loading map {map}\n");
        }
        let total_s = log.total_s().map_err(unread)?;
        let start_s = if start_s < 0.0 { (total_s + start_s).max(0.0) } else { start_s };
        let end_s = if duration_s > 0.0 { start_s + duration_s } else { total_s };
        let options = &self.recordings.options;
        let number = |number: f64| format!("{}", (number * 1e4).round() / 1e4);
        text += &format!("Total time recorded: {}\n", number(total_s));
        let (from, to, all, factor) = (number(start_s), number(end_s), number(total_s), options.time_factor);
        text += &format!("Replaying from {from} s - {to} s ({all} s) at {factor:.1}x\n");
        if options.ignores_hero {
            text += "Ignoring Hero vehicle\n";
        }
        if options.ignores_spectator {
            text += "Ignoring Spectator camera\n";
        }
        let part = ReplayPart {
            ids: BTreeMap::new(),
            made: BTreeSet::new(),
            heroes: BTreeSet::new(),
            has_sensors: sensors,
            follows: (follow != 0).then_some((follow, offset)),
        };
        let Some(now) = ReplayFrame::read(&mut log).map_err(unread)? else { return Ok(text) };
        let next = ReplayFrame::read(&mut log).map_err(unread)?;
        let mut replayer = Replayer { log, now, next, time_s: 0.0, end_s, part };
        self.replay_events(&mut replayer.part, &replayer.now);
        self.replay_to(&mut replayer, start_s);
        self.recordings.replayer = Some(replayer);
        Ok(text)
    }

    /// Ends the replay. Its actors stay where they are and go on by themselves, or go with it.
    pub(in crate::server) fn stop_replayer(&mut self, keep_actors: bool) {
        let Some(replayer) = self.recordings.replayer.take() else { return };
        for &id in replayer.part.ids.values() {
            let is_made = replayer.part.made.contains(&id);
            if is_made && !keep_actors {
                self.destroy(id);
            } else if let Err(error) = self.let_go(id) {
                tracing::info!("after a replay: {error}");
            }
        }
    }

    /// An actor is no longer moved by a recording.
    fn let_go(&mut self, id: u32) -> Result<(), CallError> {
        let transform = self.episode.actor(id)?.transform.clone();
        match self.episode.actor(id)?.body {
            Body::Vehicle(_) => {
                self.episode.simulate_physics(id, true)?;
                self.episode.set_target_velocity(id, &Vector3D::default())?;
                self.episode.vehicle(id)?.apply_control(&VehicleControl::default());
            }
            Body::Walker(_) => {
                self.episode.put_walker(id, transform, 0.0)?;
                self.episode.walker(id)?.apply_control(&WalkerControl::default());
            }
            _ => {}
        }
        Ok(())
    }

    /// After a step: the recording goes on, if one is replayed.
    pub(in crate::server) fn replay(&mut self, step_s: f64) {
        let Some(mut replayer) = self.recordings.replayer.take() else { return };
        let to_s = replayer.time_s + step_s * self.recordings.options.time_factor;
        self.replay_to(&mut replayer, to_s);
        let is_over = to_s >= replayer.end_s;
        self.recordings.replayer = Some(replayer);
        if is_over {
            self.stop_replayer(true);
        }
    }

    fn replay_to(&mut self, replayer: &mut Replayer, to_s: f64) {
        replayer.time_s = to_s;
        while let Some(next) = replayer.next.take_if(|next| next.start.elapsed_s <= to_s) {
            self.replay_events(&mut replayer.part, &next);
            replayer.now = next;
            replayer.next = ReplayFrame::read(&mut replayer.log).unwrap_or_else(|error| {
                tracing::warn!("the recording ends: {error}");
                None
            });
        }
        self.replay_places(replayer, to_s);
        self.replay_states(&replayer.part, &replayer.now);
        self.episode.carry_attached();
    }

    /// Everybody is where they were at a time, between two frames.
    fn replay_places(&mut self, replayer: &Replayer, at_s: f64) {
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
    fn replay_states(&mut self, part: &ReplayPart, frame: &ReplayFrame) {
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
