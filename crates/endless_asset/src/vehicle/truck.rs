//! What lorries carry.

use super::assemble::VehicleBlueprint;
use super::draw::DesignDraw;
use super::lorry::{BODY_HALF_WIDTH, CAB_TOP, Cab, FRAME_Z, Lorry, rect};
use super::paint;
use crate::shape::{Region, Sculpt};
use endless_scene::{Material, Surface};
use endless_world::{ClassTag, Stream};
use glam::{Vec2, Vec3};

const W: f32 = BODY_HALF_WIDTH;

fn side(polygon: &[(f32, f32)]) -> Region {
    Region::side(&polygon.iter().map(|&p| Vec2::from(p)).collect::<Vec<_>>()).facing(Vec3::Y, 0.9)
}

fn back(polygon: &[(f32, f32)]) -> Region {
    Region::end(&polygon.iter().map(|&p| Vec2::from(p)).collect::<Vec<_>>()).facing(-Vec3::X, 0.9)
}

fn block(low: Vec3, high: Vec3, material: Material) -> Sculpt {
    Sculpt::cuboid(low, high, 0.0, material)
}

const fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A lorry of a length whose rear axle lies where its load asks for it.
fn two_axles(length: f32, cab: Cab, height: f32) -> Lorry {
    Lorry { length, cab, rear_axles_d: vec![0.725 * length], height }
}

/// A box of 12 tons.
pub(crate) fn box_truck(draw: &DesignDraw) -> VehicleBlueprint {
    boxed(draw, draw.range("length", 6.9, 7.9), draw.range("height", 3.15, 3.55))
        .scaled(draw.range("scale", 0.98, 1.03))
}

/// A box of 3.5 to 7.5 tons, for parcels and removals.
pub(crate) fn small_box(draw: &DesignDraw) -> VehicleBlueprint {
    boxed(draw, draw.range("length", 6.7, 7.4), draw.range("height", 3.3, 3.6)).scaled(draw.range("scale", 0.82, 0.87))
}

fn boxed(draw: &DesignDraw, length: f32, top: f32) -> VehicleBlueprint {
    let curtain = draw.chance("curtain sides", 0.35);
    let refrigerated = draw.chance("refrigerated", 0.3);
    two_axles(length, Cab::Day, top).blueprint(move |lorry| {
        let (length, x1) = (lorry.length, lorry.body_front() + 0.01);
        let (z0, z1, w) = (FRAME_Z + 0.10, top, W);
        let mut cargo = closed_box(length, x1, z0, z1, curtain);
        if refrigerated {
            let (low, high) = (v(x1 - 0.02, -0.75, z1 - 0.75), v(x1 + 0.32, 0.75, z1 - 0.12));
            cargo.add(Sculpt::cuboid(low, high, 0.06, paint::WHITE));
            cargo.add(block(v(x1 + 0.31, -0.5, z1 - 0.55), v(x1 + 0.33, 0.5, z1 - 0.25), paint::DARK));
        } else {
            // A deflector over the cab.
            let slope = [(x1 + 0.02, CAB_TOP - 0.05), (x1 + 1.35, CAB_TOP - 0.02), (x1 + 0.02, z1 - 0.2)];
            cargo.add(Sculpt::slab(&slope.map(Vec2::from), -0.9 * w, 0.9 * w, 20.0, paint::BODY));
        }
        cargo
    })
}

/// A box from the rear at -`length` to x1, with aluminium edges, seams, doors with bars, and a livery on its sides.
pub(super) fn closed_box(length: f32, x1: f32, z0: f32, z1: f32, curtain: bool) -> Sculpt {
    let w = W;
    let mut cargo = Sculpt::cuboid(
        Vec3::new(-length, -w, z0),
        Vec3::new(x1, w, z1),
        0.035,
        if curtain { paint::BODY } else { paint::CARGO_WHITE },
    );
    // Aluminium edges, panel seams, rear doors with bars, and a livery block on the sides.
    for (a, b) in [(z0, z0 + 0.12), (z1 - 0.09, z1)] {
        cargo.paint(&Region::all().beyond(Vec3::Z, a).within(Vec3::Z, b).facing(Vec3::Y, 0.3), paint::STEEL);
        cargo.paint(&Region::all().beyond(Vec3::Z, a).within(Vec3::Z, b).facing(-Vec3::Y, 0.3), paint::STEEL);
        cargo.paint(&Region::all().beyond(Vec3::Z, a).within(Vec3::Z, b).facing(-Vec3::X, 0.3), paint::STEEL);
    }
    let logo = [(-5.6, z0 + 0.75), (-3.7, z0 + 0.75), (-3.4, z0 + 1.55), (-5.3, z0 + 1.55)];
    cargo.paint_both(&side(&logo), if curtain { paint::CARGO_WHITE } else { paint::BODY });
    let stripe = [(-length + 0.3, z0 + 0.32), (x1 - 0.3, z0 + 0.32), (x1 - 0.3, z0 + 0.44), (-length + 0.3, z0 + 0.44)];
    cargo.paint_both(&side(&stripe), paint::BODY);
    let mut x = x1 - 0.6;
    while x > -length + 0.2 {
        cargo.paint_both(&side(&rect(x, x + 0.012, z0 + 0.12, z1 - 0.09)), paint::STEEL);
        x -= 0.6;
    }
    cargo.paint(&back(&rect(-0.01, 0.01, z0 + 0.1, z1 - 0.1)), paint::DARK);
    for y in [-0.75, -0.28, 0.28, 0.75] {
        cargo.add(Sculpt::tube(
            &[(Vec3::new(-length - 0.02, y, z0 + 0.05), 0.016), (Vec3::new(-length - 0.02, y, z1 - 0.08), 0.016)],
            6,
            paint::STEEL,
        ));
    }
    cargo
}

pub(crate) fn tipper(draw: &DesignDraw) -> VehicleBlueprint {
    let (length, z1) = (draw.range("length", 6.7, 7.3), draw.range("wall", 1.95, 2.25));
    let seed = (draw.range("load", 0.0, 1e6)) as u64;
    let loaded = draw.chance("loaded", 0.7);
    two_axles(length, Cab::Day, CAB_TOP + 0.11)
        .blueprint(move |lorry| tipping_body(lorry, z1, loaded, seed))
        .scaled(draw.range("scale", 0.98, 1.05))
}

fn tipping_body(lorry: &Lorry, z1: f32, loaded: bool, seed: u64) -> Sculpt {
    let (length, x1) = (lorry.length, lorry.body_front() - 0.02);
    let (x0, z0, w) = (-length + 0.1, FRAME_Z + 0.16, W - 0.05);
    let wall = |low: Vec3, high: Vec3| Sculpt::cuboid(low, high, 0.0, paint::BODY);
    let t = 0.07;
    let mut cargo = wall(Vec3::new(x0, -w, z0 - 0.10), Vec3::new(x1, w, z0));
    cargo.add(wall(Vec3::new(x0, w - t, z0), Vec3::new(x1, w, z1)).both_sides());
    cargo.add(wall(Vec3::new(x0, -w + t, z0), Vec3::new(x0 + t, w - t, z1)));
    cargo.add(wall(Vec3::new(x1 - t, -w + t, z0), Vec3::new(x1, w - t, z1 + 0.35)));
    // Ribs, a top rim, and the canopy over the cab.
    for i in 0..7 {
        let x = x0 + (x1 - x0 - 0.1) * i as f32 / 6.0;
        cargo.add(
            Sculpt::cuboid(Vec3::new(x, w - 0.01, z0 - 0.08), Vec3::new(x + 0.1, w + 0.05, z1), 0.012, paint::BODY)
                .both_sides(),
        );
    }
    cargo.add(
        Sculpt::cuboid(Vec3::new(x0, w - 0.09, z1 - 0.02), Vec3::new(x1, w + 0.05, z1 + 0.09), 0.015, paint::BODY)
            .both_sides(),
    );
    cargo.add(Sculpt::cuboid(
        Vec3::new(x1 - 0.05, -0.95, CAB_TOP + 0.06),
        Vec3::new(x1 + 0.65, 0.95, CAB_TOP + 0.11),
        0.0,
        paint::BODY,
    ));
    cargo.add(Sculpt::cuboid(
        Vec3::new(x1 - 0.05, -0.95, z1 + 0.3),
        Vec3::new(x1, 0.95, CAB_TOP + 0.08),
        0.0,
        paint::BODY,
    ));
    if loaded {
        cargo.add(heap(x0 + t, x1 - t, w - t, z1, seed));
    }
    cargo
}

/// A heap of sand or earth between walls.
fn heap(x0: f32, x1: f32, w: f32, z1: f32, seed: u64) -> Sculpt {
    let sand = Material::new(Surface::Gravel, [0.30, 0.23, 0.15], ClassTag::Truck);
    let mut stream = Stream::named(seed, "tipper load", &[]);
    let (nx, ny) = (14, 8);
    let rows: Vec<Vec<Vec3>> = (0..=ny)
        .map(|j| {
            (0..=nx)
                .map(|i| {
                    let (u, v) = (i as f32 / nx as f32, j as f32 / ny as f32);
                    let heap = (1.0 - (2.0 * u - 1.0) * (2.0 * u - 1.0)) * (1.0 - (2.0 * v - 1.0) * (2.0 * v - 1.0));
                    let z = z1 - 0.35 + 0.55 * heap + stream.range_f32(-0.025, 0.025);
                    Vec3::new(x0 + u * (x1 - x0), -w + v * 2.0 * w, z)
                })
                .collect()
        })
        .collect();
    let mut heap = Sculpt::new();
    heap.grid(&rows, false, sand);
    heap.smooth(60.0)
}
