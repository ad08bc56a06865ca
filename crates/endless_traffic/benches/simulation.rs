//! A simulated second of streets in a grid, with as many vehicles and people as they hold well.

#[path = "../../endless_road/tests/it/grid/mod.rs"]
mod grid;

use divan::counter::ItemsCount;
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::VehicleSpec;
use endless_world::walking::PedestrianSpec;
use grid::Grid;

fn main() {
    divan::main();
}

/// By streets in either direction; items are the vehicles and people that are moved.
#[divan::bench(args = [2, 3, 4, 6], sample_count = 10)]
fn a_second(bencher: divan::Bencher<'_, '_>, streets: usize) {
    let network = Grid { columns: streets, rows: streets, lanes: 2 }.network();
    let number = 6 * (streets * streets) as u32;
    let settings = TrafficSettings { vehicles: number, pedestrians: number, seed: 1, ..TrafficSettings::default() };
    let cars = [VehicleSpec::default()];
    let fleet = Fleet { vehicles: &cars, pedestrian: &|_| PedestrianSpec::default() };
    let simulation = Simulation::new(&network, &fleet, &[], &settings).expect("sound settings");
    let moved = simulation.state().actors.len();
    bencher.counter(ItemsCount::new(moved)).with_inputs(|| simulation.clone()).bench_values(|mut simulation| {
        for _ in 0..settings.fps as u32 {
            simulation.tick();
        }
        simulation.state()
    });
}
