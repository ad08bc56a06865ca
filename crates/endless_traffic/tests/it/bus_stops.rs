//! Buses at their stops.

use crate::grid::Grid;
use crate::watch;
use endless_road::{Lane, LaneId, Polyline, RoadNetwork, WalkEdge, WalkKind, WalkNetwork, WalkNodeId};
use endless_traffic::{Simulation, TrafficAudit, TrafficSettings};
use endless_world::math::f64::sin_cos;
use endless_world::{Actor, BusStop, Motion, ObjectClass, Side};
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

const FPS: f64 = 30.0;
/// From a bus's foremost point back to its front door, metres.
const DOOR_M: f64 = 1.15;

/// Two lanes around a circle, each in two halves; who is on the outer ones drives along the kerb.
pub(crate) fn ring() -> RoadNetwork {
    ring_of(true)
}

/// With the inner lanes, or without.
pub(crate) fn ring_of(inner: bool) -> RoadNetwork {
    let half = |radius_m: f64, begin: u32| {
        let on_circle = |i: u32| {
            let (sin, cos) = sin_cos(f64::from(i).to_radians());
            DVec3::new(radius_m * cos, radius_m * sin, 0.0)
        };
        Polyline::new((begin..=begin + 180).map(on_circle))
    };
    let lane = |id: u32, radius_m: f64, beside: u32| Lane {
        successors: vec![LaneId(id ^ 1)],
        left: (inner && id < 2).then_some(LaneId(beside)),
        right: (id >= 2).then_some(LaneId(beside)),
        ..Lane::new(LaneId(id), half(radius_m, 180 * (id % 2)), 3.5, 11.0)
    };
    let mut lanes = vec![lane(0, 180.0, 2), lane(1, 180.0, 3), lane(2, 176.5, 0), lane(3, 176.5, 1)];
    lanes.truncate(if inner { 4 } else { 2 });
    // A sidewalk around them, in sixty pieces.
    let node = |k: u32| {
        let (sin, cos) = sin_cos(f64::from(6 * k).to_radians());
        DVec3::new(183.4 * cos, 183.4 * sin, 0.15)
    };
    let edge =
        |k: u32| WalkEdge { nodes: [WalkNodeId(k), WalkNodeId((k + 1) % 60)], width_m: 2.4, kind: WalkKind::Sidewalk };
    let walk = WalkNetwork { nodes: (0..60).map(node).collect(), edges: (0..60).map(edge).collect() };
    RoadNetwork { lanes, walk, ..RoadNetwork::default() }.finish().expect("consistent")
}

/// A sign in the middle of each kerb lane.
fn stops(network: &RoadNetwork) -> Vec<BusStop> {
    let kerb = |lane: &&Lane| lane.junction.is_none() && lane.right.is_none();
    let sign = |lane: &Lane| {
        let s = 0.5 * lane.centerline.length();
        let right = -lane.centerline.direction(s).perp() * (0.5 * lane.width_m + 0.6);
        let at = lane.centerline.position(s) + right.extend(0.15);
        BusStop { position: at.as_vec3(), side: Side::Right }
    };
    network.lanes.iter().filter(kerb).map(sign).collect()
}

fn traffic(network: &RoadNetwork, bus_stops: Vec<BusStop>) -> Simulation {
    let specs = watch::specs();
    let first = vec![ObjectClass::Bus; 6];
    let settings =
        TrafficSettings { vehicles: 60, pedestrians: 0, seed: 4, fps: FPS, first, bus_stops, ..Default::default() };
    watch::simulation(network, &specs, &settings)
}

fn speed(actor: &Actor) -> f64 {
    match actor.motion {
        Motion::Vehicle(motion) => f64::from(motion.speed_mps),
        Motion::Walker(_) => 0.0,
    }
}

fn door(actor: &Actor, half_m: f64) -> DVec2 {
    let (sin, cos) = sin_cos(f64::from(actor.pose.yaw_rad));
    actor.pose.position.as_dvec3().truncate() + DVec2::new(cos, sin) * (half_m - DOOR_M)
}

/// One stand of a bus beside a sign.
#[derive(Default, Clone)]
struct Stand {
    seconds: f64,
    /// Along the lane from the sign to the door, and right of the lane's middle, metres.
    off_m: f64,
    right_m: f64,
    before: Option<Side>,
    after: Option<Side>,
}

/// All stands beside signs in some minutes, and whether the audit was content.
fn watched(network: &RoadNetwork, bus_stops: &[BusStop]) -> (Vec<Stand>, String, bool) {
    let specs = watch::specs();
    let half_m = 0.5 * f64::from(specs.iter().find(|spec| spec.class == ObjectClass::Bus).expect("a bus").length_m);
    let mut simulation = traffic(network, bus_stops.to_vec());
    let mut audit = TrafficAudit::new(network, &specs, &[], FPS);
    let mut stands: Vec<Stand> = Vec::new();
    let mut current: BTreeMap<u16, Stand> = BTreeMap::new();
    for _ in 0..(600.0 * FPS) as usize {
        simulation.tick();
        let state = simulation.state();
        audit.look(&state);
        for bus in state.actors.iter().filter(|actor| actor.class == ObjectClass::Bus) {
            let place = bus.behaviour.lane.expect("it drives");
            let lane = &network.lanes[place.lane as usize];
            let at = door(bus, half_m);
            let beside = |stop: &&BusStop| {
                let sign = stop.position.as_dvec3().truncate();
                let (s, _) = lane.centerline.project(sign);
                sign.distance(at) < 5.0 && lane.junction.is_none() && (0.0..lane.centerline.length()).contains(&s)
            };
            let entry = current.entry(bus.id.0).or_default();
            match bus_stops.iter().find(beside).filter(|_| speed(bus) < 0.03) {
                Some(stop) => {
                    let (s, _) = lane.centerline.project(stop.position.as_dvec3().truncate());
                    let (own_s, left_m) = lane.centerline.project(at);
                    entry.seconds += 1.0 / FPS;
                    (entry.off_m, entry.right_m) = (own_s - s, -left_m);
                    entry.after = bus.behaviour.indicating;
                }
                None if entry.seconds > 8.0 => stands.push(std::mem::take(entry)),
                None => *entry = Stand { before: bus.behaviour.indicating, ..Stand::default() },
            }
        }
    }
    let report = audit.report();
    (stands, report.to_string(), report.passed())
}

#[test]
fn buses_pull_in_stand_with_their_door_at_the_sign_and_go_on() {
    let network = ring();
    let (stands, report, passed) = watched(&network, &stops(&network));
    assert!(passed, "{report}");
    assert!(stands.len() > 5, "{} stands", stands.len());
    for stand in &stands {
        assert!(stand.off_m.abs() < 1.2, "the door is {:.2} m beyond the sign", stand.off_m);
        assert!((10.0..70.0).contains(&stand.seconds), "{:.1} s", stand.seconds);
        // As far to the kerb as a lane of 3.5 m lets a bus of 2.55 m.
        assert!((0.3..0.48).contains(&stand.right_m), "{:.2} m", stand.right_m);
        assert_eq!((stand.before, stand.after), (Some(Side::Right), Some(Side::Left)));
    }
}

#[test]
fn no_bus_stops_for_a_sign_that_is_on_no_kerb() {
    let network = ring();
    let far = stops(&network).into_iter().map(|stop| BusStop { position: stop.position * 1.06, ..stop });
    let inner = stops(&network).into_iter().map(|stop| BusStop { side: Side::Left, ..stop });
    let mut with = traffic(&network, far.chain(inner).collect());
    let mut without = traffic(&network, Vec::new());
    for _ in 0..(120.0 * FPS) as usize {
        with.tick();
        without.tick();
    }
    let (with, without) = (with.state(), without.state());
    assert!(with.actors.iter().any(|actor| actor.class == ObjectClass::Bus));
    assert_eq!(with.actors, without.actors);
}

/// Those behind a bus that stands get past it on the other lane.
#[test]
fn others_change_lanes_to_pass_a_bus_at_its_stop() {
    let network = ring();
    let mut simulation = traffic(&network, stops(&network));
    let mut passed = 0;
    let mut behind: BTreeMap<(u16, u16), bool> = BTreeMap::new();
    for _ in 0..(420.0 * FPS) as usize {
        simulation.tick();
        let state = simulation.state();
        let stand = |actor: &&Actor| actor.class == ObjectClass::Bus && speed(actor) < 0.03;
        for bus in state.actors.iter().filter(stand) {
            let at = bus.pose.position.as_dvec3().truncate();
            for other in state.actors.iter().filter(|other| speed(other) > 2.0) {
                let apart = other.pose.position.as_dvec3().truncate() - at;
                let (sin, cos) = sin_cos(f64::from(bus.pose.yaw_rad));
                let along = apart.dot(DVec2::new(cos, sin));
                if apart.length() < 25.0 {
                    let was = behind.insert((bus.id.0, other.id.0), along < 0.0);
                    passed += u32::from(was == Some(true) && along >= 0.0);
                }
            }
        }
    }
    assert!(passed > 10, "{passed} passed a bus that stood");
}

/// Where a person has stood, and for how long, seconds.
fn waits(network: &RoadNetwork, bus_stops: &[BusStop]) -> Vec<(Actor, f64)> {
    let specs = watch::specs();
    let bus_stops = bus_stops.to_vec();
    let settings = TrafficSettings { vehicles: 0, pedestrians: 60, seed: 2, fps: FPS, bus_stops, ..Default::default() };
    let mut simulation = watch::simulation(network, &specs, &settings);
    let mut audit = TrafficAudit::new(network, &specs, &[], FPS);
    let mut stands: BTreeMap<u16, f64> = BTreeMap::new();
    let mut waits: Vec<(Actor, f64)> = Vec::new();
    for _ in 0..(300.0 * FPS) as usize {
        simulation.tick();
        let state = simulation.state();
        audit.look(&state);
        for person in &state.actors {
            let stood_s = stands.entry(person.id.0).or_default();
            let stands = matches!(person.motion, Motion::Walker(motion) if motion.speed_mps < 0.05);
            *stood_s = if stands && !person.behaviour.waiting { *stood_s + 1.0 / FPS } else { 0.0 };
            if *stood_s > 30.0 {
                waits.retain(|(other, _)| other.id != person.id);
                waits.push((*person, *stood_s));
            }
        }
    }
    let report = audit.report();
    assert!(report.passed(), "{report}");
    waits
}

#[test]
fn people_wait_at_stops_facing_the_road_and_walk_on_if_no_bus_comes() {
    let network = Grid { columns: 3, rows: 3, lanes: 1 }.network();
    let bus_stops = stops(&network);
    let waits_there = waits(&network, &bus_stops);
    assert!(waits_there.len() > 5, "{} wait", waits_there.len());
    for (person, stood_s) in waits_there {
        let at = person.pose.position.as_dvec3().truncate();
        let signs = bus_stops.iter().map(|stop| stop.position.as_dvec3().truncate().distance(at));
        let sign_m = signs.fold(f64::INFINITY, f64::min);
        assert!((0.4..6.0).contains(&sign_m), "{sign_m:.1} m from a sign");
        let lanes = network.lanes.iter().filter(|lane| lane.junction.is_none());
        let roads = lanes.map(|lane| lane.centerline.position(lane.centerline.project(at).0).truncate() - at);
        let road = roads.min_by(|a, b| a.length().total_cmp(&b.length())).expect("a street");
        let (sin, cos) = sin_cos(f64::from(person.pose.yaw_rad));
        assert!(DVec2::new(cos, sin).dot(road.normalize()) > 0.9, "does not face the road");
        assert!(stood_s < 135.0, "{stood_s:.0} s");
    }
    assert!(waits(&network, &[]).is_empty());
}

#[test]
fn people_get_on_buses_and_off_at_another_stop() {
    let (network, specs) = (ring(), watch::specs());
    let first = vec![ObjectClass::Bus; 6];
    let bus_stops = stops(&network);
    let settings =
        TrafficSettings { vehicles: 12, pedestrians: 60, seed: 4, fps: FPS, first, bus_stops, ..Default::default() };
    let mut simulation = watch::simulation(&network, &specs, &settings);
    let mut audit = TrafficAudit::new(&network, &specs, &[], FPS);
    let known: Vec<_> = simulation.everybody(1, |_| Default::default()).iter().map(|actor| actor.id).collect();
    let (mut before, mut on, mut off) = (Vec::new(), 0, 0);
    for frame in 0..(1500.0 * FPS) as usize {
        simulation.tick();
        let state = simulation.state();
        audit.look(&state);
        let people = state.actors.iter().filter(|actor| actor.class == ObjectClass::Pedestrian);
        let now: Vec<_> = people.map(|actor| actor.id).collect();
        assert!(now.iter().all(|id| known.contains(id)));
        if frame > 0 {
            on += before.iter().filter(|id| !now.contains(id)).count();
            off += now.iter().filter(|id| !before.contains(id)).count();
        }
        before = now;
    }
    let report = audit.report();
    assert!(report.passed(), "{report}");
    assert!(on >= 5 && off >= 3 && off <= on, "{on} got on, {off} off");
}
