//! The networks of all towns: no dead ends, everything reachable, signals complete.

use crate::towns;
use endless_road::{LaneId, RoadNetwork, TrafficControl};
use std::collections::BTreeMap;

fn networks() -> impl Iterator<Item = (&'static str, &'static RoadNetwork)> {
    towns().iter().map(|town| (&*town.name, &town.network))
}

fn reached_from(network: &RoadNetwork, start: usize) -> usize {
    let mut seen = vec![false; network.lanes.len()];
    let mut open = vec![start];
    while let Some(lane) = open.pop() {
        if std::mem::replace(&mut seen[lane], true) {
            continue;
        }
        let lane = &network.lanes[lane];
        open.extend(lane.successors.iter().chain(&lane.left).chain(&lane.right).map(|l| l.index()));
    }
    seen.into_iter().filter(|&s| s).count()
}

#[test]
fn traffic_never_ends_and_gets_everywhere() {
    for (name, network) in networks() {
        assert!(network.lanes.iter().all(|l| !l.successors.is_empty()), "{name}: a lane ends");
        for lane in &network.lanes {
            let reached = reached_from(network, lane.id.index());
            assert!(reached * 10 >= network.lanes.len() * 9, "{name}: {:?} reaches only {reached}", lane.id);
        }
    }
}

#[test]
fn lanes_join_end_to_end() {
    for (name, network) in networks() {
        for lane in &network.lanes {
            let end = lane.centerline.at(f64::INFINITY);
            for &next in &lane.successors {
                let start = network.lane(next).centerline.at(0.0);
                let gap = end.position.distance(start.position);
                let bend = endless_world::math::f64::wrap_angle(end.heading_rad - start.heading_rad);
                assert!(gap < 0.01 && bend.abs() < 0.1, "{name}: {:?} to {next:?}: {gap} m, {bend} rad", lane.id);
            }
            let points = lane.centerline.points();
            for three in points.windows(3) {
                let (u, v) = ((three[1] - three[0]).truncate(), (three[2] - three[1]).truncate());
                assert!(u.angle_to(v).abs() < 0.4, "{name}: {:?} has a kink at {:?}", lane.id, three[1]);
            }
        }
    }
}

#[test]
fn every_signal_is_shown_in_every_phase_and_turns_green() {
    use endless_world::SignalAspect::Green;
    for (name, network) in networks() {
        let mut green = vec![false; usize::from(network.signal_groups)];
        for program in network.junctions.iter().filter_map(|j| j.program.as_ref()) {
            for phase in &program.phases {
                assert_eq!(phase.aspects.len(), program.phases[0].aspects.len(), "{name}");
                assert!(phase.duration_s > 0.0);
                for &(id, aspect) in &phase.aspects {
                    green[usize::from(id.0)] |= aspect == Green;
                }
            }
        }
        for lane in &network.lanes {
            if let TrafficControl::Signal(id) = lane.end_control {
                assert!(green[usize::from(id.0)], "{name}: {id:?} never turns green");
            }
        }
        let walks = network.crossings.iter().filter_map(|c| c.signal);
        assert!(walks.into_iter().all(|id| green[usize::from(id.0)]), "{name}: a walk signal never turns green");
    }
}

#[test]
fn the_walk_network_is_one_piece() {
    for (name, network) in networks() {
        let n = network.walk.nodes.len();
        let mut near: Vec<Vec<usize>> = vec![Vec::new(); n];
        for edge in &network.walk.edges {
            let [a, b] = edge.nodes.map(|i| i.0 as usize);
            assert!(network.walk.nodes[a].distance(network.walk.nodes[b]) > 0.2, "{name}: an edge of no length");
            near[a].push(b);
            near[b].push(a);
        }
        let mut seen = vec![false; n];
        let mut reached = 0;
        for start in 0..n {
            let (mut open, mut part) = (vec![start], 0);
            while let Some(i) = open.pop() {
                if !std::mem::replace(&mut seen[i], true) {
                    part += 1;
                    open.extend(&near[i]);
                }
            }
            reached = reached.max(part);
        }
        assert!(reached * 10 > n * 9, "{name}: {reached} of {n} walk nodes reached");
    }
}

#[test]
fn lane_ids_index_lanes() {
    for (_, network) in networks() {
        assert!(network.lanes.iter().enumerate().all(|(i, l)| l.id == LaneId(i as u32)));
    }
}

#[test]
fn there_is_room_for_a_hundred_vehicles() {
    for (name, network) in networks() {
        assert!(network.spawn_points.len() >= 100, "{name}: {} spawn points", network.spawn_points.len());
        assert!(network.crossings.iter().all(|c| !c.cuts.is_empty()), "{name}: a crossing cuts no lane");
        let conflicts: usize = network.junctions.iter().map(|j| j.conflicts.len()).sum();
        assert!(conflicts > 0, "{name}");
    }
}

/// Lanes do not overlap, successors meet within 5 cm and 2°, spawn points are no traps, crossings join sidewalks.
#[test]
fn networks_keep_their_promises() {
    for (name, network) in networks() {
        let faults: Vec<String> =
            network.faults().into_iter().map(|f| format!("{:?} {}: {}", f.kind, f.place, f.text)).collect();
        assert_eq!(faults, [""; 0], "{name}");
    }
}

/// Where two lanes of a road led into one lane, simulators that join lanes one to one would drop a turn.
#[test]
fn no_two_lanes_of_a_road_lead_into_one_lane() {
    for (name, network) in networks() {
        let mut arrivals: BTreeMap<(LaneId, LaneId), LaneId> = BTreeMap::new();
        for way in network.lanes.iter().filter(|l| l.junction.is_some()) {
            for &from in way.predecessors.iter().filter(|&&from| network.lane(from).junction.is_none()) {
                let mut leftmost = from;
                while let Some(left) = network.lane(leftmost).left {
                    leftmost = left;
                }
                for &to in &way.successors {
                    let other = *arrivals.entry((leftmost, to)).or_insert(from);
                    let at = way.centerline.at(0.0).position;
                    assert!(other == from, "{name}: {other:?} and {from:?} both lead to {to:?} from {at}");
                }
            }
        }
    }
}
