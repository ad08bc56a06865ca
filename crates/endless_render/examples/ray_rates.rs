//! Prints rates of tracing in a made-up town, or in a built-in one, own traversal beside those of `obvhs`:
//! `cargo run --release -p endless_render --example ray_rates -- [Town03]`.
#![expect(clippy::print_stdout, reason = "a table is what it is for")]

#[path = "../benches/town/baseline.rs"]
mod baseline;
#[path = "../benches/town/builtin.rs"]
mod builtin;
#[path = "../benches/town/mod.rs"]
mod town;

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use endless_render::{Accel, Ray, RayBundle};
use obvhs::bvh2::Bvh2;
use obvhs::cwbvh::CwBvh;
use town::{Packet, Town};

const THREADS: usize = 2;
const ROUNDS: usize = 5;

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

/// Millions of active rays per second, best of some rounds, and how many hit.
fn rate<R: Sync, M: Copy + Into<u32> + Sync>(packets: &[(R, M)], trace: impl Fn(&R, M) -> u32 + Sync) -> (f64, usize) {
    const CHUNK: usize = 512;
    let rays: u32 = packets.iter().map(|(_, active)| (*active).into().count_ones()).sum();
    let mut best = f64::INFINITY;
    let mut hits = 0;
    for _ in 0..ROUNDS {
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
        best = best.min(busy.into_inner() as f64 * 1e-9 / THREADS as f64);
        hits = found.into_inner();
    }
    (f64::from(rays) / best / 1e6, hits)
}

/// The same rays, four packets together.
fn bundles(packets: &[Packet]) -> Vec<(RayBundle<4>, u32)> {
    let bundle = |four: &[Packet]| {
        let of = |i: usize| four.get(i).unwrap_or(&four[0]);
        let active = four.iter().enumerate().map(|(i, (_, active))| u32::from(*active) << (8 * i)).sum();
        (RayBundle::of(&std::array::from_fn(|i| of(i).0)), active)
    };
    packets.chunks(4).map(bundle).collect()
}

fn each(active: u8, rays: &[Ray; 8], hit: impl Fn(&Ray) -> bool) -> u32 {
    (0..8).filter(|&lane| active >> lane & 1 != 0 && hit(&rays[lane])).count() as u32
}

fn main() {
    let start = Instant::now();
    let town = std::env::args().nth(1).map_or_else(Town::new, |name| Town::builtin(&name));
    println!("built in {:.1} s", start.elapsed().as_secs_f64());
    let unique: usize = town.meshes.iter().map(|m| m.triangles.len()).sum();
    let bytes: usize = town.blas.iter().map(|b| b.memory_bytes()).sum();
    println!(
        "{} instances, {unique} own triangles at {:.0} B, {} instanced; top level {:.1} MB",
        town.instances.len(),
        bytes as f64 / unique as f64,
        town.instances.iter().map(|(m, _)| town.meshes[*m].triangles.len()).sum::<usize>(),
        town.accel.memory_bytes() as f64 / 1e6
    );
    for count in [100, 600, town.instances.len()] {
        let place = |_| town::placed(&town.blas, &town.instances[town.instances.len() - count..]);
        let lists: Vec<_> = (0..9).map(place).collect();
        let times = lists.into_iter().map(|list| {
            let start = Instant::now();
            std::hint::black_box(Accel::build(list));
            start.elapsed().as_secs_f64() * 1e3
        });
        println!("top level over {count} instances: {:.3} ms", times.fold(f64::INFINITY, f64::min));
    }
    let [primary, sun, diffuse, scattered] = town.rays();
    let accel = &town.accel;
    let print = |name: &str, [a, b, c, d]: [(f64, usize); 4]| {
        println!(
            "{name:16} primary {:6.2}  sun {:6.2}  diffuse {:6.2}  scattered {:6.2} Mrays/s   hits {} {} {} {}",
            a.0, b.0, c.0, d.0, a.1, b.1, c.1, d.1
        );
    };
    let report = |name: &str,
                  closest: &(dyn Fn(&[Ray; 8], u8) -> u32 + Sync),
                  occluded: &(dyn Fn(&[Ray; 8], u8) -> u32 + Sync)| {
        let rates = [rate(&primary, closest), rate(&sun, occluded), rate(&diffuse, closest), rate(&scattered, closest)];
        print(name, rates);
    };
    report("own, single", &|r, m| each(m, r, |ray| accel.closest(ray).is_some()), &|r, m| {
        each(m, r, |ray| accel.occluded(ray))
    });
    report("own, packets", &|r, m| accel.closest8(r, m).iter().flatten().count() as u32, &|r, m| {
        accel.occluded8(r, m).count_ones()
    });
    let closest = |r: &RayBundle<4>, m: u32| {
        let hits = accel.closest32(r, m);
        (0..32).filter(|&lane| hits.get(lane).is_some()).count() as u32
    };
    let occluded = |r: &RayBundle<4>, m: u32| accel.occluded32(r, m).count_ones();
    let [by_primary, by_sun, by_diffuse, by_scattered] = [&primary, &sun, &diffuse, &scattered].map(|p| bundles(p));
    let rates =
        [rate(&by_primary, closest), rate(&by_sun, occluded), rate(&by_diffuse, closest), rate(&by_scattered, closest)];
    print("own, bundles", rates);
    let cw = baseline::Baseline::<CwBvh>::new(&town);
    report("obvhs CWBVH", &|r, m| each(m, r, |ray| cw.closest(ray).is_some()), &|r, m| {
        each(m, r, |ray| cw.occluded(ray))
    });
    let b2 = baseline::Baseline::<Bvh2>::new(&town);
    report("obvhs BVH2", &|r, m| each(m, r, |ray| b2.closest(ray).is_some()), &|r, m| {
        each(m, r, |ray| b2.occluded(ray))
    });
}
