//! A world in which a recording is replayed: its actors come, go and move as they did.

use super::replay_frame::ReplayFrame;
use super::replayer::{ReplayPart, ReplayRequest, Replayer};
use crate::frames;
use crate::recording::{LogReader, RecordingError};
use crate::server::actor::Body;
use crate::server::call_error::CallError;
use crate::server::map_layer::MapLayer;
use crate::server::world::World;
use crate::wire::{Vector3D, VehicleControl, WalkerControl};
use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;
use std::io::BufReader;

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
        let unread = |error: RecordingError| CallError::refused(format!("'{name}': {error}"));
        let mut log = LogReader::new(BufReader::new(file)).map_err(unread)?;
        let map = log.header().map.rsplit('/').next().unwrap_or_default().to_owned();
        if map != self.episode.map_name {
            if self.load(&map, false, MapLayer::ALL).is_err() {
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
}
