//! Rates of tracing a frame's primary, sun and diffuse rays in a built-in town, on one thread:
//! `cargo bench -p endless_city --bench traversal`.

mod town;

#[path = "town/baseline.rs"]
mod baseline;

use std::sync::LazyLock;

use baseline::Baseline;
use divan::Bencher;
use divan::counter::ItemsCount;
use endless_render::Ray;
use obvhs::bvh2::Bvh2;
use obvhs::cwbvh::CwBvh;
use town::{BenchTown, Packet};

static TOWN: LazyLock<BenchTown> = LazyLock::new(|| BenchTown::new("Town02"));
static CWBVH: LazyLock<Baseline<CwBvh>> = LazyLock::new(|| Baseline::new(&TOWN));
static BVH2: LazyLock<Baseline<Bvh2>> = LazyLock::new(|| Baseline::new(&TOWN));

/// Every 16th tile of the frame, by kind of ray.
static RAYS: LazyLock<[Vec<Packet>; 4]> =
    LazyLock::new(|| TOWN.rays().map(|set| set.chunks(8).step_by(16).flatten().copied().collect()));

const PRIMARY: usize = 0;
const SUN: usize = 1;
const DIFFUSE: usize = 2;

fn main() {
    divan::main();
}

fn packets(bencher: Bencher<'_, '_>, kind: usize, trace: impl Fn(&[Ray; 8], u8) -> u32 + Sync) {
    let rays = &RAYS[kind];
    let count: u32 = rays.iter().map(|(_, active)| active.count_ones()).sum();
    bencher
        .counter(ItemsCount::new(count))
        .bench(|| rays.iter().map(|(rays, active)| trace(rays, *active)).sum::<u32>());
}

fn singles(bencher: Bencher<'_, '_>, kind: usize, hit: impl Fn(&Ray) -> bool + Sync) {
    packets(bencher, kind, |rays, active| {
        (0..8).filter(|&lane| active >> lane & 1 != 0 && hit(&rays[lane])).count() as u32
    });
}

#[divan::bench(args = [PRIMARY, DIFFUSE])]
fn closest(bencher: Bencher<'_, '_>, kind: usize) {
    singles(bencher, kind, |ray| TOWN.accel.closest(ray).is_some());
}

#[divan::bench(args = [PRIMARY, DIFFUSE])]
fn closest8(bencher: Bencher<'_, '_>, kind: usize) {
    packets(bencher, kind, |rays, active| TOWN.accel.closest8(rays, active).iter().flatten().count() as u32);
}

#[divan::bench(args = [PRIMARY, DIFFUSE])]
fn closest_cwbvh(bencher: Bencher<'_, '_>, kind: usize) {
    singles(bencher, kind, |ray| CWBVH.closest(ray).is_some());
}

#[divan::bench(args = [PRIMARY, DIFFUSE])]
fn closest_bvh2(bencher: Bencher<'_, '_>, kind: usize) {
    singles(bencher, kind, |ray| BVH2.closest(ray).is_some());
}

#[divan::bench]
fn occluded(bencher: Bencher<'_, '_>) {
    singles(bencher, SUN, |ray| TOWN.accel.occluded(ray));
}

#[divan::bench]
fn occluded8(bencher: Bencher<'_, '_>) {
    packets(bencher, SUN, |rays, active| TOWN.accel.occluded8(rays, active).count_ones());
}

#[divan::bench]
fn occluded_cwbvh(bencher: Bencher<'_, '_>) {
    singles(bencher, SUN, |ray| CWBVH.occluded(ray));
}

#[divan::bench]
fn occluded_bvh2(bencher: Bencher<'_, '_>) {
    singles(bencher, SUN, |ray| BVH2.occluded(ray));
}

/// The top level over everything that moves in a busy street.
#[divan::bench(args = [100, 600])]
fn build_top_level(bencher: Bencher<'_, '_>, count: usize) {
    let last = TOWN.instances.len() - count;
    bencher.with_inputs(|| town::placed(&TOWN.blas, &TOWN.instances[last..])).bench_values(endless_render::Tlas::build);
}
