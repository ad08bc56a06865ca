//! People who cross roads away from crossings.

use crate::watch::watch;
use endless_asset::Catalogue;
use endless_traffic::{AuditReport, Fleet, Simulation, TrafficSettings};
use endless_world::Behaviour;

const FPS: f64 = 30.0;

/// What happens in a town, and how many times somebody set out to cross away from crossings.
fn seen(name: &str, jaywalking: f64, seconds: f64) -> (AuditReport, usize) {
    let catalogue = Catalogue::builtin();
    let town = endless_town::load(name, &catalogue).expect("a town");
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let settings =
        TrafficSettings { vehicles: 40, pedestrians: 60, seed: 1, fps: FPS, jaywalking, ..TrafficSettings::default() };
    let traffic = Simulation::new(&town.network, &fleet, &town.parked, &settings).expect("few enough");
    let report = watch(&mut traffic.clone(), &town.network, &specs, seconds, FPS);
    let (mut traffic, mut before, mut crossings) = (traffic, Vec::new(), 0);
    for _ in 0..(seconds * FPS) as u32 {
        traffic.tick();
        let now: Vec<Behaviour> = traffic.state().actors.iter().map(|actor| actor.behaviour).collect();
        let begins = |(is, was): &(&Behaviour, &Behaviour)| is.jaywalking && !was.jaywalking;
        crossings += now.iter().zip(&before).filter(begins).count();
        before = now;
    }
    (report, crossings)
}

#[test]
fn people_cross_in_gaps_and_nobody_is_hit() {
    for name in ["Town02", "Town10HD", "Ladera"] {
        let (report, crossings) = seen(name, 1.0, 240.0);
        assert!(report.passed(), "{name}: {report}");
        assert!(crossings > 20, "{name}: {crossings}");
    }
}

#[test]
fn the_more_do_it_the_more_often_it_happens() {
    let [none, few, many] = [0.0, 0.25, 1.0].map(|share| seen("Town02", share, 120.0).1);
    assert!(none == 0 && few > 0 && many > 2 * few, "{none} {few} {many}");
}
