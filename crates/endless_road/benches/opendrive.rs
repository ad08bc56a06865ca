//! Reading OpenDRIVE files: a crossroads with every element, and streets in a grid.

#[path = "../tests/it/grid/mod.rs"]
mod grid;

use divan::counter::BytesCount;
use endless_road::{RoadMap, opendrive};
use grid::Grid;

fn main() {
    divan::main();
}

fn read(bencher: divan::Bencher<'_, '_>, text: &str) {
    let lanes = |text| opendrive::read(text).map(|map| map.network.lanes.len());
    bencher.counter(BytesCount::of_str(text)).bench(|| lanes(divan::black_box(text)).expect("a map"));
}

#[divan::bench]
fn crossroads(bencher: divan::Bencher<'_, '_>) {
    read(bencher, include_str!("../tests/data/crossroads.xodr"));
}

/// By streets in either direction.
#[divan::bench(args = [2, 4, 8], sample_count = 10)]
fn streets_in_a_grid(bencher: divan::Bencher<'_, '_>, streets: usize) {
    let network = Grid { columns: streets, rows: streets, lanes: 2 }.network();
    read(bencher, &opendrive::write(&RoadMap { network, ..RoadMap::default() }, "grid"));
}
