//! What is driven and how, as a profile asks for it.

use crate::grid::Grid;
use crate::watch::{pedestrian, specs};
use endless_asset::Catalogue;
use endless_traffic::{AuditReport, Fleet, Simulation, TrafficAudit, TrafficSettings};
use endless_world::{Region, TrafficProfile};

const SECONDS: u32 = 120;

fn drive(vehicles: u32, seed: u64, profile: TrafficProfile) -> AuditReport {
    let (specs, network) = (specs(), Grid { columns: 3, rows: 3, lanes: 2 }.network());
    let settings =
        TrafficSettings { vehicles, pedestrians: 30, seed, fps: 30.0, profile, ..TrafficSettings::default() };
    let fleet = Fleet { vehicles: &specs, pedestrian: &pedestrian };
    let mut simulation = Simulation::new(&network, &fleet, &[], &settings).expect("few enough");
    let audit = TrafficAudit::new(&network, &specs, simulation.parked(), settings.fps);
    let mut audit = audit.with_aggressiveness(profile.aggressiveness);
    for _ in 0..SECONDS * 30 {
        audit.look(&simulation.state());
        simulation.tick();
    }
    audit.report()
}

#[test]
fn bold_drivers_get_further_and_touch_nobody() {
    let driven_m = |aggressiveness| {
        let profile = TrafficProfile { aggressiveness, ..TrafficProfile::default() };
        let driven_m = |seed| {
            let report = drive(16, seed, profile);
            assert!(report.passed(), "{report}");
            report.driven_m
        };
        (3..7).map(driven_m).sum::<f64>()
    };
    let [cautious, usual, bold] = [0.0, 0.5, 1.0].map(driven_m);
    assert!(cautious < 0.97 * usual && bold > 1.03 * usual, "{cautious} {usual} {bold} m");
}

#[test]
fn regions_have_other_vehicles() {
    let catalogue = Catalogue::builtin();
    let town = endless_town::load("Town05", &catalogue).expect("a town");
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let two_wheelers = |profile| {
        let settings = TrafficSettings { vehicles: 150, pedestrians: 0, profile, ..TrafficSettings::default() };
        let simulation = Simulation::new(&town.network, &fleet, &town.parked, &settings).expect("few enough");
        let state = simulation.state();
        let count = state.actors.iter().filter(|actor| actor.class.two_wheeled()).count();
        count as f64 / state.actors.len() as f64
    };
    let region = |region| TrafficProfile { region, ..TrafficProfile::default() };
    let europe = two_wheelers(region(Region::European));
    assert!(two_wheelers(region(Region::NorthAmerican)) < 0.5 * europe);
    assert!((0.5..0.75).contains(&two_wheelers(region(Region::SouthEastAsian))));
    let half = TrafficProfile { two_wheelers: Some(0.5), ..TrafficProfile::default() };
    assert!((0.4..0.6).contains(&two_wheelers(half)));
}
