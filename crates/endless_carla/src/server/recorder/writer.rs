//! Writes what happens into a file.

use super::recorded;
use crate::recording::{FrameStart, LogHeader, Packet, RecordedParent};
use crate::server::actor::ServerActor;
use crate::server::episode::Episode;
use crate::wire::LightState;
use std::collections::BTreeSet;
use std::fs::File;
use std::io::{self, Write as _};
use std::time::Instant;

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

impl Recorder {
    /// Begins a file, of a map, at a time (seconds of Unix).
    pub(super) fn new(mut file: File, map: &str, now_s: i64, tells_more: bool) -> io::Result<Self> {
        let mut bytes = Vec::new();
        LogHeader::new(map, now_s).write(&mut bytes);
        file.write_all(&bytes)?;
        let (known, begun) = (BTreeSet::new(), Instant::now());
        Ok(Self { file, frame: FrameStart::default(), known, tells_more, collisions: 0, begun })
    }

    /// After a step: what there is now.
    pub(super) fn record(&mut self, episode: &Episode, changed: Vec<LightState>) -> io::Result<()> {
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
