//! What is tried, and what counts as right.

use endless_road::opendrive::{self, OpenDriveError};
use endless_road::osm::{self, OsmError, OsmOptions};
use endless_road::{RoadMap, RoadNetwork};

/// A reader.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Target {
    OpenDrive,
    Osm,
    Pbf,
}

impl Target {
    pub(crate) const ALL: [Self; 3] = [Self::OpenDrive, Self::Osm, Self::Pbf];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::OpenDrive => "opendrive",
            Self::Osm => "osm",
            Self::Pbf => "pbf",
        }
    }

    /// Reads a file. Tells what kind of answer it was, in words that many files share; an error if the answer is
    /// wrong.
    pub(crate) fn run(self, bytes: &[u8]) -> Result<Vec<String>, String> {
        match self {
            Self::OpenDrive => opendrive_file(bytes),
            Self::Osm | Self::Pbf => osm_file(bytes),
        }
    }
}

fn opendrive_file(bytes: &[u8]) -> Result<Vec<String>, String> {
    let Ok(text) = std::str::from_utf8(bytes) else { return Ok(vec!["no text".to_owned()]) };
    let map = match opendrive::read(text) {
        Ok(map) => map,
        Err(OpenDriveError::Network(error)) => return Err(format!("the network made of it is wrong: {error}")),
        Err(error) => return told(&error.to_string()),
    };
    sound(&map)?;
    // What can be read can be written, and that can be read.
    let again = opendrive::read(&opendrive::write(&map, "again")).map_err(|error| format!("as written: {error}"))?;
    sound(&again)?;
    Ok(features(&map))
}

fn osm_file(bytes: &[u8]) -> Result<Vec<String>, String> {
    match osm::read(bytes, &OsmOptions::default()) {
        Ok(map) => {
            sound(&map)?;
            Ok(features(&map))
        }
        Err(OsmError::Network(error)) => Err(format!("the network made of it is wrong: {error}")),
        Err(error) => told(&error.to_string()),
    }
}

/// Errors are one line and say where, or of what there is too much or too little.
fn told(error: &str) -> Result<Vec<String>, String> {
    let places = ["line ", "byte ", "node ", "the file has ", "no road ", "too large", "neither"];
    if error.contains('\n') || !places.iter().any(|place| error.contains(place)) {
        return Err(format!("an error that does not say where: {error:?}"));
    }
    Ok(vec![plain(error)])
}

fn sound(map: &RoadMap) -> Result<(), String> {
    let RoadNetwork { lanes, walk, .. } = &map.network;
    let finite = |p: &glam::DVec3| p.is_finite();
    let all = lanes.iter().all(|lane| lane.centerline.points().iter().all(finite))
        && walk.nodes.iter().all(finite)
        && map.lane_surfaces.iter().all(|s| s.left.len() == s.right.len() && s.left.iter().chain(&s.right).all(finite))
        && map.markings.iter().all(|mark| mark.line.points().iter().all(finite))
        && map.junction_areas.iter().flatten().all(finite)
        && map.areas.iter().flat_map(|area| &area.outline).all(|p| p.is_finite())
        && map.footprints.iter().flat_map(|f| &f.outline).all(|p| p.is_finite())
        && map.objects.iter().all(|thing| thing.position.is_finite() && thing.heading_rad.is_finite());
    if all { Ok(()) } else { Err("a place that is no place".to_owned()) }
}

fn features(map: &RoadMap) -> Vec<String> {
    let mut found: Vec<String> = map.notes.iter().map(|note| plain(&note.text)).collect();
    let network = &map.network;
    let counts = [
        ("lanes", network.lanes.len()),
        ("junctions", network.junctions.len()),
        ("crossings", network.crossings.len()),
        ("walks", network.walk.edges.len()),
        ("signals", usize::from(network.signal_groups)),
        ("conflicts", network.junctions.iter().map(|j| j.conflicts.len()).sum()),
        ("changes", network.lanes.iter().filter(|lane| lane.left.is_some()).count()),
        ("spawns", network.spawn_points.len()),
        ("strips", map.lane_surfaces.len()),
        ("marks", map.markings.len()),
        ("things", map.objects.len()),
        ("areas", map.areas.len()),
        ("footprints", map.footprints.len()),
    ];
    found.extend(counts.map(|(what, n)| format!("{what} {}", n.checked_ilog2().map_or(0, |log| log + 1))));
    found
}

/// What a message begins with, without its numbers and what it quotes.
fn plain(text: &str) -> String {
    let ours = text.find(['"', '`', '<']).map_or(text, |at| &text[..at]);
    ours.chars().filter(|c| c.is_ascii_alphabetic() || *c == ' ').take(60).collect()
}
