//! Roads with their lanes, signals and crossings.

use super::curve::FittedLine;
use super::element::{ElementWriter, number};
use super::plan::{RoadEndLink, WritePlan};
use crate::{Crossing, Lane, LaneId, TrafficControl};
use endless_world::SignalId;
use endless_world::math::f64::{atan2, sin_cos};
use glam::DVec2;
use std::collections::BTreeMap;

/// Signals stand this far from the edge of the road, metres.
const ASIDE_M: f64 = 0.8;

pub(super) fn road(plan: &WritePlan<'_>, place: usize) -> ElementWriter {
    let planned = &plan.roads[place];
    let junction = planned.junction.map_or("-1".to_owned(), junction_id);
    ElementWriter::new("road")
        .with("name", "")
        .with("length", number(planned.line.length))
        .with("id", place + 1)
        .with("junction", junction)
        .with("rule", if plan.left_hand { "LHT" } else { "RHT" })
        .holding([
            link(plan, place),
            road_type(plan, place),
            plan_view(&planned.line),
            elevation(&planned.line),
            ElementWriter::new("lateralProfile"),
            lanes(plan, place),
            objects(plan, place),
            signals(plan, place),
        ])
}

/// Ids of junctions do not clash with those of roads: some readers keep both in one table.
pub(super) fn junction_id(place: usize) -> String {
    format!("{}", 100_000 + place)
}

fn link(plan: &WritePlan<'_>, place: usize) -> ElementWriter {
    let mut link = ElementWriter::new("link");
    for (name, at_end, contact) in [("predecessor", false, "end"), ("successor", true, "start")] {
        match plan.joined(place, at_end) {
            RoadEndLink::Nothing => {}
            RoadEndLink::Road(other) => link.push(
                ElementWriter::new(name)
                    .with("elementType", "road")
                    .with("elementId", other + 1)
                    .with("contactPoint", contact),
            ),
            RoadEndLink::Junction(junction) => {
                link.push(
                    ElementWriter::new(name).with("elementType", "junction").with("elementId", junction_id(junction)),
                );
            }
        }
    }
    link
}

fn road_type(plan: &WritePlan<'_>, place: usize) -> ElementWriter {
    let fastest =
        plan.roads[place].lanes.iter().map(|&lane| plan.network.lane(lane).speed_limit_mps).fold(0.0, f64::max);
    let kind = if fastest > 23.0 { "motorway" } else { "town" };
    ElementWriter::new("type")
        .with("s", "0")
        .with("type", kind)
        .holding([ElementWriter::new("speed").with("max", number(fastest)).with("unit", "m/s")])
}

pub(super) fn plan_view(line: &FittedLine) -> ElementWriter {
    let pieces = line.pieces.iter().map(|piece| {
        let shape = match piece.cubic {
            None => ElementWriter::new("line"),
            Some([u, v]) => {
                let [a_u, b_u, c_u, d_u] = u.map(number);
                let [a_v, b_v, c_v, d_v] = v.map(number);
                ElementWriter::new("paramPoly3")
                    .with("aU", a_u)
                    .with("bU", b_u)
                    .with("cU", c_u)
                    .with("dU", d_u)
                    .with("aV", a_v)
                    .with("bV", b_v)
                    .with("cV", c_v)
                    .with("dV", d_v)
                    .with("pRange", "normalized")
            }
        };
        ElementWriter::new("geometry")
            .with("s", number(piece.s))
            .with("x", number(piece.start.x))
            .with("y", number(piece.start.y))
            .with("hdg", number(piece.heading))
            .with("length", number(piece.length))
            .holding([shape])
    });
    ElementWriter::new("planView").holding(pieces)
}

pub(super) fn elevation(line: &FittedLine) -> ElementWriter {
    let heights = &line.heights;
    let mut records = Vec::new();
    let mut last_slope = f64::NAN;
    for pair in heights.windows(2) {
        let slope = (pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0);
        // One record for as long as the slope stays the same.
        if (slope - last_slope).abs() < 1e-9 {
            continue;
        }
        last_slope = slope;
        records.push(
            ElementWriter::new("elevation").with("s", number(pair[0].0)).with_cubic([pair[0].1, slope, 0.0, 0.0]),
        );
    }
    ElementWriter::new("elevationProfile").holding(records)
}

fn lanes(plan: &WritePlan<'_>, place: usize) -> ElementWriter {
    let planned = &plan.roads[place];
    let offset = ElementWriter::new("laneOffset").with("s", "0").with_cubic([planned.lane_offset, 0.0, 0.0, 0.0]);
    let centre = ElementWriter::new("lane")
        .with("id", "0")
        .with("type", "none")
        .with("level", "false")
        .holding([mark(if planned.junction.is_some() { "none" } else { "solid" }, "none")]);
    let all: Vec<ElementWriter> =
        planned.lanes.iter().map(|&lane| lane_element(plan, plan.network.lane(lane))).collect();
    let center = ElementWriter::new("center").holding([centre]);
    let sides = if plan.left_hand {
        [ElementWriter::new("left").holding(all), center]
    } else {
        [center, ElementWriter::new("right").holding(all)]
    };
    ElementWriter::new("lanes").holding([offset, ElementWriter::new("laneSection").with("s", "0").holding(sides)])
}

fn mark(kind: &str, change: &str) -> ElementWriter {
    ElementWriter::new("roadMark")
        .with("sOffset", "0")
        .with("type", kind)
        .with("weight", "standard")
        .with("color", "standard")
        .with("width", "0.12")
        .with("laneChange", change)
}

fn lane_element(plan: &WritePlan<'_>, lane: &Lane) -> ElementWriter {
    let place = plan.road_of[lane.id.index()];
    let mut link = ElementWriter::new("link");
    for (name, at_end) in [("predecessor", false), ("successor", true)] {
        if let RoadEndLink::Road(other) = plan.joined(place, at_end) {
            let linked = if at_end { &lane.successors } else { &lane.predecessors };
            for &next in linked.iter().filter(|next| plan.road_of[next.index()] == other) {
                link.push(ElementWriter::new(name).with("id", plan.lane_id(next)));
            }
        }
    }
    let width = ElementWriter::new("width").with("sOffset", "0").with_cubic([lane.width_m, 0.0, 0.0, 0.0]);
    let speed =
        ElementWriter::new("speed").with("sOffset", "0").with("max", number(lane.speed_limit_mps)).with("unit", "m/s");
    ElementWriter::new("lane")
        .with("id", plan.lane_id(lane.id))
        .with("type", "driving")
        .with("level", "false")
        .holding([link, width, outer_mark(plan, lane), speed])
}

/// The mark at the edge away from the centre: to the right, or in left-hand traffic to the left.
fn outer_mark(plan: &WritePlan<'_>, lane: &Lane) -> ElementWriter {
    if lane.junction.is_some() {
        return mark("none", "none");
    }
    let road = plan.road_of[lane.id.index()];
    let outer = if plan.left_hand { lane.left } else { lane.right };
    let Some(outer) = outer.filter(|other| plan.road_of[other.index()] == road) else { return mark("solid", "none") };
    let back = plan.network.lane(outer);
    let back = if plan.left_hand { back.right } else { back.left };
    // Outwards ids grow in left-hand and fall in right-hand traffic.
    let change = match (back == Some(lane.id), plan.left_hand) {
        (true, _) => "both",
        (false, true) => "increase",
        (false, false) => "decrease",
    };
    mark("broken", change)
}

fn objects(plan: &WritePlan<'_>, place: usize) -> ElementWriter {
    let mut objects = ElementWriter::new("objects");
    for (number, crossing) in plan.network.crossings.iter().enumerate() {
        // CARLA counts the `t` of objects from the lane offset, the standard from the reference line.
        let roads = || crossing.cuts.iter().map(|cut| plan.road_of[cut.lane.index()]);
        let home = roads().find(|&road| plan.roads[road].lane_offset == 0.0).or_else(|| roads().next());
        if home == Some(place) {
            objects.push(crosswalk(plan, place, crossing, number));
        }
    }
    objects
}

/// A crosswalk by its corners, in the plane of the road.
fn crosswalk(plan: &WritePlan<'_>, place: usize, crossing: &Crossing, id: usize) -> ElementWriter {
    let [a, b] = crossing.ends;
    let origin = plan.roads[place].line.nearest(a.midpoint(b).truncate());
    let (sin, cos) = sin_cos(origin.heading);
    let along = DVec2::new(cos, sin);
    let side = (b - a).truncate().perp().normalize_or_zero() * (0.5 * crossing.width_m);
    let corners = [(a, side), (a, -side), (b, -side), (b, side)].map(|(end, side)| {
        let from_origin = end.truncate() + side - origin.place.truncate();
        let u = from_origin.dot(along);
        let height = end.z + origin.grade * side.dot(along) - origin.place.z;
        [u, from_origin.dot(along.perp()), height - origin.grade * u]
    });
    let corner = |[u, v, z]: [f64; 3]| {
        ElementWriter::new("cornerLocal")
            .with("u", number(u))
            .with("v", number(v))
            .with("z", number(z))
            .with("height", "0")
    };
    let outline = || ElementWriter::new("outline").with("id", "0").with("closed", "true");
    let extent = |axis: usize| 2.0 * corners.iter().map(|corner| corner[axis].abs()).fold(0.0, f64::max);
    ElementWriter::new("object")
        .with("id", id + 1)
        .with("name", "crosswalk")
        .with("type", "crosswalk")
        .with("s", number(origin.s))
        .with("t", "0")
        .with("zOffset", "0")
        .with("hdg", "0")
        // Nose down is positive.
        .with("pitch", number(-atan2(origin.grade, 1.0)))
        .with("roll", "0")
        .with("orientation", "none")
        .with("length", number(extent(0)))
        .with("width", number(extent(1)))
        .with("height", "0")
        .holding([
            // As version 1.4 has it, which CARLA reads, with the first corner again at the end.
            outline().holding(corners.into_iter().chain([corners[0]]).map(corner)),
            ElementWriter::new("outlines").holding([outline().holding(corners.map(corner))]),
        ])
}

/// The id of the signal of a group that stands at a road.
pub(super) fn light_id(group: SignalId, place: usize) -> String {
    format!("{}_{}", group.0, place + 1)
}

fn signals(plan: &WritePlan<'_>, place: usize) -> ElementWriter {
    let planned = &plan.roads[place];
    let mut by_control: BTreeMap<String, (TrafficControl, Vec<LaneId>)> = BTreeMap::new();
    for &lane in &planned.lanes {
        let control = plan.network.lane(lane).end_control;
        let id = match control {
            TrafficControl::Free => continue,
            TrafficControl::Signal(group) => light_id(group, place),
            TrafficControl::Stop => format!("stop_{}", place + 1),
            TrafficControl::Yield => format!("yield_{}", place + 1),
        };
        by_control.entry(id).or_insert((control, Vec::new())).1.push(lane);
    }
    let signals = by_control.into_iter().map(|(id, (control, lanes))| {
        let (dynamic, country, kind, name) = match control {
            TrafficControl::Signal(_) => ("yes", "OpenDRIVE", "1000001", "traffic light"),
            TrafficControl::Stop => ("no", "DE", "206", "stop"),
            _ => ("no", "DE", "205", "give way"),
        };
        let validity = lanes.iter().map(|&lane| {
            let id = plan.lane_id(lane);
            ElementWriter::new("validity").with("fromLane", id).with("toLane", id)
        });
        ElementWriter::new("signal")
            .with("s", number((planned.line.length - 0.05).max(0.0)))
            .with("t", number(plan.right_edge(place) - ASIDE_M))
            .with("id", id)
            .with("name", name)
            .with("dynamic", dynamic)
            .with("orientation", "+")
            .with("zOffset", "0")
            .with("country", country)
            .with("type", kind)
            .with("subtype", "-1")
            .with("value", "-1")
            .with("hOffset", "0")
            .with("pitch", "0")
            .with("roll", "0")
            .with("height", "0.9")
            .with("width", "0.3")
            .holding(validity)
    });
    ElementWriter::new("signals").holding(signals)
}
