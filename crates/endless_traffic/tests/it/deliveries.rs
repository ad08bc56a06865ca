//! Vans that stand in the lane to deliver.

use crate::bus_stops::{ring, ring_of};
use crate::watch;
use endless_road::RoadNetwork;
use endless_traffic::{TrafficAudit, TrafficSettings};
use endless_world::{Actor, Motion, ObjectClass, VehicleLights};
use std::collections::BTreeMap;

const FPS: f64 = 30.0;

/// For how long vans stood with hazard lights, seconds, and how far right of the lane's middle, metres; the audit must be
/// content.
fn stands(network: &RoadNetwork, deliveries: f64) -> Vec<(f64, f64)> {
    let specs = watch::specs();
    let first = vec![ObjectClass::Van; 8];
    let settings =
        TrafficSettings { vehicles: 30, pedestrians: 0, seed: 4, fps: FPS, first, deliveries, ..Default::default() };
    let mut simulation = watch::simulation(network, &specs, &settings);
    let mut audit = TrafficAudit::new(network, &specs, &[], FPS);
    let both = VehicleLights::LEFT_BLINKER | VehicleLights::RIGHT_BLINKER;
    // Seconds, right of the middle, whether hazard lights were seen.
    let mut current: BTreeMap<u16, (f64, f64, bool)> = BTreeMap::new();
    let mut done = Vec::new();
    for _ in 0..(900.0 * FPS) as usize {
        simulation.tick();
        let state = simulation.state();
        audit.look(&state);
        for van in state.actors.iter().filter(|actor| actor.class == ObjectClass::Van) {
            let Motion::Vehicle(motion) = van.motion else { continue };
            let entry = current.entry(van.id.0).or_default();
            if motion.speed_mps < 0.03 {
                *entry = (entry.0 + 1.0 / FPS, right_m(network, van), entry.2 || motion.lights.contains(both));
            } else {
                let (seconds, right_m, warned) = std::mem::take(entry);
                if warned {
                    done.push((seconds, right_m));
                }
            }
        }
    }
    let report = audit.report();
    assert!(report.passed(), "{report}");
    done
}

fn right_m(network: &RoadNetwork, van: &Actor) -> f64 {
    let lane = &network.lanes[van.behaviour.lane.expect("it drives").lane as usize];
    -lane.centerline.project(van.pose.position.as_dvec3().truncate()).1
}

#[test]
fn vans_deliver_at_the_kerb_with_hazard_lights_while_others_pass() {
    let stands = stands(&ring(), 1.0);
    assert!(stands.len() > 3, "{} stands", stands.len());
    for (seconds, right_m) in stands {
        assert!((60.0..115.0).contains(&seconds), "{seconds:.0} s");
        assert!((0.5..0.72).contains(&right_m), "{right_m:.2} m");
    }
}

#[test]
fn nobody_delivers_where_others_could_not_pass_or_nobody_is_asked_to() {
    assert!(stands(&ring_of(false), 1.0).is_empty());
    assert!(stands(&ring(), 0.0).is_empty());
}
