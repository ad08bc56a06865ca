//! A frame of vehicles that drive through each other's ways, at 20 frames a second.

use divan::counter::ItemsCount;
use endless_carla::physics::{Body, Mover, Obstacle, OrientedBox, Place, VehicleBody, VehicleShape, step_bodies};
use endless_carla::wire::VehicleControl;
use glam::{DVec2, DVec3};

fn main() {
    divan::main();
}

/// Items are the vehicles; a wall is near each of them.
#[divan::bench(args = [10, 100, 1000])]
fn frame(bencher: divan::Bencher<'_, '_>, count: usize) {
    let columns = (count as f64).sqrt().ceil() as usize;
    let mut vehicles: Vec<_> = (0..count)
        .map(|index| {
            let (x, y) = ((index % columns) as f64 * 12.0, (index / columns) as f64 * 12.0);
            VehicleBody::new(VehicleShape::MODEL3, Place::level(DVec3::new(x, y, 0.0), index as f64))
        })
        .collect();
    let controls: Vec<_> = (0..count)
        .map(|index| VehicleControl {
            throttle: 0.5,
            steer: 0.2 + 0.1 * (index % 7) as f32,
            ..VehicleControl::default()
        })
        .collect();
    let walls = |low: DVec2, _: DVec2, found: &mut Vec<Obstacle>| {
        let outline = OrientedBox { centre: low, half: DVec2::new(0.2, 2.0), along: DVec2::X, low_m: 0.0, high_m: 2.0 };
        found.push(Obstacle { id: 1, outline });
    };
    let ground = |x: f64, y: f64, _: f64| Some(0.01 * x - 0.02 * y);
    bencher.counter(ItemsCount::new(count)).bench_local(|| {
        let mut bodies: Vec<_> = vehicles
            .iter_mut()
            .zip(&controls)
            .enumerate()
            .map(|(id, (vehicle, control))| Body { id: id as u32, mover: Mover::Vehicle(vehicle, control) })
            .collect();
        step_bodies(&mut bodies, 0.05, &ground, &walls)
    });
}
