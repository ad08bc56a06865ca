//! `actors.json`: what stays the same of each object of a video, one entry a line.

use crate::{DatasetError, read_json, write_atomic};
use endless_annotate::ActorRecord;
use std::path::Path;

/// Writes the entries, which are sorted by id.
///
/// # Errors
/// When the disk refuses.
pub fn write_actors(path: &Path, actors: &[ActorRecord]) -> Result<(), DatasetError> {
    let entry = |actor| serde_json::to_string(actor).expect("plain numbers and words");
    let lines: Vec<String> = actors.iter().map(entry).collect();
    write_atomic(path, format!("[\n{}\n]\n", lines.join(",\n")).as_bytes())
}

/// Reads them.
///
/// # Errors
/// When the file is missing or not what it should be.
pub fn read_actors(path: &Path) -> Result<Vec<ActorRecord>, DatasetError> {
    read_json(path)
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{InstanceId, ObjectClass, Reid};

    #[test]
    fn what_is_written_is_read_one_entry_a_line() {
        let folder = tempfile::tempdir().expect("temp");
        let path = folder.path().join("actors.json");
        let van = ActorRecord::new(InstanceId(1), ObjectClass::Van, true);
        let rider = ActorRecord {
            reid: Some(Reid::new("rider", &[1])),
            vehicle_id: Some(InstanceId(2)),
            ..ActorRecord::new(InstanceId(3), ObjectClass::Rider, false)
        };
        for actors in [vec![], vec![van.clone()], vec![van, rider]] {
            write_actors(&path, &actors).expect("room");
            assert_eq!(read_actors(&path).expect("own output"), actors);
            let lines = std::fs::read_to_string(&path).expect("text").lines().count();
            assert_eq!(lines, 2 + actors.len().max(1));
        }
    }
}
