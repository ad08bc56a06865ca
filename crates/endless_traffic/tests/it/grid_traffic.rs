//! Traffic on a grid of test streets.

use crate::grid::Grid;
use crate::watch::specs;
use endless_traffic::{AuditReport, TrafficSettings};

const FPS: f64 = 30.0;

fn settings([vehicles, pedestrians]: [u32; 2], seed: u64, fps: f64) -> TrafficSettings {
    TrafficSettings { vehicles, pedestrians, seed, fps, ..TrafficSettings::default() }
}

fn simulate(grid: &Grid, asked: [u32; 2], seed: u64, seconds: f64) -> AuditReport {
    let specs = specs();
    let network = grid.network();
    let mut s = crate::watch::simulation(&network, &specs, &settings(asked, seed, FPS));
    let population = s.population();
    assert_eq!(population.vehicles_spawned, asked[0]);
    assert_eq!(population.pedestrians_spawned, asked[1]);
    crate::watch::watch(&mut s, &network, &specs, seconds, FPS)
}

fn check(f: &AuditReport, asked: [u32; 2], seconds: f64) {
    assert!(f.passed(), "{f}");
    assert!(f.driven_m / f64::from(asked[0]) / seconds > 1.5, "traffic stands: {} m", f.driven_m);
    assert!(f.walked_m / f64::from(asked[1]) / seconds > 0.6, "people stand: {} m", f.walked_m);
}

#[test]
fn two_lane_streets_flow_without_a_touch() {
    for seed in 0..3 {
        let f = simulate(&Grid { columns: 3, rows: 3, lanes: 2 }, [60, 60], seed, 120.0);
        check(&f, [60, 60], 120.0);
    }
}

#[test]
fn narrow_streets_flow_without_a_touch() {
    for seed in 0..3 {
        let f = simulate(&Grid { columns: 4, rows: 4, lanes: 1 }, [70, 60], seed, 120.0);
        check(&f, [70, 60], 120.0);
    }
}

#[test]
fn a_hundred_vehicles_flow_for_ten_minutes() {
    let f = simulate(&Grid { columns: 4, rows: 4, lanes: 2 }, [100, 60], 7, 600.0);
    check(&f, [100, 60], 600.0);
}

#[test]
fn the_same_seed_gives_the_same_states() {
    let specs = specs();
    let network = Grid { columns: 3, rows: 3, lanes: 2 }.network();
    let run = |seed| {
        let mut s = crate::watch::simulation(&network, &specs, &settings([30, 20], seed, 25.0));
        for _ in 0..200 {
            s.tick();
        }
        s.state()
    };
    assert_eq!(run(5), run(5));
    assert_ne!(run(5), run(6));
}

#[test]
fn as_many_as_fit_are_spawned_and_the_rest_is_reported() {
    let specs = specs();
    let network = Grid { columns: 2, rows: 2, lanes: 1 }.network();
    let s = crate::watch::simulation(&network, &specs, &settings([1000, 3], 1, 10.0));
    let p = s.population();
    assert_eq!(p.vehicles_asked, 1000);
    assert!(p.vehicles_spawned <= p.vehicle_capacity && 10 * p.vehicles_spawned > 7 * p.vehicle_capacity, "{p:?}");
    assert!(p.vehicle_capacity > 12, "{p:?}");
    let ids: Vec<u16> = s.state().actors.iter().map(|a| a.id.0).collect();
    assert!(ids.windows(2).all(|w| w[0] < w[1]) && ids[0] == 1);
}
