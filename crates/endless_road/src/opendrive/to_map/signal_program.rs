//! Signal programs of junctions: stages of movements that do not conflict, and the crossings that are green with them.

use crate::yellow::yellow_s;
use crate::{Crossing, JunctionId, LaneId, RoadNetwork, SignalPhase, SignalProgram, Turn};
use endless_world::math::f64::wrap_angle;
use endless_world::{SignalAspect, SignalId};
use std::collections::BTreeSet;

/// A crossing this near to the end of an approach belongs to its junction, metres.
const NEAR_CROSSING_M: f64 = 25.0;
const GREEN_S: f64 = 16.0;
const ALL_RED_S: f64 = 2.0;
const WALK_S: f64 = 7.0;
/// The speed for which people's clearance is reckoned, m/s.
const CLEARANCE_MPS: f64 = 1.25;

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

pub(super) fn add_program(network: &mut RoadNetwork, junction: JunctionId, groups: &[(SignalId, Vec<LaneId>)]) {
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
        let limits = stage.iter().flat_map(|&g| &groups[g].1).map(|&lane| network.lane(lane).speed_limit_mps);
        let yellow = yellow_s(limits.fold(0.0, f64::max));
        phases.push(phase(yellow, SignalAspect::Yellow, SignalAspect::Red));
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
