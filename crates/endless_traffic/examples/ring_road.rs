//! A ring road by itself: mean speed and flow by density, the fundamental diagram of traffic.
//! `cargo run -p endless_traffic --example ring_road`.
#![expect(clippy::print_stdout, reason = "it says what it measured")]

use endless_road::{Lane, LaneId, NetworkError, Polyline, RoadNetwork};
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::math::f64::sin_cos;
use endless_world::walking::PedestrianSpec;
use endless_world::{Motion, ObjectClass, VehicleSpec};
use glam::DVec3;
use std::{
    error::Error,
    f64::consts::{PI, TAU},
};

const RADIUS_M: f64 = 120.0;
const WIDTH_M: f64 = 3.5;
const LIMIT_MPS: f64 = 50.0 / 3.6;
const FPS: f64 = 10.0;
const MEASURED_S: u32 = 60;

/// One lane all around, in two halves that follow one another.
fn ring() -> Result<RoadNetwork, NetworkError> {
    let half = |begin: f64| {
        let point = move |i: u32| {
            let (sin, cos) = sin_cos(begin + PI * f64::from(i) / 180.0);
            DVec3::new(RADIUS_M * cos, RADIUS_M * sin, 0.0)
        };
        Polyline::new((0..=180).map(point))
    };
    let lane = |id: u32, begin: f64, next: u32| Lane {
        successors: vec![LaneId(next)],
        ..Lane::new(LaneId(id), half(begin), WIDTH_M, LIMIT_MPS)
    };
    RoadNetwork { lanes: vec![lane(0, 0.0, 1), lane(1, PI, 0)], ..RoadNetwork::default() }.finish()
}

/// Cars, and a few lorries.
fn models() -> [VehicleSpec; 2] {
    let lorry = VehicleSpec {
        name: "truck.box",
        class: ObjectClass::Truck,
        length_m: 8.0,
        width_m: 2.4,
        height_m: 3.2,
        front_axle_m: 2.8,
        rear_axle_m: -1.9,
        cruise_mps: 12.0,
        acceleration_mps2: 1.1,
        frequency: 0.1,
        parks: false,
        ..VehicleSpec::default()
    };
    [VehicleSpec::default(), lorry]
}

fn main() -> Result<(), Box<dyn Error>> {
    let network = ring()?;
    let models = models();
    let fleet = Fleet { vehicles: &models, pedestrian: &|_| PedestrianSpec::default() };
    let length_km = TAU * RADIUS_M / 1000.0;
    println!("{length_km:.2} km of one lane, limit {:.0} km/h", 3.6 * LIMIT_MPS);
    println!("vehicles  density 1/km  speed km/h  flow 1/h  standing");
    for vehicles in [2, 5, 10, 15, 20, 25, 30, 40] {
        let settings = TrafficSettings { vehicles, pedestrians: 0, seed: 1, fps: FPS, ..TrafficSettings::default() };
        let mut simulation = Simulation::new(&network, &fleet, &[], &settings)?;
        let spawned = simulation.population().vehicles_spawned;
        let (mut sum_mps, mut standing, mut seen) = (0.0, 0, 0);
        for _ in 0..MEASURED_S * FPS as u32 {
            simulation.tick();
            for actor in simulation.state().actors {
                let Motion::Vehicle(motion) = actor.motion else { continue };
                sum_mps += f64::from(motion.speed_mps);
                standing += u32::from(motion.speed_mps < 0.5);
                seen += 1;
            }
        }
        let (speed_kmh, density) = (3.6 * sum_mps / f64::from(seen), f64::from(spawned) / length_km);
        println!(
            "{spawned:8}  {density:12.1}  {speed_kmh:10.1}  {:8.0}  {:7.0}%",
            density * speed_kmh,
            100.0 * f64::from(standing) / f64::from(seen),
        );
    }
    Ok(())
}
