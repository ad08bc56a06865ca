//! Files of recorded tracks: tracks in the order of time, or an error of one line.

use crate::mutate;
use crate::target::{FuzzTarget, one_line};
use endless_interchange::TrackFile;

/// SUMO's FCD as XML, and CSV.
pub const TRACKS: FuzzTarget = FuzzTarget { name: "tracks", judge: tracks, mutate: mutate::text };

fn tracks(bytes: &[u8]) -> Result<(), String> {
    let file = match TrackFile::from_bytes(bytes) {
        Ok(file) => file,
        Err(fault) => return one_line(&fault),
    };
    file.notes.iter().try_for_each(one_line)?;
    if file.tracks.is_empty() || file.begin_s > file.end_s {
        return Err(format!("{} tracks from {} s to {} s", file.tracks.len(), file.begin_s, file.end_s));
    }
    for track in &file.tracks {
        let samples: Vec<_> = track.pieces.iter().flatten().collect();
        let sound = samples.iter().all(|sample| {
            let numbers = [sample.time_s, sample.position.x, sample.position.y, sample.yaw_rad];
            numbers.iter().all(|number| number.is_finite())
        });
        let gone = track.pieces.is_empty() || track.pieces.iter().any(Vec::is_empty);
        if gone || !sound || !samples.is_sorted_by(|a, b| a.time_s < b.time_s) {
            return Err(format!("track '{}' is out of order: {track:?}", track.name));
        }
    }
    Ok(())
}
