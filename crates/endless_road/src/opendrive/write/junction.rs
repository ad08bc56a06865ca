//! Junctions and controllers.

use super::element::ElementWriter;
use super::plan::WritePlan;
use super::road::{junction_id, light_id};
use crate::{LaneId, TrafficControl};
use endless_world::SignalId;
use std::collections::{BTreeMap, BTreeSet};

/// The signals of each group, by the roads at whose ends they stand.
fn lights(plan: &WritePlan<'_>) -> BTreeMap<SignalId, BTreeSet<usize>> {
    let mut lights: BTreeMap<SignalId, BTreeSet<usize>> = BTreeMap::new();
    for lane in &plan.network.lanes {
        if let TrafficControl::Signal(group) = lane.end_control {
            lights.entry(group).or_default().insert(plan.road_of[lane.id.index()]);
        }
    }
    lights
}

pub(super) fn controllers(plan: &WritePlan<'_>) -> Vec<ElementWriter> {
    let controller = |(group, roads): (SignalId, BTreeSet<usize>)| {
        let controls = roads
            .into_iter()
            .map(|road| ElementWriter::new("control").with("signalId", light_id(group, road)).with("type", "0"));
        ElementWriter::new("controller")
            .with("id", group.0)
            .with("name", format!("group {}", group.0))
            .with("sequence", "0")
            .holding(controls)
    };
    lights(plan).into_iter().map(controller).collect()
}

pub(super) fn junctions(plan: &WritePlan<'_>) -> Vec<ElementWriter> {
    let mut all = Vec::new();
    for (place, junction) in plan.network.junctions.iter().enumerate() {
        let entries = plan.entries(junction);
        let mut element = junction_element(place, "default");
        for child in connections(plan, &entries, "connectingRoad") {
            element.push(child);
        }
        let groups: BTreeSet<SignalId> = entries
            .iter()
            .filter_map(|&(lane, _)| match plan.network.lane(lane).end_control {
                TrafficControl::Signal(group) => Some(group),
                _ => None,
            })
            .collect();
        for group in groups {
            element.push(ElementWriter::new("controller").with("id", group.0).with("type", "0"));
        }
        all.push(element);
    }
    for (k, roads) in plan.direct.iter().enumerate() {
        let lanes = roads.iter().flat_map(|&road| &plan.roads[road].lanes);
        let entries: Vec<(LaneId, LaneId)> = lanes
            .flat_map(|&lane| plan.network.lane(lane).successors.iter().map(move |&next| (lane, next)))
            .filter(|&(_, next)| plan.network.lane(next).junction.is_none())
            .collect();
        all.push(junction_element(plan.network.junctions.len() + k, "direct").holding(connections(
            plan,
            &entries,
            "linkedRoad",
        )));
    }
    all
}

fn junction_element(place: usize, kind: &str) -> ElementWriter {
    ElementWriter::new("junction").with("id", junction_id(place)).with("name", "").with("type", kind)
}

/// One connection for each pair of roads.
fn connections(plan: &WritePlan<'_>, entries: &[(LaneId, LaneId)], connecting: &'static str) -> Vec<ElementWriter> {
    type Pairs = BTreeMap<(usize, usize), Vec<(LaneId, LaneId)>>;
    let mut pairs = Pairs::new();
    for &(from, to) in entries {
        pairs.entry((plan.road_of[from.index()], plan.road_of[to.index()])).or_default().push((from, to));
    }
    let connection = |i: usize, (from, to): (usize, usize), lanes: Vec<(LaneId, LaneId)>| {
        let links = lanes
            .into_iter()
            .map(|(a, b)| ElementWriter::new("laneLink").with("from", plan.lane_id(a)).with("to", plan.lane_id(b)));
        ElementWriter::new("connection")
            .with("id", i)
            .with("incomingRoad", from + 1)
            .with(connecting, to + 1)
            .with("contactPoint", "start")
            .holding(links)
    };
    pairs.into_iter().enumerate().map(|(i, (roads, lanes))| connection(i, roads, lanes)).collect()
}
