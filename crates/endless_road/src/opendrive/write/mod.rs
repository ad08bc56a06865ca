//! Writing OpenDRIVE 1.6: lanes side by side become roads, ways through junctions connecting roads.
//!
//! Every road runs in the direction of its traffic and has lanes on one side only: opposite carriageways are roads of
//! their own, and so are sidewalks. Lane centre lines come back as they were, to a centimetre. What the format has no place for is not
//! written: the times of signal programs.

mod curve;
mod element;
mod junction;
mod plan;
mod road;
mod sidewalk;

use crate::RoadMap;
use element::{ElementWriter, number};
use plan::WritePlan;

/// The text of an OpenDRIVE file with the map's lanes, junctions, signals and crossings.
pub fn write(map: &RoadMap, name: &str) -> String {
    let plan = WritePlan::new(&map.network, map.left_hand);
    let mut root = ElementWriter::new("OpenDRIVE");
    root.push(header(map, name));
    for road in 0..plan.roads.len() {
        root.push(road::road(&plan, road));
    }
    for sidewalk in sidewalk::roads(&map.network.walk, plan.roads.len() + 1) {
        root.push(sidewalk);
    }
    for controller in junction::controllers(&plan) {
        root.push(controller);
    }
    for junction in junction::junctions(&plan) {
        root.push(junction);
    }
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    root.write(0, &mut text);
    text
}

fn header(map: &RoadMap, name: &str) -> ElementWriter {
    let points = || map.network.lanes.iter().flat_map(|lane| lane.centerline.points());
    let range = |of: fn(&glam::DVec3) -> f64| {
        points().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
    };
    let ((west, east), (south, north)) = (range(|p| p.x), range(|p| p.y));
    let mut header = ElementWriter::new("header")
        .with("revMajor", "1")
        .with("revMinor", "6")
        .with("name", name)
        .with("version", "1.00")
        .with("vendor", "ENDLESS");
    if west <= east {
        for (side, value) in [("north", north), ("south", south), ("east", east), ("west", west)] {
            header = header.with(side, number(value));
        }
    }
    if let Some(reference) = &map.georeference {
        header.push(ElementWriter::new("geoReference").text(reference));
    }
    header.push(ElementWriter::new("userData").with("code", "laneEnds").with("value", "stop"));
    header
}
