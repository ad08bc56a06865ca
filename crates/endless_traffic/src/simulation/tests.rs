use crate::vehicle::RightOfWay;
use crate::{Fleet, Simulation, TrafficSettings};
use endless_asset::Catalogue;

/// Somebody behind who went first would wait for those ahead, and those ahead for somebody who waits for them.
#[test]
fn those_ahead_on_an_approach_go_first() {
    let catalogue = Catalogue::builtin();
    let town = endless_town::load("Town03", &catalogue).expect("a town");
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let settings = TrafficSettings { vehicles: 500, pedestrians: 100, seed: 1, ..TrafficSettings::default() };
    let mut simulation = Simulation::new(&town.network, &fleet, &town.parked, &settings).expect("few enough");
    let mut pairs = 0;
    for _ in 0..1200 {
        simulation.tick();
        let vehicles = &simulation.vehicles;
        for behind in vehicles {
            for mine in behind.rights_of_way.iter().filter(|g| !g.entered) {
                let waits_ahead = |theirs: &RightOfWay| theirs.junction == mine.junction && theirs.order > mine.order;
                let ahead = vehicles.iter().filter(|v| v.lane() == behind.lane() && v.s > behind.s);
                pairs += ahead.clone().count();
                let mut late = ahead.flat_map(|v| &v.rights_of_way).filter(|theirs| waits_ahead(theirs));
                assert!(late.next().is_none(), "at {:.1} s", simulation.time_s);
            }
        }
    }
    assert!(pairs > 100, "{pairs}");
}
