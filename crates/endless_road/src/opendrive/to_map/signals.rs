//! Signals: which lanes they are for, and the programs of traffic lights.
//!
//! Exporters differ in where they put a signal that governs a junction: on the road before it, or on the connecting
//! roads inside it, with the lanes it is valid for. Both are understood. Signals switched by the same controllers
//! form a group. Files say which signals change together but not when, so that programs are made here: approaches
//! that face one another are green together, and people cross while nobody drives straight over their crossing.

use super::super::document::{ContactPoint, SignalOrientation};
use super::lanes::LaneGraph;
use super::sampled::{LaneKey, SampledDocument};
use super::signal_meaning::{SignalMeaning, meaning};
use super::signal_program::add_program;
use crate::{ImportNote, JunctionId, LaneId, RoadNetwork, TrafficControl};
use endless_world::SignalId;
use std::collections::{BTreeMap, BTreeSet};

/// A signal on a road without junction counts for the road's end within this distance, metres.
const REACH_M: f64 = 60.0;

/// The lanes whose ends a signal governs, by the signal's id.
pub(super) type SignalLanes<'a> = BTreeMap<&'a str, BTreeSet<LaneId>>;

/// What the lanes obey: every signal of the document with its lanes.
pub(super) fn governed<'a>(
    sampled: &SampledDocument<'a>,
    graph: &LaneGraph,
    notes: &mut Vec<ImportNote>,
) -> SignalLanes<'a> {
    let mut governed = SignalLanes::new();
    for (place, road) in sampled.document.roads.iter().enumerate() {
        let here = road.signals.iter().map(|s| (s.id.as_str(), s.s, s.orientation, &s.validity));
        let there = road.signal_references.iter().map(|r| (r.id.as_str(), r.s, r.orientation, &r.validity));
        for (id, s, orientation, validity) in here.chain(there) {
            let lanes = lanes_of(sampled, graph, (place, s), orientation, validity);
            governed.entry(id).or_default().extend(lanes);
        }
    }
    let known: BTreeSet<&str> =
        sampled.document.roads.iter().flat_map(|road| &road.signals).map(|signal| signal.id.as_str()).collect();
    for id in governed.keys().filter(|id| !known.contains(*id)) {
        let text = format!("signal {id} is referred to but does not exist");
        notes.push(ImportNote { place: "signalReference".to_owned(), text });
    }
    governed
}

fn lanes_of(
    sampled: &SampledDocument<'_>,
    graph: &LaneGraph,
    (road, s): (usize, f64),
    orientation: SignalOrientation,
    validity: &[(i32, i32)],
) -> BTreeSet<LaneId> {
    let record = &sampled.document.roads[road];
    let section = record.sections.partition_point(|section| section.s <= s).max(1) - 1;
    let mut lanes = BTreeSet::new();
    for lane in &record.sections[section].lanes {
        let key = LaneKey { road, section, lane: lane.id };
        let Some(node) = graph.owner.get(&key).copied() else { continue };
        let along = sampled.runs_along(key);
        // Where lanes are listed they decide: exporters do not agree on the orientation.
        let valid = if validity.is_empty() {
            match orientation {
                SignalOrientation::Along => along,
                SignalOrientation::Against => !along,
                SignalOrientation::Both => true,
            }
        } else {
            validity.iter().any(|&(from, to)| from <= lane.id && lane.id <= to)
        };
        if !valid {
            continue;
        }
        if record.junction.is_some() {
            lanes.extend(graph.approaches(node));
        } else {
            let end = if along { ContactPoint::End } else { ContactPoint::Start };
            let rest = if end == ContactPoint::End { record.length - s } else { s };
            // The last lane of this road in the direction of travel is the one that ends at the junction.
            if rest < REACH_M {
                lanes.extend(graph.last_on_road(node, road));
            }
        }
    }
    lanes
}

/// Sets what governs lane ends, numbers the groups and writes the programs. Returns each signal's group.
pub(super) fn apply<'a>(
    sampled: &SampledDocument<'a>,
    governed: &SignalLanes<'a>,
    network: &mut RoadNetwork,
    notes: &mut Vec<ImportNote>,
) -> BTreeMap<&'a str, SignalId> {
    let mut lights: BTreeMap<LaneId, BTreeSet<&str>> = BTreeMap::new();
    for signal in sampled.document.roads.iter().flat_map(|road| &road.signals) {
        let Some(lanes) = governed.get(signal.id.as_str()) else { continue };
        for &lane in lanes {
            let control = &mut network.lanes[lane.index()].end_control;
            match meaning(signal) {
                SignalMeaning::Light => {
                    lights.entry(lane).or_default().insert(signal.id.as_str());
                }
                SignalMeaning::Stop => *control = TrafficControl::Stop,
                SignalMeaning::Yield if *control == TrafficControl::Free => *control = TrafficControl::Yield,
                _ => {}
            }
        }
    }
    let mut controllers: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for controller in &sampled.document.controllers {
        for signal in &controller.signals {
            controllers.entry(signal).or_default().insert(&controller.id);
        }
    }
    // Groups: lanes before one junction whose lights have the same controllers, or else the same lights.
    let mut groups: BTreeMap<(JunctionId, BTreeSet<String>), Vec<LaneId>> = BTreeMap::new();
    let mut aimless = 0;
    for (&lane, signals) in &lights {
        let mut next = network.lane(lane).successors.iter().filter_map(|next| network.lane(*next).junction);
        let Some(junction) = next.next() else {
            aimless += 1;
            continue;
        };
        let key = signals.iter().flat_map(|signal| match controllers.get(signal) {
            Some(ids) => ids.iter().map(|id| format!("controller {id}")).collect(),
            None => vec![format!("signal {signal}")],
        });
        groups.entry((junction, key.collect())).or_default().push(lane);
    }
    if aimless > 0 {
        let text = format!("traffic lights at the ends of {aimless} lanes that lead to no junction are not switched");
        notes.push(ImportNote { place: "signals".to_owned(), text });
    }
    let mut ids = BTreeMap::new();
    let mut by_junction: BTreeMap<JunctionId, Vec<(SignalId, Vec<LaneId>)>> = BTreeMap::new();
    for ((junction, _), lanes) in groups {
        // A map with more groups than ids has signals that nobody sees anyway.
        let Some(next) = network.signal_groups.checked_add(1) else { break };
        let id = SignalId(network.signal_groups);
        network.signal_groups = next;
        for &lane in &lanes {
            network.lanes[lane.index()].end_control = TrafficControl::Signal(id);
            for signal in &lights[&lane] {
                ids.entry(*signal).or_insert(id);
            }
        }
        by_junction.entry(junction).or_default().push((id, lanes));
    }
    for (junction, groups) in by_junction {
        add_program(network, junction, &groups);
    }
    ids
}

/// Roads of lower priority inside junctions: who comes in on them gives way, where no sign or light says otherwise.
pub(super) fn apply_priorities(sampled: &SampledDocument<'_>, graph: &LaneGraph, network: &mut RoadNetwork) {
    for junction in &sampled.document.junctions {
        let roads = |pick: fn(&(String, String)) -> &String| -> BTreeSet<usize> {
            junction.priorities.iter().filter_map(|pair| sampled.road(pick(pair))).collect()
        };
        let (high, low) = (roads(|pair| &pair.0), roads(|pair| &pair.1));
        for &road in low.difference(&high) {
            for (key, &node) in graph.owner.range(LaneKey::all_of(road)) {
                debug_assert_eq!(key.road, road);
                for lane in graph.approaches(node) {
                    let control = &mut network.lanes[lane.index()].end_control;
                    if *control == TrafficControl::Free {
                        *control = TrafficControl::Yield;
                    }
                }
            }
        }
    }
}
