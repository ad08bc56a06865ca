//! How long the catalogue takes: building it, making a person, posing a person.
#![expect(clippy::print_stdout, reason = "it says what it measured")]

use endless_asset::{Catalogue, Prop};
use endless_world::{Gait, WalkerMotion};
use std::time::Instant;

fn main() {
    let start = Instant::now();
    let catalogue = Catalogue::builtin();
    println!("catalogue: {:.0} ms", start.elapsed().as_secs_f64() * 1e3);
    let (mut slowest, mut name) = (0.0, "");
    let start = Instant::now();
    for vehicle in catalogue.vehicles() {
        let own = Instant::now();
        std::hint::black_box(vehicle.body());
        let ms = own.elapsed().as_secs_f64() * 1e3;
        if ms > slowest {
            (slowest, name) = (ms, vehicle.spec.name);
        }
    }
    let n = catalogue.vehicles().len();
    let each = start.elapsed().as_secs_f64() * 1e3 / n as f64;
    println!("{n} vehicles: {each:.1} ms each, at most {slowest:.1} ms ({name})");
    let start = Instant::now();
    let people: Vec<_> = (0..20).map(|v| catalogue.person(v)).collect();
    println!("a person: {:.1} ms", start.elapsed().as_secs_f64() * 1e3 / 20.0);
    let n = 200;
    let start = Instant::now();
    let mut vertices = 0;
    for k in 0..n {
        for person in &people {
            let walked_m = 0.03 * k as f32;
            let motion = WalkerMotion { speed_mps: 1.4, gait: Gait::Walk, walked_m, ..WalkerMotion::default() };
            vertices += person.pose(&motion).positions.len();
        }
    }
    let poses = n * people.len();
    println!("a pose: {:.1} µs, {} vertices", start.elapsed().as_secs_f64() * 1e6 / poses as f64, vertices / poses);
    let start = Instant::now();
    let tree = catalogue.prop(Prop::BroadleafTree, 0);
    println!("a tree: {:.1} ms, {} triangles", start.elapsed().as_secs_f64() * 1e3, tree.triangles.len());
}
