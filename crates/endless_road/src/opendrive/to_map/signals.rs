//! Signals: which lanes they are for, and the programs of traffic lights.
//!
//! Exporters differ in where they put a signal that governs a junction: on the road before it, or on the connecting
//! roads inside it, with the lanes it is valid for. Both are understood. Signals switched by the same controllers
//! form a group. Files say which signals change together but not when, so that programs are made here: approaches
//! that face one another are green together, and people cross while nobody drives straight over their crossing.

use super::super::document::{ContactPoint, Signal, SignalOrientation};
use super::lanes::LaneGraph;
use super::sampled::{LaneKey, SampledDocument};
use crate::{Crossing, ImportNote, JunctionId, LaneId, RoadNetwork, SignalPhase, SignalProgram, TrafficControl, Turn};
use endless_world::math::f64::wrap_angle;
use endless_world::{SignalAspect, SignalId};
use std::collections::{BTreeMap, BTreeSet};

/// A signal on a road without junction counts for the road's end within this distance, metres.
const REACH_M: f64 = 60.0;
/// A crossing this near to the end of an approach belongs to its junction, metres.
const NEAR_CROSSING_M: f64 = 25.0;
const GREEN_S: f64 = 16.0;
const YELLOW_S: f64 = 3.0;
const ALL_RED_S: f64 = 2.0;
const WALK_S: f64 = 7.0;
/// The speed for which people's clearance is reckoned, m/s.
const CLEARANCE_MPS: f64 = 1.25;

/// What a signal tells drivers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SignalMeaning {
    Light,
    WalkLight,
    Stop,
    Yield,
    /// km/h.
    SpeedLimit(u16),
    Other,
}

/// By the codes of OpenDRIVE itself, Germany and the United States, which others follow, and by name.
pub(super) fn meaning(signal: &Signal) -> SignalMeaning {
    let name = signal.name.to_ascii_lowercase();
    match signal.kind.as_str() {
        "1000002" | "1000003" => SignalMeaning::WalkLight,
        "206" | "R1-1" | "R1" => SignalMeaning::Stop,
        "205" | "R1-2" | "R2" => SignalMeaning::Yield,
        "274" | "R2-1" | "maximum" => {
            let stated = signal.value.or_else(|| signal.subtype.parse().ok()).or_else(|| digits(&signal.text));
            let factor = if signal.unit == "mph" || signal.kind == "R2-1" { 1.609 } else { 1.0 };
            stated.map_or(SignalMeaning::Other, |value| {
                SignalMeaning::SpeedLimit((value * factor).clamp(1.0, 250.0).round() as u16)
            })
        }
        kind if kind.starts_with("10000") && signal.dynamic => SignalMeaning::Light,
        "1000001" => SignalMeaning::Light,
        _ if name.contains("stop") && !signal.dynamic => SignalMeaning::Stop,
        _ if name.contains("yield") && !signal.dynamic => SignalMeaning::Yield,
        _ if signal.dynamic => SignalMeaning::Light,
        _ => SignalMeaning::Other,
    }
}

fn digits(text: &str) -> Option<f64> {
    let digits: String = text.chars().filter(char::is_ascii_digit).take(3).collect();
    digits.parse().ok()
}

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

/// Groups that are green together, as places in `groups`: approaches in line with one another.
fn stages(network: &RoadNetwork, groups: &[(SignalId, Vec<LaneId>)]) -> Vec<Vec<usize>> {
    let heading = |group: usize| {
        let lane = network.lane(groups[group].1[0]);
        lane.centerline.at(lane.centerline.length()).heading_rad
    };
    let mut stages: Vec<Vec<usize>> = Vec::new();
    for group in 0..groups.len() {
        let in_line = |other: &usize| {
            let angle = wrap_angle(heading(group) - heading(*other)).abs().to_degrees();
            !(40.0..=140.0).contains(&angle)
        };
        match stages.iter_mut().find(|stage| stage.iter().all(in_line)) {
            Some(stage) => stage.push(group),
            None => stages.push(vec![group]),
        }
    }
    stages
}

fn add_program(network: &mut RoadNetwork, junction: JunctionId, groups: &[(SignalId, Vec<LaneId>)]) {
    let mut stages = stages(network, groups);
    let crossings = crossings_of(network, junction, groups);
    // A stage without vehicles: for those who wait at signs where all lights are green together, and for people whose
    // crossing is driven over in every other.
    let driven_over = |met: &BTreeSet<usize>| stages.iter().all(|stage| stage.iter().any(|g| met.contains(g)));
    if stages.len() == 1 || crossings.iter().any(|(_, met)| driven_over(met)) {
        stages.push(Vec::new());
    }
    let mut walks: Vec<Vec<(SignalId, f64)>> = vec![Vec::new(); stages.len()];
    for (crossing, met) in crossings {
        let free: Vec<usize> = (0..stages.len()).filter(|&s| !stages[s].iter().any(|g| met.contains(g))).collect();
        let Some(next) = network.signal_groups.checked_add(1) else { continue };
        let id = SignalId(network.signal_groups);
        network.signal_groups = next;
        network.crossings[crossing].signal = Some(id);
        let [a, b] = network.crossings[crossing].ends;
        for stage in free {
            walks[stage].push((id, a.distance(b)));
        }
    }
    let all_walks: BTreeSet<SignalId> = walks.iter().flatten().map(|walk| walk.0).collect();
    let mut phases = Vec::new();
    for (stage, walk) in stages.iter().zip(&walks) {
        let clearance = walk.iter().map(|w| (w.1 / CLEARANCE_MPS).ceil()).fold(0.0, f64::max);
        let green = GREEN_S.max(WALK_S + clearance);
        let phase = |duration_s: f64, vehicles: SignalAspect, people: SignalAspect| SignalPhase {
            duration_s,
            aspects: (0..groups.len())
                .map(|g| (groups[g].0, if stage.contains(&g) { vehicles } else { SignalAspect::Red }))
                .chain(
                    all_walks
                        .iter()
                        .map(|&id| (id, if walk.iter().any(|w| w.0 == id) { people } else { SignalAspect::Red })),
                )
                .collect(),
        };
        phases.push(phase(green - clearance, SignalAspect::Green, SignalAspect::Green));
        if clearance > 0.0 {
            phases.push(phase(clearance, SignalAspect::Green, SignalAspect::Yellow));
        }
        phases.push(phase(YELLOW_S, SignalAspect::Yellow, SignalAspect::Red));
        phases.push(phase(ALL_RED_S, SignalAspect::Red, SignalAspect::Red));
    }
    let cycle: f64 = phases.iter().map(|phase| phase.duration_s).sum();
    // Junctions are not all at the same point of their cycle.
    let offset_s = (f64::from(junction.0) * 0.618 * cycle % cycle).floor();
    network.junctions[junction.index()].program = Some(SignalProgram { phases, offset_s });
}

/// The crossings at a junction, and which groups drive straight over each.
fn crossings_of(
    network: &RoadNetwork,
    junction: JunctionId,
    groups: &[(SignalId, Vec<LaneId>)],
) -> Vec<(usize, BTreeSet<usize>)> {
    let mut found = Vec::new();
    for (place, crossing) in network.crossings.iter().enumerate() {
        if crossing.signal.is_some() {
            continue;
        }
        let mut met = BTreeSet::new();
        let mut here = false;
        for (g, (_, lanes)) in groups.iter().enumerate() {
            for &approach in lanes {
                let lane = network.lane(approach);
                let near = |range: (f64, f64)| lane.centerline.length() - range.1 < NEAR_CROSSING_M;
                let over_approach = cuts(crossing, network, approach).is_some_and(near);
                let over_way = |id: &LaneId, straight: bool| {
                    let way = network.lane(*id);
                    (!straight || way.turn == Turn::Straight) && cuts(crossing, network, *id).is_some()
                };
                here |= over_approach || lane.successors.iter().any(|id| over_way(id, false));
                if over_approach || lane.successors.iter().any(|id| over_way(id, true)) {
                    met.insert(g);
                }
            }
        }
        let inside = network.junctions[junction.index()].lanes.iter();
        if here || inside.clone().any(|id| cuts(crossing, network, *id).is_some()) {
            found.push((place, met));
        }
    }
    found
}

fn cuts(crossing: &Crossing, network: &RoadNetwork, lane: LaneId) -> Option<(f64, f64)> {
    crate::cut::cut_range(crossing, network.lane(lane))
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
