//! Writes what happens into a file.

use super::folder::RecordingFolder;
use super::recorded;
use crate::recording::{FrameStart, LogHeader, Packet, RecordedParent};
use crate::server::actor::ServerActor;
use crate::server::call_error::CallError;
use crate::server::episode::Episode;
use crate::server::world::World;
use crate::wire::LightState;
use std::collections::BTreeSet;
use std::fs::File;
use std::io::{self, Write as _};
use std::path::PathBuf;
use std::time::{Instant, SystemTime, UNIX_EPOCH};

/// Writes what happens into a file, frame by frame.
pub(super) struct Recorder {
    file: File,
    /// Of the last frame.
    frame: FrameStart,
    /// Who was there in the last frame.
    known: BTreeSet<u32>,
    /// Boxes, velocities and what vehicles are made of are written, too.
    tells_more: bool,
    collisions: u32,
    begun: Instant,
}

impl World {
    /// Begins to record; gives the path of the file.
    pub(in crate::server) fn start_recorder(&mut self, name: &str, tells_more: bool) -> Result<String, CallError> {
        self.stop_replayer(false);
        self.recordings.recorder = None;
        let (mut file, path) = self.recordings.folder()?.create(name)?;
        let now_s = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs() as i64);
        let mut bytes = Vec::new();
        LogHeader::new(&self.episode.map.name, now_s).write(&mut bytes);
        let failed = |error| CallError::refused(format!("cannot record to '{name}': {error}"));
        file.write_all(&bytes).map_err(failed)?;
        self.recordings.recorder = Some(Recorder {
            file,
            frame: FrameStart::default(),
            known: BTreeSet::new(),
            tells_more,
            collisions: 0,
            begun: Instant::now(),
        });
        Ok(path.display().to_string())
    }

    pub(in crate::server) fn stop_recorder(&mut self) {
        self.recordings.recorder = None;
    }

    /// After a step: what there is now goes into the file, if one is recorded.
    pub(in crate::server) fn record(&mut self) {
        let changed = self.episode.lamps.take_changed();
        let Some(recorder) = &mut self.recordings.recorder else { return };
        if let Err(error) = recorder.record(&self.episode, changed) {
            tracing::warn!("the recording ends: {error}");
            self.recordings.recorder = None;
        }
    }
}

impl super::Recordings {
    /// The path of a recording, which may not exist.
    pub(in crate::server) fn path(&self, name: &str) -> Result<PathBuf, CallError> {
        self.folder()?.path(name)
    }

    pub(super) fn folder(&self) -> Result<&RecordingFolder, CallError> {
        let missing = "there is no folder for recordings: start the server with --recordings DIR";
        self.folder.as_ref().ok_or_else(|| CallError::refused(missing))
    }
}

impl Recorder {
    fn record(&mut self, episode: &Episode, changed: Vec<LightState>) -> io::Result<()> {
        let elapsed_s = self.frame.elapsed_s + self.frame.duration_s;
        self.frame = FrameStart { id: self.frame.id + 1, duration_s: episode.delta_s, elapsed_s };
        let mut bytes = Vec::new();
        let lamps = if self.frame.id == 1 { episode.lamps.states() } else { changed };
        for packet in self.packets(episode, &lamps) {
            packet.write(&mut bytes);
        }
        self.known = episode.actors.keys().copied().collect();
        self.file.write_all(&bytes)
    }

    /// The packets of a frame. Collisions come before parents: programs that read CARLA's text expect them so.
    fn packets(&mut self, episode: &Episode, lamps: &[LightState]) -> Vec<Packet> {
        let all = || episode.actors.values();
        let new: Vec<&ServerActor> = all().filter(|actor| !self.known.contains(&actor.told.id)).collect();
        let gone = self.known.iter().filter(|id| !episode.actors.contains_key(id)).copied().collect();
        let carried = new.iter().filter(|actor| actor.told.parent_id != 0);
        let parent = |actor: &&ServerActor| RecordedParent { child: actor.told.id, parent: actor.told.parent_id };
        let collisions = recorded::collisions(episode, self.collisions);
        self.collisions += collisions.len() as u32;
        let mut packets = vec![
            Packet::FrameStart(self.frame.clone()),
            Packet::Created(new.iter().map(|actor| recorded::created(actor)).collect()),
            Packet::Destroyed(gone),
            Packet::Collisions(collisions),
            Packet::Parents(carried.map(parent).collect()),
            Packet::Positions(all().filter_map(recorded::position).collect()),
            Packet::LightStates(all().filter_map(|actor| recorded::light_state(episode, actor)).collect()),
            Packet::Vehicles(all().filter_map(recorded::vehicle).collect()),
            Packet::Walkers(all().filter_map(recorded::walker).collect()),
            Packet::VehicleLights(all().filter_map(recorded::vehicle_lights).collect()),
            Packet::SceneLights(lamps.iter().map(recorded::lamp).collect()),
        ];
        if self.tells_more {
            let of_new = || new.iter().copied();
            packets.extend([
                Packet::Kinematics(all().filter_map(recorded::kinematics).collect()),
                Packet::Boxes(of_new().filter_map(recorded::bounds).collect()),
                Packet::Triggers(of_new().filter_map(recorded::trigger).collect()),
                Packet::PlatformTime(self.begun.elapsed().as_secs_f64()),
                Packet::Physics(of_new().filter_map(recorded::physics).collect()),
                Packet::LightTimes(of_new().filter_map(|actor| recorded::light_times(episode, actor)).collect()),
            ]);
        }
        packets.push(Packet::FrameEnd);
        packets
    }
}
