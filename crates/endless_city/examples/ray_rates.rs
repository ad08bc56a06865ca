//! Prints rates of tracing in the built-in towns, or those that are named, own traversal beside that of `obvhs`:
//! `cargo run --release -p endless_city --example ray_rates -- [Town03 …]`.
#![expect(clippy::print_stdout, reason = "a table is what it is for")]

#[path = "../benches/town/baseline.rs"]
mod baseline;
#[path = "../benches/town/mod.rs"]
mod town;

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use baseline::Baseline;
use endless_render::{Ray, RayStream};
use obvhs::cwbvh::CwBvh;
use town::{BenchTown, Packet};

const THREADS: usize = 2;
const ROUNDS: usize = 7;

/// The sets of rays.
const SETS: [&str; 4] = ["primary", "sun", "diffuse", "scattered"];

/// Time this thread has run, so that other work on the machine does not count; wall time where the system does not
/// tell.
struct Clock(Instant, Option<usize>);

impl Clock {
    fn start() -> Self {
        Clock(Instant::now(), Self::busy())
    }

    fn busy() -> Option<usize> {
        std::fs::read_to_string("/proc/thread-self/schedstat").ok()?.split_whitespace().next()?.parse().ok()
    }

    fn nanoseconds(&self) -> usize {
        match (self.1, Self::busy()) {
            (Some(before), Some(now)) => now - before,
            _ => self.0.elapsed().as_nanos() as usize,
        }
    }
}

/// Traces all packets with all threads: seconds, and how many rays hit.
fn pass<R: Sync, M: Copy + Sync>(packets: &[(R, M)], trace: impl Fn(&R, M) -> u32 + Sync) -> (f64, usize) {
    const CHUNK: usize = 512;
    let (next, found, busy) = (AtomicUsize::new(0), AtomicUsize::new(0), AtomicUsize::new(0));
    std::thread::scope(|scope| {
        for _ in 0..THREADS {
            scope.spawn(|| {
                let clock = Clock::start();
                let mut sum = 0;
                while let Some(chunk) = packets.chunks(CHUNK).nth(next.fetch_add(1, Ordering::Relaxed)) {
                    sum += chunk.iter().map(|(rays, active)| trace(rays, *active) as usize).sum::<usize>();
                }
                found.fetch_add(sum, Ordering::Relaxed);
                busy.fetch_add(clock.nanoseconds(), Ordering::Relaxed);
            });
        }
    });
    (busy.into_inner() as f64 * 1e-9 / THREADS as f64, found.into_inner())
}

/// The same rays, four packets together.
fn bundles(packets: &[Packet]) -> Vec<(RayStream<4>, u32)> {
    let bundle = |four: &[Packet]| {
        let of = |i: usize| four.get(i).unwrap_or(&four[0]);
        let active = four.iter().enumerate().map(|(i, (_, active))| u32::from(*active) << (8 * i)).sum();
        (RayStream::of(&std::array::from_fn(|i| of(i).0)), active)
    };
    packets.chunks(4).map(bundle).collect()
}

fn each(active: u8, rays: &[Ray; 8], hit: impl Fn(&Ray) -> bool) -> u32 {
    (0..8).filter(|&lane| active >> lane & 1 != 0 && hit(&rays[lane])).count() as u32
}

/// A way to trace one of the sets.
type Trace<'a> = &'a dyn Fn(usize) -> (f64, usize);

/// Prints the rates of one town; returns how many times as fast as CWBVH the better of packets and bundles is.
fn measure(town: &BenchTown) -> [f64; 4] {
    let sets = town.rays();
    let (accel, bundled) = (&town.accel, sets.each_ref().map(|set| bundles(set)));
    let cw = Baseline::<CwBvh>::new(town);
    const SUN: usize = 1;
    let single = |set: usize| match set {
        SUN => pass(&sets[set], |r, m| each(m, r, |ray| accel.occluded(ray))),
        _ => pass(&sets[set], |r, m| each(m, r, |ray| accel.closest(ray).is_some())),
    };
    let by_packets = |set: usize| match set {
        SUN => pass(&sets[set], |r, m| accel.occluded8(r, m).count_ones()),
        _ => pass(&sets[set], |r, m| accel.closest8(r, m).iter().flatten().count() as u32),
    };
    let by_bundles = |set: usize| match set {
        SUN => pass(&bundled[set], |r, m| accel.occluded32(r, m).count_ones()),
        _ => pass(&bundled[set], |r, m| {
            let hits = accel.closest32(r, m);
            (0..32).filter(|&lane| hits.get(lane).is_some()).count() as u32
        }),
    };
    let cwbvh = |set: usize| match set {
        SUN => pass(&sets[set], |r, m| each(m, r, |ray| cw.occluded(ray))),
        _ => pass(&sets[set], |r, m| each(m, r, |ray| cw.closest(ray).is_some())),
    };
    let ways: [(&str, Trace<'_>); 4] = [
        ("obvhs CWBVH", &cwbvh),
        ("own, single", &single),
        ("own, packets", &by_packets),
        ("own, bundles", &by_bundles),
    ];
    // All ways in turn, again and again: a machine's slow minutes then fall on all of them.
    let mut best = [[(f64::INFINITY, 0); 4]; 4];
    for _ in 0..ROUNDS {
        for (best, (_, pass)) in best.iter_mut().zip(&ways) {
            for (set, best) in best.iter_mut().enumerate() {
                let (seconds, hits) = pass(set);
                *best = (best.0.min(seconds), hits);
            }
        }
    }
    let rays = sets.each_ref().map(|set| set.iter().map(|(_, active)| active.count_ones()).sum::<u32>());
    let rates = best.map(|best| std::array::from_fn::<f64, 4, _>(|set| f64::from(rays[set]) / best[set].0 / 1e6));
    for ((name, _), (rates, best)) in ways.iter().zip(rates.iter().zip(&best)) {
        let columns = (0..4).map(|set| format!("{:20}", format!("{:6.2} ({} hit)", rates[set], best[set].1)));
        println!("{name:14} {}", columns.collect::<String>());
    }
    let ratios = std::array::from_fn(|set| rates[2][set].max(rates[3][set]) / rates[0][set]);
    print_ratios("times CWBVH", &ratios);
    ratios
}

fn print_ratios(name: &str, ratios: &[f64; 4]) {
    let columns = SETS.iter().zip(ratios).map(|(set, ratio)| format!("{:20}", format!("{ratio:6.2} {set}")));
    println!("{name:14} {}", columns.collect::<String>());
}

fn main() {
    let mut names: Vec<String> = std::env::args().skip(1).collect();
    if names.is_empty() {
        names = endless_town::NAMES.iter().map(ToString::to_string).collect();
    }
    let mut all = Vec::new();
    for name in &names {
        let start = Instant::now();
        let town = BenchTown::new(name);
        let unique: usize = town.meshes.iter().map(|m| m.triangles.len()).sum();
        let bytes: usize = town.blas.iter().map(|b| b.memory_bytes()).sum();
        println!(
            "{name}, built in {:.1} s: {} instances, {unique} own triangles at {:.0} B, {} instanced; top level {:.1} MB",
            start.elapsed().as_secs_f64(),
            town.instances.len(),
            bytes as f64 / unique as f64,
            town.instances.iter().map(|(m, _)| town.meshes[*m].triangles.len()).sum::<usize>(),
            town.accel.memory_bytes() as f64 / 1e6
        );
        println!("{:14} {}   Mrays/s", "", SETS.map(|set| format!("{set:20}")).join(""));
        all.push(measure(&town));
    }
    let mean = |set: usize| all.iter().map(|ratios: &[f64; 4]| ratios[set]).sum::<f64>() / all.len() as f64;
    print_ratios("mean of all", &std::array::from_fn(mean));
}
