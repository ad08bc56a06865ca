//! Lorries: a cab over the front axle, a chassis, and what it carries.

use super::VehicleSpec;
use super::assemble::{Assembly, Built};
use super::car::{open_arch, plate};
use super::paint;
use super::shell::{Arch, Cabin, Ring, Shell};
use super::wheel::{Rim, wheel};
use crate::shape::{Curve, Region, Sculpt, rounded};
use crate::{Material, Surface};
use endless_world::{ClassTag, ObjectClass, Stream};
use glam::{Vec2, Vec3};

const HALF_WIDTH: f32 = 1.15;
const WHEEL: f32 = 0.44;
const AXLE_D: f32 = 1.15;
const CAB_LENGTH: f32 = 1.95;
const CAB_TOP: f32 = 2.58;
const FLOOR: f32 = 0.48;
const BELT: f32 = 1.55;
/// Top of the chassis.
const FRAME_Z: f32 = 0.98;

/// Box lorry and tipper.
pub(crate) fn all() -> Vec<Built> {
    vec![box_truck(), tipper()]
}

fn rect(a0: f32, a1: f32, b0: f32, b1: f32) -> [(f32, f32); 4] {
    [(a0, b0), (a1, b0), (a1, b1), (a0, b1)]
}

/// The cab, its front at x = 0.
fn cab() -> Sculpt {
    let outline = Ring {
        front: 0.0,
        rear: -CAB_LENGTH,
        half_width: HALF_WIDTH,
        bow: [0.10, 0.0],
        corner: [0.22, 0.06],
        taper: [0.02, 0.0],
    };
    let flat = |z: f32| Curve::new(&[(-9.0, z), (9.0, z)]);
    let arch = Arch { x: -AXLE_D, z: WHEEL, radius: WHEEL + 0.10, flare: 0.015 };
    let shell = Shell {
        outline,
        section: vec![
            (0.0, 0.08, 0.10, 0.0),
            (0.04, 0.02, 0.02, 0.0),
            (0.2, 0.0, 0.0, 0.0),
            (0.42, 0.0, 0.0, 0.0),
            (0.48, 0.0, 0.03, 0.0),
            (0.8, 0.0, 0.05, 0.0),
            (1.0, 0.01, 0.07, 0.0),
        ],
        sill: flat(FLOOR),
        belt: flat(BELT),
        deck: flat(BELT),
        cabin: Cabin {
            foot: outline.inset(0.015, 0.075, 0.0),
            top: outline.inset(0.10, 0.30, 0.06),
            roof: Curve::new(&[(-CAB_LENGTH, CAB_TOP), (-0.9, CAB_TOP), (-0.2, CAB_TOP - 0.10)]),
            edge_drop: 0.10,
            bulge: 0.01,
        },
        arches: vec![arch],
    };
    let mut body = shell.sculpt(paint::BODY);
    let w = HALF_WIDTH;
    let front =
        |polygon: &[(f32, f32)], r: f32| Region::end(&rounded(polygon, r)).facing(Vec3::X, 0.25).beyond(Vec3::X, -0.6);
    let side =
        |polygon: &[(f32, f32)], r: f32| Region::side(&rounded(polygon, r)).facing(Vec3::Y, 0.5).beyond(Vec3::Y, 0.6);
    body.paint(&Region::all().facing(-Vec3::Z, 0.5).within(Vec3::Z, 0.8), paint::DARK);
    body.paint(
        &front(&[(-w + 0.05, BELT), (w - 0.05, BELT), (w - 0.14, CAB_TOP - 0.22), (-w + 0.14, CAB_TOP - 0.22)], 0.10),
        paint::TRIM,
    );
    body.paint(
        &front(
            &[
                (-w + 0.10, BELT + 0.05),
                (w - 0.10, BELT + 0.05),
                (w - 0.19, CAB_TOP - 0.26),
                (-w + 0.19, CAB_TOP - 0.26),
            ],
            0.10,
        ),
        paint::GLASS,
    );
    let window = [(-1.22, BELT + 0.05), (-0.42, BELT - 0.10), (-0.55, CAB_TOP - 0.30), (-1.22, CAB_TOP - 0.28)];
    body.paint_both(&side(&window, 0.08), paint::TRIM);
    let pane = [(-1.19, BELT + 0.08), (-0.46, BELT - 0.06), (-0.58, CAB_TOP - 0.33), (-1.19, CAB_TOP - 0.31)];
    body.paint_both(&side(&pane, 0.08), paint::GLASS);
    for x in [-1.34, -0.33] {
        body.paint_both(&side(&rect(x, x + 0.013, FLOOR + 0.3, CAB_TOP - 0.2), 0.0), paint::DARK);
    }
    body.add(
        Sculpt::ellipsoid(Vec3::new(-1.2, w + 0.003, BELT - 0.22), Vec3::new(0.09, 0.022, 0.018), 10, paint::TRIM)
            .both_sides(),
    );
    // Grille in bars, bumper, lamps.
    for i in 0..4 {
        let z = 1.02 + 0.095 * i as f32;
        body.paint(&front(&rect(-0.72, 0.72, z, z + 0.06), 0.02), paint::DARK);
    }
    body.paint(&front(&rect(-w, w, FLOOR, 0.72), 0.0), paint::TRIM);
    body.paint(&side(&rect(-0.6, 0.1, FLOOR, 0.72), 0.0), paint::TRIM);
    body.paint_both(&front(&rect(w - 0.48, w - 0.06, 0.74, 0.96), 0.04), paint::DARK);
    body.paint_both(&front(&rect(w - 0.46, w - 0.20, 0.76, 0.94), 0.04), paint::HEAD);
    body.paint(&front(&rect(w - 0.18, w - 0.08, 0.77, 0.93), 0.02), paint::LEFT);
    body.paint(&front(&rect(w - 0.18, w - 0.08, 0.77, 0.93), 0.02).mirrored(), paint::RIGHT);
    open_arch(&mut body, &arch, HALF_WIDTH, true);
    plate(&mut body, Vec3::new(0.005, 0.0, 0.60), 1.0);
    let mirror = [
        (Vec3::new(-0.35, w - 0.04, 2.25), 0.016),
        (Vec3::new(-0.22, w + 0.14, 2.25), 0.016),
        (Vec3::new(-0.22, w + 0.14, 1.6), 0.016),
    ];
    body.add(Sculpt::tube(&mirror, 6, paint::TRIM).both_sides());
    body.add(
        Sculpt::cuboid(Vec3::new(-0.26, w + 0.05, 1.72), Vec3::new(-0.18, w + 0.24, 2.16), 0.025, paint::TRIM)
            .both_sides(),
    );
    for y in [-0.5, 0.3] {
        body.add(Sculpt::tube(
            &[(Vec3::new(-0.03, y, BELT + 0.03), 0.011), (Vec3::new(-0.10, y + 0.55, BELT + 0.2), 0.008)],
            5,
            paint::DARK,
        ));
    }
    body
}

/// Frame rails, tank, guards and the lamp bar; front at x = 0.
fn chassis(length: f32, rear_axle_d: f32) -> Sculpt {
    let mut s = Sculpt::new();
    let rear = -length;
    s.add(
        Sculpt::cuboid(Vec3::new(rear + 0.1, 0.32, 0.72), Vec3::new(-0.6, 0.42, FRAME_Z), 0.0, paint::CHASSIS)
            .both_sides(),
    );
    s.add(Sculpt::cuboid(
        Vec3::new(-AXLE_D - 0.06, -0.9, WHEEL - 0.06),
        Vec3::new(-AXLE_D + 0.06, 0.9, WHEEL + 0.06),
        0.0,
        paint::CHASSIS,
    ));
    s.add(Sculpt::cuboid(
        Vec3::new(-rear_axle_d - 0.08, -0.9, WHEEL - 0.08),
        Vec3::new(-rear_axle_d + 0.08, 0.9, WHEEL + 0.08),
        0.0,
        paint::CHASSIS,
    ));
    let tank = -(AXLE_D + 1.5);
    s.add(Sculpt::cuboid(Vec3::new(tank - 0.85, 0.55, 0.42), Vec3::new(tank, 1.05, 0.90), 0.10, paint::STEEL));
    s.add(Sculpt::cuboid(Vec3::new(tank - 0.6, -1.05, 0.45), Vec3::new(tank, -0.55, 0.90), 0.04, paint::CHASSIS));
    // Side guards and mudguards.
    for z in [0.48, 0.72] {
        s.add(
            Sculpt::cuboid(
                Vec3::new(-rear_axle_d + 0.62, 1.06, z),
                Vec3::new(tank - 0.95, 1.09, z + 0.10),
                0.0,
                paint::STEEL,
            )
            .both_sides(),
        );
    }
    for x in [-rear_axle_d - 0.60, -rear_axle_d + 0.58] {
        s.add(
            Sculpt::cuboid(Vec3::new(x, 0.60, 0.45), Vec3::new(x + 0.02, 1.12, 0.95), 0.0, paint::RUBBER).both_sides(),
        );
    }
    // Rear bumper bar with lamps.
    s.add(Sculpt::cuboid(Vec3::new(rear, -1.12, 0.50), Vec3::new(rear + 0.10, 1.12, 0.66), 0.02, paint::CHASSIS));
    let lamp = |y0: f32, y1: f32, m: Material| {
        Sculpt::cuboid(Vec3::new(rear - 0.015, y0, 0.70), Vec3::new(rear + 0.05, y1, 0.86), 0.012, m)
    };
    s.add(lamp(0.86, 1.10, paint::TAIL).both_sides());
    s.add(lamp(0.72, 0.85, paint::LEFT));
    s.add(lamp(0.72, 0.85, paint::RIGHT).mirrored());
    s.add(lamp(0.60, 0.71, paint::REVERSE).both_sides());
    plate(&mut s, Vec3::new(rear, 0.0, 0.78), -1.0);
    s
}

fn assemble(name: &'static str, frequency: f64, length: f32, rear_axle_d: f32, cargo: Sculpt) -> Built {
    let mut body = cab();
    body.add(chassis(length, rear_axle_d));
    body.add(cargo);
    let spec = VehicleSpec {
        cruise_mps: 11.0,
        acceleration_mps2: 1.0,
        frequency,
        parks: false,
        ..VehicleSpec::blank(name, ObjectClass::Truck)
    };
    let mut assembly = Assembly::new(spec, body, wheel(WHEEL, 0.27, 0.60, Rim::Steel, paint::STEEL), WHEEL);
    assembly.axle(-AXLE_D, 0.98, true);
    // Twin tyres behind.
    assembly.axle(-rear_axle_d, 0.98, false);
    assembly.axle(-rear_axle_d, 0.68, false);
    let lamp = Vec3::new(-0.08, HALF_WIDTH - 0.33, 0.85);
    assembly.headlights = vec![lamp, Vec3::new(lamp.x, -lamp.y, lamp.z)];
    assembly.finish(2.0 * 1.2)
}

fn box_truck() -> Built {
    let (length, x1) = (7.4, -CAB_LENGTH - 0.12);
    let (z0, z1, w) = (FRAME_Z + 0.10, 3.35, 1.2);
    let mut cargo = Sculpt::cuboid(Vec3::new(-length, -w, z0), Vec3::new(x1, w, z1), 0.035, paint::CARGO_WHITE);
    // Aluminium edges, panel seams, rear doors with bars, and a livery block on the sides.
    for (a, b) in [(z0, z0 + 0.12), (z1 - 0.09, z1)] {
        cargo.paint(&Region::all().beyond(Vec3::Z, a).within(Vec3::Z, b).facing(Vec3::Y, 0.3), paint::STEEL);
        cargo.paint(&Region::all().beyond(Vec3::Z, a).within(Vec3::Z, b).facing(-Vec3::Y, 0.3), paint::STEEL);
        cargo.paint(&Region::all().beyond(Vec3::Z, a).within(Vec3::Z, b).facing(-Vec3::X, 0.3), paint::STEEL);
    }
    let side = |polygon: &[(f32, f32)]| {
        Region::side(&polygon.iter().map(|&p| Vec2::from(p)).collect::<Vec<_>>()).facing(Vec3::Y, 0.9)
    };
    let logo = [(-5.6, z0 + 0.75), (-3.7, z0 + 0.75), (-3.4, z0 + 1.55), (-5.3, z0 + 1.55)];
    cargo.paint_both(&side(&logo), paint::BODY);
    let stripe = [(-length + 0.3, z0 + 0.32), (x1 - 0.3, z0 + 0.32), (x1 - 0.3, z0 + 0.44), (-length + 0.3, z0 + 0.44)];
    cargo.paint_both(&side(&stripe), paint::BODY);
    let mut x = x1 - 0.6;
    while x > -length + 0.2 {
        cargo.paint_both(&side(&rect(x, x + 0.012, z0 + 0.12, z1 - 0.09)), paint::STEEL);
        x -= 0.6;
    }
    let back = |polygon: &[(f32, f32)]| {
        Region::end(&polygon.iter().map(|&p| Vec2::from(p)).collect::<Vec<_>>()).facing(-Vec3::X, 0.9)
    };
    cargo.paint(&back(&rect(-0.01, 0.01, z0 + 0.1, z1 - 0.1)), paint::DARK);
    for y in [-0.75, -0.28, 0.28, 0.75] {
        cargo.add(Sculpt::tube(
            &[(Vec3::new(-length - 0.02, y, z0 + 0.05), 0.016), (Vec3::new(-length - 0.02, y, z1 - 0.08), 0.016)],
            6,
            paint::STEEL,
        ));
    }
    assemble("truck.box", 3.0, length, 5.35, cargo)
}

fn tipper() -> Built {
    let (length, x1) = (7.0, -CAB_LENGTH - 0.15);
    let (x0, z0, z1, w) = (-length + 0.1, FRAME_Z + 0.16, 2.15, 1.2);
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
    // A heap of sand.
    let sand = Material::new(Surface::Gravel, [0.30, 0.23, 0.15], ClassTag::Truck);
    let mut stream = Stream::named(0, "tipper load", &[]);
    let (nx, ny) = (14, 8);
    let rows: Vec<Vec<Vec3>> = (0..=ny)
        .map(|j| {
            (0..=nx)
                .map(|i| {
                    let (u, v) = (i as f32 / nx as f32, j as f32 / ny as f32);
                    let heap = (1.0 - (2.0 * u - 1.0) * (2.0 * u - 1.0)) * (1.0 - (2.0 * v - 1.0) * (2.0 * v - 1.0));
                    let z = z1 - 0.35 + 0.55 * heap + stream.range_f32(-0.025, 0.025);
                    Vec3::new(x0 + t + u * (x1 - x0 - 2.0 * t), -w + t + v * 2.0 * (w - t), z)
                })
                .collect()
        })
        .collect();
    let mut heap = Sculpt::new();
    heap.grid(&rows, false, sand);
    cargo.add(heap.smooth(60.0));
    assemble("truck.tipper", 2.0, length, 5.15, cargo)
}
