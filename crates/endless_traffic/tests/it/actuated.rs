//! Signals that follow traffic.

use crate::grid::Grid;
use crate::watch;
use endless_traffic::{Simulation, TrafficSettings};
use endless_world::{SignalControl, TrafficProfile};

const FPS: f64 = 30.0;

fn traffic(grid: &Grid, [vehicles, pedestrians]: [u32; 2], signals: SignalControl) -> Simulation {
    let profile = TrafficProfile { signals, ..TrafficProfile::default() };
    let settings = TrafficSettings { vehicles, pedestrians, seed: 5, fps: FPS, profile, ..TrafficSettings::default() };
    watch::simulation(&grid.network(), &watch::specs(), &settings)
}

#[test]
fn nobody_touches_and_nobody_runs_a_light_that_follows_traffic() {
    let grid = Grid { columns: 3, rows: 3, lanes: 2 };
    let mut simulation = traffic(&grid, [60, 60], SignalControl::Actuated);
    let report = watch::watch(&mut simulation, &grid.network(), &watch::specs(), 300.0, FPS);
    assert!(report.passed(), "{report}");
}

/// Where few drive, nobody waits for those who are not there.
#[test]
fn few_vehicles_get_on_faster_than_with_fixed_plans() {
    let grid = Grid { columns: 3, rows: 3, lanes: 1 };
    let driven_m = |signals| {
        let mut simulation = traffic(&grid, [12, 0], signals);
        watch::watch(&mut simulation, &grid.network(), &watch::specs(), 600.0, FPS).driven_m
    };
    let [fixed_m, actuated_m] = [SignalControl::Fixed, SignalControl::Actuated].map(driven_m);
    assert!(actuated_m > fixed_m, "{actuated_m:.0} m with signals that follow them, {fixed_m:.0} m without");
}

#[test]
fn the_same_seed_gives_the_same_states() {
    let grid = Grid { columns: 2, rows: 3, lanes: 1 };
    let run = || {
        let mut simulation = traffic(&grid, [30, 20], SignalControl::Actuated);
        (0..600).for_each(|_| simulation.tick());
        simulation.state()
    };
    assert_eq!(run(), run());
}
