//! Who met whom in a recording, as `show_recorder_collisions` tells it.

use super::bytes::RecordingError;
use super::file_info::header_text;
use super::log_reader::LogReader;
use super::packet::Packet;
use super::record::{FrameStart, RecordedCollision};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io::{Read, Seek};

/// Letters of kinds of actors, by [`RecordedActorType`](super::RecordedActorType): others, vehicles, walkers and lights.
const KINDS: [char; 4] = ['o', 'v', 'w', 't'];
/// Letters that stand for the role `hero`, and for anybody.
const HERO: char = 'h';
const ANY: char = 'a';

/// Collisions whose first and second actors are of these kinds: a line for each, when it begins.
///
/// # Errors
/// When it cannot be read.
pub fn collisions<R: Read + Seek>(log: &mut LogReader<R>, first: char, second: char) -> Result<String, RecordingError> {
    let mut text = header_text(log.header());
    let _ = writeln!(text, "{:>8} {:>6} {:>6} {:<35} {:>6} {:<35}", "Time", "Types", "Id", "Actor 1", "Id", "Actor 2");
    let mut frame = FrameStart::default();
    let mut actors: BTreeMap<u32, (u8, String)> = BTreeMap::new();
    // Those of the frame before, which go on.
    let (mut before, mut now) = (BTreeSet::new(), BTreeSet::new());
    while let Some(packet) = log.packet()? {
        match packet {
            Packet::FrameStart(start) => {
                frame = start;
                before = std::mem::take(&mut now);
            }
            Packet::Created(created) => {
                actors.extend(created.into_iter().map(|actor| (actor.id, (actor.kind, actor.blueprint))));
            }
            Packet::Collisions(met) => {
                for RecordedCollision { first: a, second: b, first_is_hero, second_is_hero, .. } in met {
                    let kind = |id: u32| {
                        let kind = actors.get(&id).map_or(0, |(kind, _)| *kind);
                        KINDS.get(usize::from(kind)).copied().unwrap_or(KINDS[0])
                    };
                    let (kind_a, kind_b) = (kind(a), kind(b));
                    let fits = |wanted: char, own: char, is_hero: bool| {
                        wanted == ANY || wanted == own || (wanted == HERO && is_hero)
                    };
                    if !fits(first, kind_a, first_is_hero) || !fits(second, kind_b, second_is_hero) {
                        continue;
                    }
                    if !before.contains(&(a, b)) && !now.contains(&(a, b)) {
                        let name = |id: u32| actors.get(&id).map_or("", |(_, name)| name);
                        let (seconds, name_a, name_b) = (frame.elapsed_s, name(a), name(b));
                        let _ = writeln!(
                            text,
                            "{seconds:>8.0}   {kind_a} {kind_b}  {a:>6} {name_a:<35} {b:>6} {name_b:<35}"
                        );
                    }
                    now.insert((a, b));
                }
            }
            _ => {}
        }
    }
    let _ = write!(text, "\nFrames: {}\nDuration: {:.0} seconds\n", frame.id, frame.elapsed_s);
    Ok(text)
}
