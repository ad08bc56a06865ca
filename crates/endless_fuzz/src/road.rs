//! Maps: a road network in which everything lies somewhere, or an error that says where.

use crate::target::FuzzTarget;
use crate::{mutate, pbf};
use endless_road::opendrive::{self, OpenDriveError};
use endless_road::osm::{self, OsmError, OsmOptions};
use endless_road::{RoadMap, RoadNetwork};

/// OpenDRIVE: what can be read can be written, and read again.
pub const OPENDRIVE: FuzzTarget = FuzzTarget { name: "opendrive", judge: opendrive_file, mutate: mutate::text };
/// OpenStreetMap as XML.
pub const OSM: FuzzTarget = FuzzTarget { name: "osm", judge: osm_file, mutate: mutate::text };
/// OpenStreetMap's `.osm.pbf`.
pub const PBF: FuzzTarget = FuzzTarget { name: "pbf", judge: osm_file, mutate: pbf::changed };

fn opendrive_file(bytes: &[u8]) -> Result<(), String> {
    let Ok(text) = std::str::from_utf8(bytes) else { return Ok(()) };
    let map = match opendrive::read(text) {
        Ok(map) => map,
        Err(OpenDriveError::Network(error)) => return Err(format!("the network made of it is wrong: {error}")),
        Err(error) => return told(&error.to_string()),
    };
    sound(&map)?;
    // What can be read can be written, and that can be read.
    let again = opendrive::read(&opendrive::write(&map, "again")).map_err(|error| format!("as written: {error}"))?;
    sound(&again)
}

fn osm_file(bytes: &[u8]) -> Result<(), String> {
    match osm::read(bytes, &OsmOptions::default()) {
        Ok(map) => sound(&map),
        Err(OsmError::Network(error)) => Err(format!("the network made of it is wrong: {error}")),
        Err(error) => told(&error.to_string()),
    }
}

/// Errors are one line and say where, or of what there is too much or too little.
fn told(error: &str) -> Result<(), String> {
    let places = ["line ", "byte ", "node ", "the file has ", "no road ", "too large", "neither"];
    if error.contains('\n') || !places.iter().any(|place| error.contains(place)) {
        return Err(format!("an error that does not say where: {error:?}"));
    }
    Ok(())
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
