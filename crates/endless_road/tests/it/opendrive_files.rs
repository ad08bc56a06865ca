//! Real files, where they are at hand.
#![expect(clippy::print_stdout, clippy::unwrap_used, reason = "tests")]

use endless_road::opendrive;
use std::path::PathBuf;

fn files() -> Vec<(String, String)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/opendrive");
    let Ok(entries) = std::fs::read_dir(&folder) else {
        println!("skipped: {} is not there", folder.display());
        return Vec::new();
    };
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "xodr"));
    paths.sort();
    let name = |path: &PathBuf| path.file_stem().unwrap().to_string_lossy().into_owned();
    paths.iter().map(|path| (name(path), std::fs::read_to_string(path).unwrap())).collect()
}

#[test]
fn every_file_is_read() {
    for (name, text) in files() {
        let start = std::time::Instant::now();
        let map = opendrive::read(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        let network = &map.network;
        let metres: f64 = network.lanes.iter().map(|l| l.centerline.length()).sum();
        println!(
            "{name}: {} lanes ({} without successor), {metres:.0} m, {} junctions, {} signals, {} crossings, {} walk \
             edges, {} strips, {} marks, {} things, {} notes, {:?}",
            network.lanes.len(),
            network.lanes.iter().filter(|l| l.successors.is_empty()).count(),
            network.junctions.len(),
            network.signal_groups,
            network.crossings.len(),
            network.walk.edges.len(),
            map.lane_surfaces.len(),
            map.markings.len(),
            map.objects.len(),
            map.notes.len(),
            start.elapsed()
        );
        for note in map.notes.iter().take(30) {
            println!("    {}: {}", note.place, note.text);
        }
    }
}
