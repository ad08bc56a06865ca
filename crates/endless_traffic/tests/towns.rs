//! The same traffic in the towns.

mod watch;

use endless_asset::{Catalogue, VehicleSpec};
use endless_traffic::{Conditions, Simulation};

const FPS: f64 = 30.0;

#[test]
fn every_town_flows_without_a_touch() {
    let own = watch::specs();
    let catalogue = Catalogue::builtin();
    let specs: Vec<&VehicleSpec> = match catalogue.vehicles() {
        [] => own.iter().collect(),
        models => models.iter().map(|m| &m.spec).collect(),
    };
    let mut faults = Vec::new();
    for name in endless_town::NAMES {
        let town = endless_town::load(name, &catalogue).expect("a town");
        let parked: Vec<_> = town.parked.iter().map(|p| (p.asset, p.pose)).collect();
        let pace = |_| 1.35;
        let asked = [100, 60];
        let begin = std::time::Instant::now();
        let mut s =
            Simulation::on_network(&town.network, &specs, &parked, &pace, asked, 11, Conditions::default(), FPS);
        let simulated_s = 120.0;
        let f = watch::watch(&mut s, &specs, simulated_s, FPS);
        let p = s.population();
        println!("{name}: {p:?} wall {:.1} s\n  {f:?}", begin.elapsed().as_secs_f64());
        let driven = f.driven_m / f64::from(p.vehicles_spawned) / simulated_s;
        let walked = f.walked_m / f64::from(p.pedestrians_spawned) / simulated_s;
        println!("  driven {driven:.2} m/s walked {walked:.2} m/s");
        let sound = f.overlaps.is_empty() && f.walker_hits.is_empty() && f.touching_walkers == 0 && f.jumps.is_empty();
        let smooth = f.worst_slip_mps < 0.35 && f.worst_acceleration < 8.0 && f.worst_yaw_rate < 2.0;
        let lively = driven > 1.2 && walked > 0.6 && f.longest_stand.0 < 110.0;
        if !(sound && smooth && lively) {
            faults.push(*name);
        }
    }
    assert!(faults.is_empty(), "{faults:?}");
}
