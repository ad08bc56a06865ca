//! How riders of two-wheelers pass queues at red lights: `cargo run --release -p endless_traffic --example filtering -- MAP
//! [region] [seconds] [vehicles] [people] [seed]`. Prints how often somebody passed a vehicle that stood or crawled, how far
//! beside it and how fast, how many two-wheelers stood beside or before the first car at a line, and the audit of all traffic.
#![expect(clippy::print_stdout, reason = "a report on standard output")]

use endless_asset::Catalogue;
use endless_traffic::{Fleet, Simulation, TrafficAudit, TrafficSettings, USUAL_DELIVERIES};
use endless_world::math::f64::sin_cos;
use endless_world::{Actor, Motion, Region, TrafficProfile, VehicleSpec};
use glam::{DVec2, Vec2};
use std::{collections::BTreeMap, error::Error, process::ExitCode, time::Instant};

const FPS: f64 = 30.0;
/// Who is passed is slower than this, m/s, and the one who passes is this much faster.
const CRAWLS_MPS: f32 = 2.0;
const FASTER_MPS: f32 = 0.5;
/// Who passes does so within this beside the middle of the other, metres.
const BESIDE_M: f32 = 2.2;
/// Bodies further apart are not asked for, metres.
const NEAR_M: f32 = 8.0;

/// Unit vector ahead.
fn heading(actor: &Actor) -> Vec2 {
    let (sin, cos) = sin_cos(f64::from(actor.pose.yaw_rad));
    Vec2::new(cos as f32, sin as f32)
}

fn speed_mps(actor: &Actor) -> Option<f32> {
    match actor.motion {
        Motion::Vehicle(motion) => Some(motion.speed_mps),
        Motion::Walker(_) => None,
    }
}

fn width_m(actor: &Actor, specs: &[VehicleSpec]) -> f32 {
    actor.asset.vehicle().map_or(0.0, |vehicle| specs[vehicle.model.index()].width_m)
}

/// What was seen of those who pass.
#[derive(Debug, Default)]
struct Passed {
    number: u32,
    least_clear_m: Option<f32>,
    fastest_mps: f32,
    /// How far ahead of each vehicle each two-wheeler beside it was.
    ahead: BTreeMap<(u16, u16), f32>,
}

impl Passed {
    fn look(&mut self, actors: &[Actor], specs: &[VehicleSpec]) {
        let mut now = BTreeMap::new();
        for rider in actors.iter().filter(|actor| actor.class.two_wheeled()) {
            let Some(speed) = speed_mps(rider) else { continue };
            for other in actors.iter().filter(|other| other.id != rider.id) {
                let Some(theirs) = speed_mps(other).filter(|_| !other.class.two_wheeled() && !other.parked) else {
                    continue;
                };
                if other.pose.position.distance(rider.pose.position) > NEAR_M {
                    continue;
                }
                let (ahead, away) = (heading(other), (rider.pose.position - other.pose.position).truncate());
                let (x, y, along) = (away.dot(ahead), ahead.perp_dot(away), rider.velocity_mps.truncate().dot(ahead));
                if y.abs() > BESIDE_M || along < 0.0 {
                    continue;
                }
                let pair = (rider.id.0, other.id.0);
                let passes = theirs < CRAWLS_MPS && speed > theirs + FASTER_MPS;
                if self.ahead.get(&pair).is_some_and(|before| *before < 0.0) && x >= 0.0 && passes {
                    self.number += 1;
                    let clear = y.abs() - 0.5 * (width_m(rider, specs) + width_m(other, specs));
                    self.least_clear_m = Some(self.least_clear_m.map_or(clear, |least| least.min(clear)));
                    self.fastest_mps = self.fastest_mps.max(speed - theirs);
                }
                now.insert(pair, x);
            }
        }
        self.ahead = now;
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let name = args.first().ok_or("usage: filtering MAP [region] [seconds] [vehicles] [people] [seed]")?;
    let region: Region = args.get(1).map_or(Ok(Region::LatinAmerican), |word| word.parse())?;
    let number = |i: usize, usual: u32| args.get(i).map_or(Ok(usual), |a| a.parse::<u32>());
    let (seconds, vehicles, pedestrians) = (number(2, 900)?, number(3, 100)?, number(4, 60)?);
    let seed = u64::from(number(5, 1)?);
    let catalogue = Catalogue::builtin();
    let town = endless_town::load(name, &catalogue)?;
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let profile = TrafficProfile { region, ..TrafficProfile::default() };
    let bus_stops = town.bus_stops();
    let settings = TrafficSettings {
        vehicles,
        pedestrians,
        seed,
        fps: FPS,
        profile,
        bus_stops,
        deliveries: USUAL_DELIVERIES,
        ..TrafficSettings::default()
    };
    let mut traffic = Simulation::new(&town.network, &fleet, &town.parked, &settings)?;
    let mut audit = TrafficAudit::new(&town.network, &specs, traffic.parked(), FPS);
    let mut passed = Passed::default();
    let (mut digest, mut simulated_s) = (DVec2::ZERO, 0.0);
    for frame in 0..seconds * FPS as u32 {
        let begin = Instant::now();
        traffic.tick();
        simulated_s += begin.elapsed().as_secs_f64();
        let state = traffic.state();
        audit.look(&state);
        passed.look(&state.actors, &specs);
        let positions = state.actors.iter().map(|actor| actor.pose.position.as_dvec3().truncate());
        digest += positions.sum::<DVec2>() * f64::from(frame + 1);
    }
    let report = audit.report();
    println!("{report}");
    let Passed { number, least_clear_m, fastest_mps, .. } = passed;
    println!(
        "{name}, {region}: {number} passed in {seconds} s, {:.2} m beside at least, {fastest_mps:.1} m/s faster at most; \
         {:.0} times real time, digest {digest}",
        least_clear_m.unwrap_or(f32::NAN),
        f64::from(seconds) / simulated_s,
    );
    Ok(if report.passed() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
