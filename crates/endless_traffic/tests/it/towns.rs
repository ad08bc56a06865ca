//! The same traffic in the towns: every town, crowded, for minutes.

use endless_asset::Catalogue;
use endless_town::Town;
use endless_traffic::{Fleet, Simulation, TrafficAudit, TrafficSettings, USUAL_DELIVERIES};
use endless_world::walking::PedestrianSpec;

const FPS: f64 = 30.0;
const ASKED: [u32; 2] = [100, 60];
const SIMULATED_S: f64 = 240.0;

fn flows_without_a_touch(name: &str) {
    let catalogue = Catalogue::builtin();
    let town = endless_town::load(name, &catalogue).expect("a town");
    for seed in [2, 11] {
        flows(&catalogue, &town, seed);
    }
}

fn flows(catalogue: &Catalogue, town: &Town, seed: u64) {
    let name = &town.name;
    let specs = catalogue.vehicle_specs();
    assert!(!town.parked.is_empty() || name == "Town06", "{name}: nobody parks here");
    let pedestrian = |variant| PedestrianSpec { walk_mps: 1.35, ..Catalogue::pedestrian_spec(variant) };
    let fleet = Fleet { vehicles: &specs, pedestrian: &pedestrian };
    let [vehicles, pedestrians] = ASKED;
    let bus_stops = town.bus_stops();
    let settings = TrafficSettings {
        vehicles,
        pedestrians,
        seed,
        fps: FPS,
        bus_stops,
        bench_seats: town.bench_seats(),
        parking_bays: town.parking_bays.clone(),
        deliveries: USUAL_DELIVERIES,
        ..TrafficSettings::default()
    };
    let mut s = Simulation::new(&town.network, &fleet, &town.parked, &settings).expect("few enough");
    let audit = TrafficAudit::new(&town.network, &specs, s.parked(), FPS);
    let audit = audit.with_bench_seats(&settings.bench_seats).with_parking_bays(&settings.parking_bays);
    let f = crate::watch::watch_by(audit, &mut s, SIMULATED_S, FPS);
    let p = s.population();
    let driven = f.driven_m / f64::from(p.vehicles_spawned) / SIMULATED_S;
    let walked = f.walked_m / f64::from(p.pedestrians_spawned) / SIMULATED_S;
    let what = format!("{name} seed {seed}: {p:?}, driven {driven:.2} m/s, walked {walked:.2} m/s\n{f}");
    assert!(f.passed(), "{what}");
    assert!(driven > 1.2 && walked > 0.6, "no flow: {what}");
}

macro_rules! towns {
    ($($test:ident: $name:literal;)*) => {$(
        #[test]
        fn $test() {
            flows_without_a_touch($name);
        }
    )*};
}

towns! {
    town01_flows_without_a_touch: "Town01";
    town02_flows_without_a_touch: "Town02";
    town03_flows_without_a_touch: "Town03";
    town04_flows_without_a_touch: "Town04";
    town05_flows_without_a_touch: "Town05";
    town06_flows_without_a_touch: "Town06";
    town07_flows_without_a_touch: "Town07";
    town10_flows_without_a_touch: "Town10HD";
    ladera_flows_without_a_touch: "Ladera";
    altstadt_flows_without_a_touch: "Altstadt";
}
