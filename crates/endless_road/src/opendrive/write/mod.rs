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

use crate::{Lane, RoadMap, RoadNetwork};
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

/// A lane as an OpenDRIVE file names it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LaneName {
    /// Id of its road.
    pub road: u32,
    /// Its id on the road: below 0 on the right of the reference line, above 0 on the left.
    pub lane: i32,
}

/// What [`write()`] names the lanes of a network, by their index.
pub fn lane_names(network: &RoadNetwork, left_hand: bool) -> Vec<LaneName> {
    let plan = WritePlan::new(network, left_hand);
    let name = |lane: &Lane| LaneName { road: plan.road_id(lane.id), lane: plan.lane_id(lane.id) };
    network.lanes.iter().map(name).collect()
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
