//! What `finish` derives, and what it refuses.

use crate::grid::Grid;
use endless_road::*;
use endless_world::Stream;
use glam::{DVec2, DVec3};
use proptest::prelude::*;

const GRID: Grid = Grid { columns: 3, rows: 3, lanes: 2 };

#[test]
fn exactly_one_side_of_a_conflict_gives_way() {
    let network = GRID.network();
    let mut pairs = 0;
    for junction in &network.junctions {
        for c in &junction.conflicts {
            let back: Vec<_> = junction.conflicts.iter().filter(|d| d.lane == c.other && d.other == c.lane).collect();
            assert_eq!(back.len(), 1);
            assert_ne!(c.gives_way, back[0].gives_way, "{c:?}");
            assert_eq!((c.range, c.other_range), (back[0].other_range, back[0].range));
            assert!(c.range.0 <= c.range.1 && c.range.1 <= network.lane(c.lane).centerline.length() + 1e-9);
            pairs += 1;
        }
    }
    assert!(pairs > 100);
}

#[test]
fn left_turns_wait_for_those_who_come_towards_them_and_parallel_lanes_do_not_conflict() {
    let network = GRID.network();
    let heading = |lane: &Lane, s: f64| lane.centerline.at(s).heading_rad;
    let mut seen = 0;
    for c in network.junctions.iter().flat_map(|j| &j.conflicts) {
        let (a, b) = (network.lane(c.lane), network.lane(c.other));
        let angle = endless_world::math::f64::wrap_angle(heading(b, 0.0) - heading(a, 0.0)).to_degrees().abs();
        assert!(!(angle < 1.0 && a.turn == Turn::Straight && b.turn == Turn::Straight));
        let controls = [a, b].map(|l| network.lane(l.predecessors[0]).end_control);
        if angle > 170.0 && a.turn == Turn::Left && b.turn == Turn::Straight && controls[0] == controls[1] {
            assert!(c.gives_way);
            seen += 1;
        }
    }
    assert!(seen > 0);
}

#[test]
fn signs_rank_approaches() {
    let network = GRID.network();
    let control = |id: LaneId| network.lane(network.lane(id).predecessors[0]).end_control;
    let mut seen = 0;
    for c in network.junctions.iter().flat_map(|j| &j.conflicts) {
        if control(c.lane) == TrafficControl::Yield && control(c.other) == TrafficControl::Free {
            assert!(c.gives_way);
            seen += 1;
        }
    }
    assert!(seen > 0);
}

#[test]
fn crossings_cut_every_lane_they_cross() {
    let network = GRID.network();
    for crossing in &network.crossings {
        // Every arm has lanes in and out, and its crossing lies over connectors only.
        assert!(crossing.cuts.len() >= 2);
        for cut in &crossing.cuts {
            let lane = network.lane(cut.lane);
            assert!(lane.junction.is_some());
            let middle = lane.centerline.at(0.5 * (cut.range.0 + cut.range.1)).position;
            let center = 0.5 * (crossing.ends[0] + crossing.ends[1]);
            assert!(middle.distance(center) < 0.5 * crossing.ends[0].distance(crossing.ends[1]) + 2.1);
        }
    }
}

#[test]
fn spawn_points_keep_their_distances() {
    let network = GRID.network();
    assert!(network.spawn_points.len() > 200);
    for pair in network.spawn_points.windows(2) {
        assert!(pair[0].lane != pair[1].lane || pair[1].s - pair[0].s >= 8.0 - 1e-9);
    }
    for p in &network.spawn_points {
        let lane = network.lane(p.lane);
        assert!(lane.junction.is_none() && p.s >= 6.0 && p.s <= lane.centerline.length() - 6.0);
    }
}

#[test]
fn faults_are_named() {
    let mut gap = GRID.raw();
    let moved = gap.lanes[0].centerline.points().iter().map(|p| *p + DVec3::new(0.0, 0.2, 0.0)).collect::<Vec<_>>();
    gap.lanes[0].centerline = Polyline::new(moved);
    assert!(matches!(gap.finish(), Err(NetworkError::Gap { .. })));

    let mut idle = GRID.raw();
    idle.crossings[0].ends = [DVec3::new(500.0, 500.0, 0.0), DVec3::new(500.0, 510.0, 0.0)];
    assert_eq!(idle.finish(), Err(NetworkError::CutsNothing { crossing: CrossingId(0) }));

    let mut edge = GRID.raw();
    edge.walk.edges[3].nodes[0] = WalkNodeId(9999);
    assert_eq!(edge.finish(), Err(NetworkError::WalkEdge { edge: WalkEdgeId(3) }));

    let mut id = GRID.raw();
    id.lanes[4].id = LaneId(5);
    assert_eq!(id.finish(), Err(NetworkError::LaneId { place: 4, id: LaneId(5) }));

    let mut signal = GRID.raw();
    signal.signal_groups = 1;
    assert!(matches!(signal.finish(), Err(NetworkError::UnknownSignal { .. })));
}

#[test]
fn a_random_walk_never_ends() {
    let network = GRID.network();
    let allowed = network.circulating_lanes();
    assert!(allowed.iter().all(|&a| a), "a grid circulates everywhere");
    let mut stream = Stream::new(1, &[]);
    let mut lane = LaneId(0);
    for _ in 0..1000 {
        let next = network.next_lane(lane, &allowed, &mut stream).unwrap();
        assert!(network.lane(lane).successors.contains(&next));
        assert!(network.lane(next).predecessors.contains(&lane));
        lane = next;
    }
}

#[test]
fn dead_ends_do_not_circulate() {
    let mut network = GRID.raw();
    let end = network.lanes[0].centerline.length();
    let from = network.lanes[0].centerline.at(end).position;
    let mut stub = network.lanes[0].clone();
    stub.id = LaneId(network.lanes.len() as u32);
    stub.centerline = Polyline::new([from, from + DVec3::new(20.0, 0.0, 0.0)]);
    stub.successors.clear();
    (stub.left, stub.right) = (None, None);
    network.lanes[0].successors.push(stub.id);
    network.lanes.push(stub);
    let network = network.finish().unwrap();
    let allowed = network.circulating_lanes();
    assert!(!allowed[network.lanes.len() - 1] && allowed[0]);
}

proptest! {
    #[test]
    fn walks_are_consecutive_and_symmetric(a in 0u32..72, b in 0u32..72) {
        let network = GRID.network();
        let graph = WalkGraph::new(&network.walk);
        let (a, b) = (WalkNodeId(a), WalkNodeId(b));
        let way = graph.shortest(&network.walk, a, b);
        let mut node = a;
        for (edge, next) in &way {
            let nodes = network.walk.edges[edge.index()].nodes;
            prop_assert!(nodes == [node, *next] || nodes == [*next, node]);
            node = *next;
        }
        if graph.part(a) == graph.part(b) {
            prop_assert_eq!(node, b);
        }
        let length = |way: &[(WalkEdgeId, WalkNodeId)]| way.iter().map(|(e, _)| {
            let [p, q] = network.walk.edges[e.index()].nodes.map(|n| network.walk.nodes[n.index()]);
            p.distance(q)
        }).sum::<f64>();
        prop_assert!((length(&way) - length(&graph.shortest(&network.walk, b, a))).abs() < 20.0);
    }

    #[test]
    fn places_on_gentle_lines_project_back(turns in prop::collection::vec(-0.2f64..0.2, 3..12), u in 0.0f64..1.0, t in -1.5f64..1.5) {
        let line = gentle(&turns);
        let s = u * line.length();
        let (found, side) = line.project(line.at(s).position.truncate());
        prop_assert!((found - s).abs() < 1e-6 && side.abs() < 1e-6);
        // Inside a segment the perpendicular foot is exact.
        let i = line.points().len() / 2;
        let middle = 0.5 * (line.points()[i] + line.points()[i - 1]);
        let along = (line.points()[i] - line.points()[i - 1]).truncate().normalize();
        let (_, side) = line.project(middle.truncate() + along.perp() * t);
        prop_assert!((side - t).abs() < 1e-6);
    }

    #[test]
    fn an_offset_line_keeps_its_distance(turns in prop::collection::vec(-0.2f64..0.2, 3..12), t in -2.0f64..2.0) {
        let line = gentle(&turns);
        let moved = line.offset(t);
        for p in moved.points() {
            let (_, side) = line.project(p.truncate());
            prop_assert!((side.abs() - t.abs()).abs() < 0.05, "{} {}", side, t);
        }
        prop_assert!((line.offset(t).offset(-t).points()[0] - line.points()[0]).length() < 1e-9);
    }

    #[test]
    fn headings_change_without_jumps(turns in prop::collection::vec(-0.2f64..0.2, 3..12)) {
        let line = gentle(&turns);
        let mut before = line.at(0.0).heading_rad;
        let mut s = 0.0;
        while s < line.length() {
            let here = line.at(s).heading_rad;
            prop_assert!(endless_world::math::f64::wrap_angle(here - before).abs() < 0.02);
            before = here;
            s += 0.1;
        }
    }
}

/// Segments of 4 m, each turned a little from the one before.
fn gentle(turns: &[f64]) -> Polyline {
    let mut heading = 0.3;
    let mut at = DVec2::new(3.0, -5.0);
    let mut points = vec![at.extend(1.0)];
    for turn in turns {
        let (sin, cos) = endless_world::math::f64::sin_cos(heading);
        at += DVec2::new(cos, sin) * 4.0;
        points.push(at.extend(1.0));
        heading += turn;
    }
    Polyline::new(points)
}
