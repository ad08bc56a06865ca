//! Who stood still in a recording, as `show_recorder_actors_blocked` tells it.

use super::bytes::RecordingError;
use super::file_info::header_text;
use super::log_reader::LogReader;
use super::packet::Packet;
use super::record::FrameStart;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::{Read, Seek};

/// An actor, and how long it has not left a place.
#[derive(Default)]
struct Waiting {
    name: String,
    /// Centimetres.
    place: [f32; 3],
    since_s: f64,
    for_s: f64,
}

impl Waiting {
    fn line(&self, id: u32) -> String {
        format!("{:>8.0} {id:>6} {:<35} {:>10.0}\n", self.since_s, self.name, self.for_s)
    }
}

/// Actors that went less far than a distance, centimetres, for a time, seconds, or more: those of the longest time first.
///
/// # Errors
/// When it cannot be read.
pub fn blocked_actors<R: Read + Seek>(
    log: &mut LogReader<R>,
    least_s: f64,
    least_cm: f64,
) -> Result<String, RecordingError> {
    let mut text = header_text(log.header());
    let _ = writeln!(text, "{:>8} {:>6} {:<35} {:>10}", "Time", "Id", "Actor", "Duration");
    let mut frame = FrameStart::default();
    let mut actors: BTreeMap<u32, Waiting> = BTreeMap::new();
    let mut found: Vec<(f64, String)> = Vec::new();
    while let Some(packet) = log.packet()? {
        match packet {
            Packet::FrameStart(start) => frame = start,
            Packet::Created(created) => {
                for actor in created {
                    actors.insert(actor.id, Waiting { name: actor.blueprint, ..Waiting::default() });
                }
            }
            Packet::Positions(positions) => {
                for position in positions {
                    let waiting = actors.entry(position.actor).or_default();
                    if distance(waiting.place, position.location) < least_cm {
                        if waiting.for_s == 0.0 {
                            waiting.since_s = frame.elapsed_s;
                        }
                        waiting.for_s += frame.duration_s;
                        continue;
                    }
                    if waiting.for_s >= least_s {
                        found.push((waiting.for_s, waiting.line(position.actor)));
                    }
                    waiting.for_s = 0.0;
                    waiting.place = position.location;
                }
            }
            _ => {}
        }
    }
    let still = actors.iter().filter(|(_, waiting)| waiting.for_s >= least_s);
    found.extend(still.map(|(id, waiting)| (waiting.for_s, waiting.line(*id))));
    found.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    text.extend(found.into_iter().map(|(_, line)| line));
    let _ = write!(text, "\nFrames: {}\nDuration: {:.0} seconds\n", frame.id, frame.elapsed_s);
    Ok(text)
}

fn distance(a: [f32; 3], b: [f32; 3]) -> f64 {
    let squared = |(a, b): (&f32, &f32)| (f64::from(*a) - f64::from(*b)).powi(2);
    a.iter().zip(&b).map(squared).sum::<f64>().sqrt()
}
