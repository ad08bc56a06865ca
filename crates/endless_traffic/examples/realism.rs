//! How our traffic compares with measured traffic: `cargo run --release -p endless_traffic --example realism`; a part of it
//! with `-- streets`, `-- signal`, `-- ring`, `-- feet` or `-- crowd`.
//!
//! Each line has our figure, the published range and its source; the exit code is 1 where one is outside of it. On streets:
//! speeds and time headways on the arterials of our towns. On a ring: flow by density, the fundamental diagram. At a signal:
//! the flow of a queue that discharges, and how densely it stands. On foot: free speeds, and speed by density in a closed
//! corridor.
#![expect(clippy::print_stdout, reason = "a report on standard output")]

use endless_asset::Catalogue;
use endless_road::{
    Junction, JunctionId, Lane, LaneId, NetworkError, Polyline, RoadNetwork, SignalPhase, SignalProgram,
    TrafficControl, WalkEdge, WalkKind, WalkNetwork, WalkNodeId,
};
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::math::f64::{exp, sin_cos};
use endless_world::walking::PedestrianSpec;
use endless_world::{Actor, Motion, ObjectClass, SignalAspect, SignalId, VehicleSpec};
use glam::DVec3;
use std::{collections::BTreeMap, error::Error, f64::consts::TAU, process::ExitCode};

const FPS: f64 = 10.0;
const LIMIT_MPS: f64 = 50.0 / 3.6;

/// What was measured elsewhere.
struct Published {
    what: &'static str,
    unit: &'static str,
    range: [f64; 2],
    source: &'static str,
}

const NGSIM: &str = "NGSIM, Lankershim Boulevard and Peachtree Street (FHWA 2007)";
const HCM: &str = "Highway Capacity Manual 2016";

const ARTERIAL_SPEED: Published =
    Published { what: "median speed of who moves on arterials", unit: "m/s", range: [6.6, 8.6], source: NGSIM };
const ARTERIAL_HEADWAY: Published =
    Published { what: "median time headway on arterials", unit: "s", range: [1.9, 2.3], source: NGSIM };
const SATURATION: Published =
    Published { what: "saturation flow at a signal", unit: "veh/h/lane", range: [1800.0, 1900.0], source: HCM };
const CAPACITY: Published =
    Published { what: "capacity of a ring road", unit: "veh/h/lane", range: [1800.0, 2400.0], source: HCM };
const JAM_DENSITY: Published = Published {
    what: "jam density",
    unit: "veh/km",
    range: [120.0, 150.0],
    source: "Treiber and Kesting 2013, Traffic Flow Dynamics",
};
const WALKING: Published = Published {
    what: "median speed on foot in streets",
    unit: "m/s",
    range: [1.2, 1.5],
    source: "Bohannon 1997; Weidmann 1993",
};
const CROWDED: Published = Published {
    what: "median speed on foot in a dense crowd, 1.5/m2",
    unit: "m/s",
    range: [0.6, 0.95],
    source: "0.77: ETH and UCY",
};

const OFF_WEIDMANN: Published = Published {
    what: "speed in a corridor off Weidmann's curve",
    unit: "share",
    range: [0.0, 0.2],
    source: "Weidmann 1993, Transporttechnik der Fussgaenger",
};

/// Longest time headway of who follows somebody, seconds (Highway Capacity Manual 2010, chapter 15).
const FOLLOWS_S: f64 = 3.0;

/// Somebody who walks: nobody jogged in the corridors that were measured.
fn who_walks(seed: u64) -> PedestrianSpec {
    PedestrianSpec { dressed_to_run: false, ..Catalogue::pedestrian_spec(seed) }
}

/// Prints a figure beside what is published; whether it is within the range.
fn compare(published: &Published, ours: f64) -> bool {
    let Published { what, unit, range: [low, high], source } = published;
    let within = (*low..=*high).contains(&ours);
    let digits = if *high > 100.0 { 0 } else { 2 };
    let verdict = if within { "within" } else { "OUTSIDE" };
    println!("{what:44} {ours:8.digits$} {unit:10} {low:.digits$} to {high:.digits$}, {verdict}  [{source}]");
    within
}

fn quantile(values: &mut [f64], share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    if values.is_empty() { f64::NAN } else { values[((values.len() - 1) as f64 * share).round() as usize] }
}

/// Where somebody drives: the lane, metres along it, m/s, half the length.
fn driving(actor: &Actor, specs: &[VehicleSpec]) -> Option<(u32, f64, f64, f64)> {
    let (Motion::Vehicle(motion), Some(place)) = (actor.motion, actor.behaviour.lane) else { return None };
    let length = f64::from(specs[actor.asset.vehicle()?.model.index()].length_m);
    Some((place.lane, f64::from(place.s_m), f64::from(motion.speed_mps), 0.5 * length))
}

/// Speeds of those who move, and time headways of those who follow somebody, on roads with several lanes each way and limits
/// of about those of Lankershim Boulevard and Peachtree Street, 35 miles an hour.
fn arterials(catalogue: &Catalogue) -> Result<[Vec<f64>; 2], Box<dyn Error>> {
    const MOVES_MPS: f64 = 0.5;
    const LIMITS_MPS: std::ops::Range<f64> = 13.0..18.0;
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let (mut speeds, mut headways) = (Vec::new(), Vec::new());
    for name in ["Town03", "Town05", "Town10HD"] {
        let town = endless_town::load(name, catalogue)?;
        let network = &town.network;
        let arterial = |lane: u32| {
            let lane = network.lane(LaneId(lane));
            lane.junction.is_none()
                && (lane.left.is_some() || lane.right.is_some())
                && LIMITS_MPS.contains(&lane.speed_limit_mps)
        };
        for seed in 0..2 {
            let settings =
                TrafficSettings { vehicles: 150, pedestrians: 60, seed, fps: FPS, ..TrafficSettings::default() };
            let mut traffic = Simulation::new(network, &fleet, &town.parked, &settings)?;
            // When and how fast the last vehicle passed the middle of each lane.
            let mut passed: BTreeMap<u32, f64> = BTreeMap::new();
            let mut before: BTreeMap<u16, (u32, f64)> = BTreeMap::new();
            for frame in 0..(120.0 * FPS) as u32 {
                traffic.tick();
                let time_s = f64::from(frame) / FPS;
                for actor in &traffic.state().actors {
                    let Some((lane, s, speed, half)) = driving(actor, &specs) else { continue };
                    if actor.class == ObjectClass::Bicycle || !arterial(lane) {
                        continue;
                    }
                    if speed > MOVES_MPS && frame % FPS as u32 == 0 {
                        speeds.push(speed);
                    }
                    let middle = 0.5 * network.lane(LaneId(lane)).centerline.length();
                    let front = s + half;
                    let was = before.insert(actor.id.0, (lane, front));
                    if was.is_some_and(|(l, f)| l == lane && f < middle && front >= middle) {
                        // Between two frames.
                        let now = time_s - (front - middle) / speed.max(0.1);
                        if let Some(last) = passed.insert(lane, now)
                            && now - last < FOLLOWS_S
                        {
                            headways.push(now - last);
                        }
                    }
                }
            }
        }
    }
    Ok([speeds, headways])
}

/// One lane in a circle, in pieces of these lengths that follow one another.
fn ring(pieces: &[f64]) -> Vec<Lane> {
    let whole: f64 = pieces.iter().sum();
    let radius = whole / TAU;
    let point = |s: f64| {
        let (sin, cos) = sin_cos(s / radius);
        DVec3::new(radius * cos, radius * sin, 0.0)
    };
    let mut begin = 0.0;
    let mut lanes = Vec::new();
    for (number, length) in (0..).zip(pieces) {
        let steps = (length / 2.0).ceil() as u32;
        let line = Polyline::new((0..=steps).map(|k| point(begin + length * f64::from(k) / f64::from(steps))));
        let next = LaneId((number + 1) % pieces.len() as u32);
        lanes.push(Lane { successors: vec![next], ..Lane::new(LaneId(number), line, 3.5, LIMIT_MPS) });
        begin += length;
    }
    lanes
}

/// Highest flow on a ring, veh/h, with the density at which it is reached, veh/km.
fn fundamental_diagram(fleet: &Fleet<'_>) -> Result<(f64, f64), Box<dyn Error>> {
    const LENGTH_M: f64 = 1000.0;
    let network = RoadNetwork { lanes: ring(&[500.0, 500.0]), ..RoadNetwork::default() }.finish()?;
    println!("a ring of {LENGTH_M:.0} m: density veh/km, speed km/h, flow veh/h");
    let mut best = (0.0, 0.0);
    for vehicles in [5, 10, 15, 20, 25, 30, 35, 40, 50, 60] {
        let settings = TrafficSettings { vehicles, pedestrians: 0, seed: 1, fps: FPS, ..TrafficSettings::default() };
        let mut traffic = Simulation::new(&network, fleet, &[], &settings)?;
        let spawned = f64::from(traffic.population().vehicles_spawned);
        (0..(60.0 * FPS) as u32).for_each(|_| traffic.tick());
        let (mut sum_mps, mut seen) = (0.0, 0.0);
        for _ in 0..(60.0 * FPS) as u32 {
            traffic.tick();
            for (_, _, speed, _) in traffic.state().actors.iter().filter_map(|actor| driving(actor, fleet.vehicles)) {
                sum_mps += speed;
                seen += 1.0;
            }
        }
        let (density, speed_kmh) = (spawned * 1000.0 / LENGTH_M, 3.6 * sum_mps / seen);
        println!("  {density:6.0} {speed_kmh:8.1} {:8.0}", density * speed_kmh);
        if density * speed_kmh > best.0 {
            best = (density * speed_kmh, density);
        }
    }
    Ok(best)
}

/// A ring with a signal: green long enough for a queue to discharge.
fn signal_ring() -> Result<RoadNetwork, NetworkError> {
    let mut lanes = ring(&[480.0, 20.0, 300.0]);
    lanes[0].end_control = TrafficControl::Signal(SignalId(0));
    lanes[1].junction = Some(JunctionId(0));
    let phase = |duration_s, aspect| SignalPhase { duration_s, aspects: vec![(SignalId(0), aspect)] };
    let phases =
        vec![phase(50.0, SignalAspect::Green), phase(3.0, SignalAspect::Yellow), phase(67.0, SignalAspect::Red)];
    let program = Some(SignalProgram { phases, offset_s: 0.0 });
    let junctions = vec![Junction { lanes: vec![LaneId(1)], program, ..Junction::default() }];
    RoadNetwork { lanes, junctions, signal_groups: 1, ..RoadNetwork::default() }.finish()
}

/// Time headways at the line, s, of the vehicles of a queue from the fifth on, as the manual counts them; and the lane that
/// each has in the standing queue, metres.
fn discharge(fleet: &Fleet<'_>) -> Result<[Vec<f64>; 2], Box<dyn Error>> {
    const FIRST: usize = 4;
    const LAST: usize = 14;
    let network = signal_ring()?;
    let line = network.lanes[0].centerline.length();
    let (mut headways, mut spacings) = (Vec::new(), Vec::new());
    for seed in 0..6 {
        let settings = TrafficSettings { vehicles: 34, pedestrians: 0, seed, fps: 30.0, ..TrafficSettings::default() };
        let mut traffic = Simulation::new(&network, fleet, &[], &settings)?;
        let (mut crossed, mut queue): (Vec<f64>, usize) = (Vec::new(), 0);
        let mut before: BTreeMap<u16, f64> = BTreeMap::new();
        let mut green = false;
        for _ in 0..(600.0 * 30.0) as u32 {
            traffic.tick();
            let state = traffic.state();
            let on: Vec<(u16, f64, f64, f64)> = state
                .actors
                .iter()
                .filter_map(|a| driving(a, fleet.vehicles).map(|d| (a.id.0, d)))
                .filter(|(_, (lane, ..))| *lane == 0)
                .map(|(id, (_, s, speed, half))| (id, s + half, speed, half))
                .collect();
            let turned = state.signals[0].aspect == SignalAspect::Green;
            if turned && !green {
                let mut fronts: Vec<f64> = on.iter().filter(|v| v.2 < 0.1).map(|v| v.1).collect();
                fronts.sort_by(|a, b| b.total_cmp(a));
                queue = fronts.len();
                spacings.extend(fronts.windows(2).map(|pair| pair[0] - pair[1]).filter(|gap| *gap < 25.0));
                crossed.clear();
            }
            green = turned;
            for (id, front, speed, _) in on {
                let was = before.insert(id, front);
                if was.is_some_and(|was| was < line && was > line - 30.0 && front >= line) {
                    crossed.push(state.time_s - (front - line) / speed.max(0.1));
                    let n = crossed.len();
                    if (FIRST + 1..=LAST.min(queue)).contains(&n) {
                        headways.push(crossed[n - 1] - crossed[n - 2]);
                    }
                }
            }
        }
    }
    Ok([headways, spacings])
}

/// Speeds of all who walk in towns, m/s, at their own pace: who stands is left out.
fn pedestrians(catalogue: &Catalogue) -> Result<Vec<f64>, Box<dyn Error>> {
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let mut speeds = Vec::new();
    for name in ["Town03", "Town10HD"] {
        let town = endless_town::load(name, catalogue)?;
        let settings = TrafficSettings { vehicles: 30, pedestrians: 100, seed: 1, ..TrafficSettings::default() };
        let mut traffic = Simulation::new(&town.network, &fleet, &town.parked, &settings)?;
        for _ in 0..60 {
            (0..10).for_each(|_| traffic.tick());
            speeds.extend(walking(&traffic).filter(|speed| *speed > 0.2));
        }
    }
    Ok(speeds)
}

fn walking(traffic: &Simulation) -> impl Iterator<Item = f64> {
    traffic.state().actors.into_iter().filter_map(|actor| match actor.motion {
        Motion::Walker(walker) => Some(f64::from(walker.speed_mps)),
        Motion::Vehicle(_) => None,
    })
}

/// A corridor that closes on itself, and its area, square metres.
fn corridor() -> Result<(RoadNetwork, f64), NetworkError> {
    const SIDES: u32 = 20;
    const WIDTH_M: f64 = 3.5;
    const RADIUS_M: f64 = 10.0;
    let node = |k: u32| {
        let (sin, cos) = sin_cos(TAU * f64::from(k) / f64::from(SIDES));
        DVec3::new(RADIUS_M * cos, RADIUS_M * sin, 0.0)
    };
    let edge = |k: u32| WalkEdge {
        nodes: [WalkNodeId(k), WalkNodeId((k + 1) % SIDES)],
        width_m: WIDTH_M,
        kind: WalkKind::Sidewalk,
    };
    let walk = WalkNetwork { nodes: (0..SIDES).map(node).collect(), edges: (0..SIDES).map(edge).collect() };
    let network = RoadNetwork { lanes: ring(&[300.0, 300.0]), walk, ..RoadNetwork::default() }.finish()?;
    Ok((network, TAU * RADIUS_M * WIDTH_M))
}

/// Weidmann's speed of people at a density, m/s, for who walks at 1.34 m/s where nobody is.
fn weidmann_mps(density: f64) -> f64 {
    1.34 * (1.0 - exp(-1.913 * (1.0 / density - 1.0 / 5.4)))
}

/// Prints our speed and flow by density beside Weidmann's; the largest deviation of speeds as a share of Weidmann's, and the
/// median speed in a dense crowd.
fn crowd(fleet: &Fleet<'_>) -> Result<(f64, f64), Box<dyn Error>> {
    const DENSE: f64 = 1.5;
    let (network, area) = corridor()?;
    println!("a closed corridor: people/m2, speed m/s (Weidmann's), flow 1/m/s (Weidmann's)");
    let (mut worst, mut dense_mps): (f64, f64) = (0.0, 0.0);
    for wanted in [0.1, 0.25, 0.5, 0.75, 1.0, 1.25, DENSE, 1.75] {
        let pedestrians = (wanted * area).round() as u32;
        let settings = TrafficSettings { vehicles: 0, pedestrians, seed: 3, fps: FPS, ..TrafficSettings::default() };
        let mut traffic = Simulation::new(&network, fleet, &[], &settings)?;
        let density = f64::from(traffic.population().pedestrians_spawned) / area;
        (0..200).for_each(|_| traffic.tick());
        let mut speeds = Vec::new();
        for _ in 0..30 {
            (0..10).for_each(|_| traffic.tick());
            speeds.extend(walking(&traffic));
        }
        let mean = speeds.iter().sum::<f64>() / speeds.len() as f64;
        let theirs = weidmann_mps(density);
        println!("  {density:4.2} {mean:6.2} ({theirs:.2}) {:6.2} ({:.2})", density * mean, density * theirs);
        worst = worst.max((mean / theirs - 1.0).abs());
        if wanted == DENSE {
            dense_mps = quantile(&mut speeds, 0.5);
        }
    }
    Ok((worst, dense_mps))
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let catalogue = Catalogue::builtin();
    // On a ring and at a signal: the catalogue's cars and vans, as the manuals count passenger cars.
    let cars: Vec<VehicleSpec> = catalogue
        .vehicle_specs()
        .into_iter()
        .filter(|s| matches!(s.class, ObjectClass::Car | ObjectClass::Van))
        .collect();
    let fleet = Fleet { vehicles: &cars, pedestrian: &who_walks };
    let parts: Vec<String> = std::env::args().skip(1).collect();
    let asked = |part: &str| parts.is_empty() || parts.iter().any(|p| p == part);
    let mut within = true;
    if asked("streets") {
        let [mut speeds, mut headways] = arterials(&catalogue)?;
        within &= compare(&ARTERIAL_SPEED, quantile(&mut speeds, 0.5));
        within &= compare(&ARTERIAL_HEADWAY, quantile(&mut headways, 0.5));
        println!(
            "  of {} headways below {FOLLOWS_S} s a quarter is below {:.2} s, three quarters below {:.2} s",
            headways.len(),
            quantile(&mut headways, 0.25),
            quantile(&mut headways, 0.75),
        );
    }
    if asked("signal") {
        let [headways, spacings] = discharge(&fleet)?;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        within &= compare(&SATURATION, 3600.0 / mean(&headways));
        within &= compare(&JAM_DENSITY, 1000.0 / mean(&spacings));
    }
    if asked("ring") {
        let (capacity, at) = fundamental_diagram(&fleet)?;
        within &= compare(&CAPACITY, capacity);
        println!("  at {at:.0} veh/km");
    }
    if asked("feet") {
        within &= compare(&WALKING, quantile(&mut pedestrians(&catalogue)?, 0.5));
    }
    if asked("crowd") {
        let (worst, crowded) = crowd(&fleet)?;
        within &= compare(&OFF_WEIDMANN, worst);
        within &= compare(&CROWDED, crowded);
    }
    Ok(if within { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
