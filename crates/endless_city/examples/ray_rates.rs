//! Prints rates of tracing in the built-in towns, or those that are named, own traversal beside that of `obvhs`:
//! `cargo run --release -p endless_city --example ray_rates -- [--export FOLDER] [Town03 …]`.
//!
//! With `--export` the triangles, rays and rates of each town are written to the folder, for other ray tracers.
#![expect(clippy::print_stdout, reason = "a table is what it is for")]

#[path = "../benches/town/baseline.rs"]
mod baseline;
#[path = "ray_rates/export.rs"]
mod export;
#[path = "../benches/town/mod.rs"]
mod town;

use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use baseline::Baseline;
use endless_render::{Ray, RayStream};
use export::MeasuredSet;
use obvhs::cwbvh::CwBvh;
use town::{BenchTown, Packet};

const THREADS: usize = 2;
const ROUNDS: usize = 7;

/// The sets of rays.
const SETS: [&str; 4] = ["primary", "sun", "diffuse", "scattered"];
/// The set for whose rays any hit is enough.
const SUN: usize = 1;

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

/// What each way made of each set: CWBVH, then single rays, packets and bundles.
struct TownRates {
    /// Million rays a second of all threads.
    rates: [[f64; 4]; 4],
    /// Rays that hit.
    hits: [[usize; 4]; 4],
}

/// Prints the rates of one town.
fn measure(town: &BenchTown, sets: &[Vec<Packet>; 4]) -> TownRates {
    let (accel, bundled) = (&town.accel, sets.each_ref().map(|set| bundles(set)));
    let cw = Baseline::<CwBvh>::new(town);
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
    TownRates { rates, hits: best.map(|best| best.map(|(_, hits)| hits)) }
}

/// Writes a town and its rays, with what was measured.
fn export(
    folder: &Path,
    name: &str,
    town: &BenchTown,
    sets: &[Vec<Packet>; 4],
    found: &TownRates,
) -> std::io::Result<()> {
    let measured: [MeasuredSet<'_>; 4] = std::array::from_fn(|set| MeasuredSet {
        name: SETS[set],
        any_hit: set == SUN,
        packets: &sets[set],
        hits: found.hits[1][set],
        rates: std::array::from_fn(|way| found.rates[1 + way][set]),
    });
    export::write_scene(folder, name, town)?;
    export::write_rays(folder, name, &measured)
}

fn print_ratios(name: &str, ratios: &[f64; 4]) {
    let columns = SETS.iter().zip(ratios).map(|(set, ratio)| format!("{:20}", format!("{ratio:6.2} {set}")));
    println!("{name:14} {}", columns.collect::<String>());
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut names: Vec<String> = std::env::args().skip(1).collect();
    let mut folder = None;
    if let Some(flag) = names.iter().position(|name| name == "--export") {
        let mut rest = names.split_off(flag).into_iter().skip(1);
        folder = Some(PathBuf::from(rest.next().ok_or("--export needs a folder")?));
        names.extend(rest);
    }
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
        let sets = town.rays();
        let found = measure(&town, &sets);
        let [cwbvh, _, packets, bundles] = found.rates;
        // How many times as fast as CWBVH the better of packets and bundles is.
        let ratios = std::array::from_fn(|set| packets[set].max(bundles[set]) / cwbvh[set]);
        print_ratios("times CWBVH", &ratios);
        all.push(ratios);
        if let Some(folder) = &folder {
            export(folder, name, &town, &sets, &found)?;
        }
    }
    let mean = |set: usize| all.iter().map(|ratios: &[f64; 4]| ratios[set]).sum::<f64>() / all.len() as f64;
    print_ratios("mean of all", &std::array::from_fn(mean));
    Ok(())
}
