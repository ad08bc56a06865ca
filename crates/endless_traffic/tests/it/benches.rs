//! People on benches.

use crate::bus_stops::ring_of;
use crate::watch;
use endless_road::RoadNetwork;
use endless_traffic::{DrivingCondition, Simulation, TrafficAudit, TrafficSettings};
use endless_world::math::f64::sin_cos;
use endless_world::{Actor, BenchSeat, Gait, InstanceId, Motion};
use glam::{DVec2, DVec3};
use std::collections::{BTreeMap, BTreeSet};

const FPS: f64 = 30.0;

/// Three seats in each of ten benches along the kerb, which look away from the road; every other bench stands back from the
/// sidewalk, on its far side.
fn seats() -> Vec<BenchSeat> {
    let seat = |bench: u32, across_m: f64| {
        let angle = f64::from(36 * bench + 3).to_radians();
        let (sin, cos) = sin_cos(angle);
        let (out, along) = (DVec2::new(cos, sin), DVec2::new(-sin, cos));
        let far = bench % 2 == 1;
        let at = out * if far { 185.6 } else { 182.7 } + along * across_m;
        let yaw = if far { angle + std::f64::consts::PI } else { angle };
        BenchSeat { position: DVec3::new(at.x, at.y, 0.15).as_vec3(), yaw_rad: yaw as f32 }
    };
    (0..10).flat_map(|bench| [-0.6, 0.0, 0.6].map(|across_m| seat(bench, across_m))).collect()
}

fn traffic(network: &RoadNetwork, pedestrians: u32, condition: DrivingCondition) -> Simulation {
    let bench_seats = seats();
    let settings = TrafficSettings {
        vehicles: 0,
        pedestrians,
        seed: 3,
        fps: FPS,
        condition,
        bench_seats,
        ..TrafficSettings::default()
    };
    watch::simulation(network, &watch::specs(), &settings)
}

/// Of who sits: share of the way up from the seat.
fn risen(actor: &Actor) -> Option<f32> {
    let Motion::Walker(motion) = actor.motion else { return None };
    (motion.gait == Gait::Sit).then_some(motion.risen)
}

fn seated(simulation: &Simulation) -> BTreeSet<InstanceId> {
    let state = simulation.state();
    state.actors.iter().filter(|actor| risen(actor) == Some(0.0)).map(|actor| actor.id).collect()
}

#[test]
fn people_sit_down_stay_and_walk_on() {
    let (network, specs) = (ring_of(true), watch::specs());
    let mut simulation = traffic(&network, 40, DrivingCondition::default());
    let mut audit = TrafficAudit::new(&network, &specs, &[], FPS).with_bench_seats(&seats());
    let at_first = seated(&simulation).len();
    assert!((1..=15).contains(&at_first), "{at_first} of 40 sit at the beginning");
    let mut sat_down = BTreeSet::new();
    let mut got_up = BTreeSet::new();
    let mut before: BTreeMap<InstanceId, Option<f32>> = BTreeMap::new();
    for _ in 0..(600.0 * FPS) as usize {
        simulation.tick();
        let state = simulation.state();
        audit.look(&state);
        for actor in &state.actors {
            let now = risen(actor);
            let earlier = before.insert(actor.id, now);
            let changes = earlier.is_some_and(|earlier| (earlier.unwrap_or(1.0) - now.unwrap_or(1.0)).abs() > 0.06);
            assert!(!changes, "{} is up and down in an instant: {earlier:?} {now:?}", actor.id);
            if now == Some(0.0) && earlier.flatten().is_some_and(|risen| risen > 0.0) {
                sat_down.insert(actor.id);
            }
            if now.is_none() && earlier.flatten().is_some() {
                got_up.insert(actor.id);
            }
        }
    }
    let report = audit.report();
    assert!(report.passed(), "{report}");
    assert!(sat_down.len() > 8 && got_up.len() > 8, "{} sat down, {} got up", sat_down.len(), got_up.len());
    let at_last = seated(&simulation).len();
    assert!((at_first / 3..=3 * at_first).contains(&at_last), "{at_first} sat at the beginning, {at_last} at the end");
}

/// More people than seats: each seat has one.
#[test]
fn a_seat_is_for_one() {
    let (network, specs) = (ring_of(true), watch::specs());
    let mut simulation = traffic(&network, 150, DrivingCondition::default());
    let mut audit = TrafficAudit::new(&network, &specs, &[], FPS).with_bench_seats(&seats());
    let mut most = 0;
    for _ in 0..(240.0 * FPS) as usize {
        simulation.tick();
        audit.look(&simulation.state());
        most = most.max(seated(&simulation).len());
    }
    let report = audit.report();
    assert!(report.passed(), "{report}");
    assert!((12..=30).contains(&most), "{most} sat at once on 30 seats");
}

#[test]
fn nobody_sits_at_night_or_in_rain_and_rain_makes_people_get_up() {
    let network = ring_of(true);
    let (day, rain) = (DrivingCondition::default(), DrivingCondition { rain: 0.5, ..DrivingCondition::default() });
    for condition in [rain, DrivingCondition { headlights_on: 1.0, ..day }, DrivingCondition { wetness: 0.6, ..day }] {
        let mut simulation = traffic(&network, 40, condition);
        for _ in 0..(120.0 * FPS) as usize {
            assert!(seated(&simulation).is_empty());
            simulation.tick();
        }
    }
    let mut simulation = traffic(&network, 40, day);
    assert!(!seated(&simulation).is_empty());
    simulation.set_condition(rain);
    for _ in 0..(40.0 * FPS) as usize {
        simulation.tick();
    }
    assert!(seated(&simulation).is_empty());
}
