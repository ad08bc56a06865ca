//! Roads that leave the map: vehicles leave there, and others come.

use crate::watch::{simulation, specs};
use endless_road::{Junction, JunctionId, Lane, LaneId, Polyline, RoadNetwork, TrafficControl, Turn};
use endless_traffic::{AuditCheck, DrivingCondition, Simulation, TrafficAudit, TrafficSettings};
use endless_world::{Actor, InstanceId};
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

const FPS: f64 = 30.0;

fn straight(id: u32, from: [f64; 2], to: [f64; 2], successors: &[u32]) -> Lane {
    let line = Polyline::new([from, to].map(|[x, y]| DVec3::new(x, y, 0.0)));
    Lane { successors: successors.iter().map(|&s| LaneId(s)).collect(), ..Lane::new(LaneId(id), line, 3.3, 13.9) }
}

fn asked(vehicles: u32, seed: u64) -> TrafficSettings {
    TrafficSettings { vehicles, pedestrians: 0, seed, fps: FPS, ..TrafficSettings::default() }
}

/// Two lanes side by side in each direction, 300 m long.
fn avenue() -> RoadNetwork {
    let mut lanes = Vec::new();
    for (side, (from, to)) in [(-1.0, (0.0, 300.0)), (1.0, (300.0, 0.0))] {
        for place in [0.5, 1.5] {
            let (id, y) = (lanes.len() as u32, side * 3.3 * place);
            lanes.push(straight(id, [from, y], [to, y], &[]));
        }
    }
    // Traffic keeps to the right.
    for pair in lanes.chunks_mut(2) {
        (pair[0].right, pair[1].left) = (Some(pair[1].id), Some(pair[0].id));
    }
    RoadNetwork { lanes, ..RoadNetwork::default() }.finish().expect("a sound network")
}

/// A main road from the west to the east, and one from the south that must yield and turns into it.
fn junction() -> RoadNetwork {
    let inside = |lane: Lane, turn| Lane { junction: Some(JunctionId(0)), turn, ..lane };
    let bend = (0..=20).map(|k| {
        let (sin, cos) = endless_world::math::f64::sin_cos(std::f64::consts::FRAC_PI_2 * f64::from(k) / 20.0);
        DVec3::new(16.0 - 16.0 * cos, -16.0 + 16.0 * sin, 0.0)
    });
    let turn = Lane { successors: vec![LaneId(2)], ..Lane::new(LaneId(4), Polyline::new(bend), 3.3, 8.0) };
    let lanes = vec![
        straight(0, [-150.0, 0.0], [-16.0, 0.0], &[1]),
        inside(straight(1, [-16.0, 0.0], [16.0, 0.0], &[2]), Turn::Straight),
        straight(2, [16.0, 0.0], [150.0, 0.0], &[]),
        Lane { end_control: TrafficControl::Yield, ..straight(3, [0.0, -120.0], [0.0, -16.0], &[4]) },
        inside(turn, Turn::Right),
    ];
    let junctions = vec![Junction { lanes: vec![LaneId(1), LaneId(4)], ..Junction::default() }];
    RoadNetwork { lanes, junctions, ..RoadNetwork::default() }.finish().expect("a sound network")
}

/// Two streets of one lane that cross; all must stop.
fn crossing() -> RoadNetwork {
    let mut lanes = Vec::new();
    for [x, y] in [[1.0, 0.0], [0.0, 1.0]] {
        let (id, at) = (lanes.len() as u32, |m: f64| [x * m, y * m]);
        let stops = straight(id, at(-110.0), at(-10.0), &[id + 1]);
        lanes.push(Lane { end_control: TrafficControl::Stop, ..stops });
        let inside = straight(id + 1, at(-10.0), at(10.0), &[id + 2]);
        lanes.push(Lane { junction: Some(JunctionId(0)), turn: Turn::Straight, ..inside });
        lanes.push(straight(id + 2, at(10.0), at(110.0), &[]));
    }
    let junctions = vec![Junction { lanes: vec![LaneId(1), LaneId(4)], ..Junction::default() }];
    RoadNetwork { lanes, junctions, ..RoadNetwork::default() }.finish().expect("a sound network")
}

/// How far along its lane somebody is.
fn place(actor: &Actor) -> (u32, f64) {
    let lane = actor.behaviour.lane.expect("vehicles are on lanes");
    (lane.lane, f64::from(lane.s_m))
}

/// Runs for so many seconds; gives all who were there. Checks that they come and leave at the borders alone, and that no two
/// touch.
fn run(network: &RoadNetwork, simulation: &mut Simulation, seconds: f64) -> BTreeSet<InstanceId> {
    let (specs, borders) = (specs(), network.borders());
    let mut before: BTreeMap<InstanceId, Actor> = simulation.state().actors.iter().map(|a| (a.id, *a)).collect();
    let mut seen: BTreeSet<InstanceId> = before.keys().copied().collect();
    let mut audit = TrafficAudit::new(network, &specs, &[], FPS);
    audit.look(&simulation.state());
    for _ in 0..(seconds * FPS) as u32 {
        simulation.tick();
        let now: BTreeMap<InstanceId, Actor> = simulation.state().actors.iter().map(|a| (a.id, *a)).collect();
        let half = |actor: &Actor| {
            let model = actor.asset.vehicle().expect("a vehicle").model;
            0.5 * f64::from(specs[model.index()].length_m)
        };
        for (id, actor) in now.iter().filter(|(id, _)| !before.contains_key(id)) {
            let (lane, s) = place(actor);
            assert!(seen.insert(*id), "{id} comes twice");
            assert!(borders.entries.contains(&LaneId(lane)) && s < half(actor) + 1.0, "{id} comes at {lane}, {s} m");
        }
        for (id, actor) in before.iter().filter(|(id, _)| !now.contains_key(id)) {
            let (lane, s) = place(actor);
            let left = network.lane(LaneId(lane)).centerline.length() - s - half(actor);
            assert!(
                borders.exits.contains(&LaneId(lane)) && left < 1.0,
                "{id} leaves {left} m before the end of {lane}"
            );
        }
        audit.look(&simulation.state());
        before = now;
    }
    let report = audit.report();
    for check in [AuditCheck::Collisions, AuditCheck::Jumps, AuditCheck::Vanishings, AuditCheck::HardAcceleration] {
        assert!(report.measured(check) <= check.limit(), "{report}");
    }
    seen
}

#[test]
fn for_everybody_who_leaves_another_comes() {
    for (name, network, most) in [("avenue", avenue(), 16), ("junction", junction(), 9)] {
        for seed in 0..4 {
            let mut s = simulation(&network, &specs(), &asked(most, seed));
            assert_eq!(s.population().vehicles_spawned, most, "{name}");
            let seen = run(&network, &mut s, 120.0).len();
            let there = s.state().actors.len();
            assert!(there >= most as usize / 2 && there <= most as usize, "{name} seed {seed}: {there} are left");
            assert!(seen > 3 * most as usize, "{name} seed {seed}: only {seen} have come");
        }
    }
}

#[test]
fn thirty_metres_of_a_lane_hold_somebody() {
    let lanes = vec![straight(0, [0.0, 0.0], [30.0, 0.0], &[])];
    let network = RoadNetwork { lanes, ..RoadNetwork::default() }.finish().expect("a sound network");
    let mut s = simulation(&network, &specs(), &asked(30, 1));
    assert!(s.population().vehicles_spawned >= 1, "{:?}", s.population());
    let mut there = 0;
    for _ in 0..600 {
        s.tick();
        there += s.state().actors.len();
    }
    assert!(there > 300, "somebody is there in most frames, not {there} of 600");
}

/// Half of thirty, on a map whose one junction lets few pass: a scene does not begin when all wait before it.
#[test]
fn a_scene_of_a_small_map_begins_in_motion() {
    let network = crossing();
    for seed in 0..4 {
        let mut s = simulation(&network, &specs(), &asked(30, seed));
        let before = s.state().actors;
        (0..FPS as u32).for_each(|_| s.tick());
        let after: BTreeMap<InstanceId, Actor> = s.state().actors.into_iter().map(|a| (a.id, a)).collect();
        // Who has left has moved.
        let stands = |actor: &&Actor| {
            let now = after.get(&actor.id);
            now.is_some_and(|now| now.pose.position.distance(actor.pose.position) < 0.2)
        };
        let moving = before.len() - before.iter().filter(stands).count();
        assert!(moving >= 15, "seed {seed}: {moving} of {} move", before.len());
    }
}

#[test]
fn all_who_will_come_are_known_beforehand() {
    let network = avenue();
    let mut s = simulation(&network, &specs(), &asked(16, 3));
    let weather = |frame: u32| DrivingCondition { wetness: if frame > 60 { 1.0 } else { 0.0 }, ..Default::default() };
    let cast: BTreeMap<InstanceId, Actor> = s.everybody(300, weather).into_iter().map(|a| (a.id, a)).collect();
    let first = s.state().actors.len();
    for _ in 0..300 {
        s.set_condition(weather(s.state().frame + 1));
        s.tick();
        for actor in s.state().actors {
            assert_eq!(cast[&actor.id].asset, actor.asset);
        }
    }
    assert!(cast.len() > first, "somebody has come");
}

#[test]
fn the_same_seed_brings_the_same_vehicles() {
    let network = junction();
    let run = |seed| {
        let mut s = simulation(&network, &specs(), &asked(9, seed));
        (0..900).for_each(|_| s.tick());
        s.state()
    };
    assert_eq!(run(5), run(5));
    assert_ne!(run(5).actors, run(6).actors);
}
