//! Lorries with open beds, tanks, drums and hoppers.

use super::assemble::VehicleBlueprint;
use super::draw::DesignDraw;
use super::lorry::{BODY_HALF_WIDTH, CAB_TOP, Cab, FRAME_Z, Lorry, rect};
use super::paint;
use crate::shape::{Region, Sculpt};
use endless_scene::Material;
use endless_world::Stream;
use glam::{Affine3A, Quat, Vec2, Vec3};

const W: f32 = BODY_HALF_WIDTH;

const fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

fn block(low: Vec3, high: Vec3, material: Material) -> Sculpt {
    Sculpt::cuboid(low, high, 0.0, material)
}

/// A bed with drop sides, from a builder's small one to a carrier of machines.
pub(crate) fn flatbed(draw: &DesignDraw) -> VehicleBlueprint {
    let length = draw.range("length", 6.6, 7.8);
    let (sides, load) = (draw.chance("drop sides", 0.6), draw.pick("load", &[0, 1, 2, 3]));
    let seed = draw.range("pieces", 0.0, 1e6) as u64;
    let lorry = Lorry { length, cab: Cab::Day, rear_axles_d: vec![0.725 * length], height: CAB_TOP + 0.02 };
    let scale =
        if draw.chance("small", 0.4) { draw.range("scale", 0.80, 0.86) } else { draw.range("scale", 0.97, 1.04) };
    let blueprint = lorry.blueprint(move |lorry| {
        let (x0, x1, z) = (-lorry.length, lorry.body_front(), FRAME_Z + 0.14);
        let mut s = block(v(x0, -W, z - 0.12), v(x1, W, z), paint::WOOD);
        s.paint(&Region::all().within(Vec3::Z, z - 0.01), paint::STEEL);
        // The rack behind the cab.
        for y in [-W + 0.03, -0.4, 0.4, W - 0.09] {
            s.add(block(v(x1 - 0.07, y, z), v(x1 - 0.01, y + 0.06, CAB_TOP - 0.02), paint::STEEL));
        }
        for k in 0..4 {
            let h = z + 0.25 + (CAB_TOP - z - 0.27) * k as f32 / 3.0;
            s.add(block(v(x1 - 0.06, -W + 0.03, h - 0.05), v(x1 - 0.02, W - 0.03, h), paint::STEEL));
        }
        if sides {
            s.add(block(v(x0, W - 0.03, z), v(x1 - 0.08, W, z + 0.42), paint::STEEL).both_sides());
            s.add(block(v(x0, -W + 0.03, z), v(x0 + 0.03, W - 0.03, z + 0.42), paint::STEEL));
            let n = 4;
            for i in 0..=n {
                let x = x0 + (x1 - 0.14 - x0) * i as f32 / n as f32;
                s.add(block(v(x, W - 0.01, z - 0.1), v(x + 0.06, W + 0.018, z + 0.44), paint::CHASSIS).both_sides());
            }
        }
        s.add(load_of(load, x0 + 0.25, x1 - 0.35, z, seed));
        s
    });
    blueprint.scaled(scale)
}

/// Nothing, pallets, pipes or planks on a bed.
fn load_of(kind: i32, x0: f32, x1: f32, z: f32, seed: u64) -> Sculpt {
    let mut s = Sculpt::new();
    let mut stream = Stream::named(seed, "flatbed load", &[]);
    match kind {
        1 => {
            let colors = [paint::CARTON, paint::CARGO_WHITE, paint::ORANGE, paint::CARTON];
            let n = ((x1 - x0) / 1.0) as usize;
            for i in 0..n {
                for y in [-1.05f32, 0.1] {
                    if stream.chance(0.25) {
                        continue;
                    }
                    let x = x0 + i as f32;
                    s.add(block(v(x, y, z), v(x + 0.9, y + 0.95, z + 0.14), paint::WOOD));
                    let high = z + 0.14 + stream.range_f32(0.5, 1.1);
                    s.add(block(v(x + 0.02, y + 0.02, z + 0.14), v(x + 0.88, y + 0.93, high), *stream.pick(&colors)));
                }
            }
        }
        2 => {
            for layer in 0..3 {
                for i in 0..(7 - layer) {
                    let (y, h) = (-0.72 + 0.12 * layer as f32 + 0.24 * i as f32, z + 0.12 + 0.205 * layer as f32);
                    s.add(Sculpt::tube(&[(v(x0, y, h), 0.115), (v(x1, y, h), 0.115)], 12, paint::PIPE));
                }
            }
        }
        3 => {
            for k in 0..3 {
                let (h, y) = (z + 0.28 * k as f32, stream.range_f32(-0.04, 0.04));
                s.add(block(v(x0 + 0.2, y - 0.9, h), v(x1 - 0.2, y + 0.9, h + 0.24), paint::WOOD));
            }
        }
        _ => {}
    }
    s
}

/// Fuel or milk.
pub(crate) fn tanker(draw: &DesignDraw) -> VehicleBlueprint {
    let length = draw.range("length", 7.3, 7.9);
    let (steel, top) = (draw.chance("bright tank", 0.5), draw.range("tank", 2.62, 2.85));
    let lorry = Lorry { length, cab: Cab::Day, rear_axles_d: vec![0.72 * length], height: top + 0.10 };
    let blueprint = lorry.blueprint(move |lorry| {
        let (x0, x1, z0) = (-lorry.length + 0.05, lorry.body_front() - 0.02, FRAME_Z + 0.06);
        let (z, h) = (0.5 * (z0 + top), 0.5 * (top - z0));
        let skin = if steel { paint::BRIGHT_STEEL } else { paint::CARGO_WHITE };
        let dish = |x: f32, k: f32| (v(x, 0.0, z), Vec2::new((W - 0.02) * k, h * k));
        let path = [
            dish(x0, 0.80),
            dish(x0 + 0.05, 0.93),
            dish(x0 + 0.16, 1.0),
            dish(x1 - 0.16, 1.0),
            dish(x1 - 0.05, 0.93),
            dish(x1, 0.80),
        ];
        let mut s = Sculpt::sweep(&path, Vec3::Y, 32, 2.5, true, skin);
        let band = Region::all().within(Vec3::Z, z + 0.12).beyond(Vec3::Z, z - 0.14);
        s.paint(&band.clone().facing(Vec3::Y, 0.7), paint::BODY);
        s.paint(&band.facing(-Vec3::Y, 0.7), paint::BODY);
        s.add(block(v(x0 + 0.1, 0.5, FRAME_Z), v(x1 - 0.1, 0.62, z0 + 0.15), paint::CHASSIS).both_sides());
        // Man holes, a catwalk with rails, a ladder at the rear.
        for i in 0..4 {
            let x = x0 + 0.7 + (x1 - x0 - 1.4) * i as f32 / 3.0;
            s.add(Sculpt::post(v(x, 0.0, top - 0.04), 0.11, 0.26, 0.25, 16, paint::STEEL));
        }
        s.add(block(v(x0 + 0.2, 0.32, top - 0.02), v(x1 - 0.2, 0.62, top + 0.01), paint::CHASSIS));
        for y in [-0.18, 0.18] {
            s.add(Sculpt::tube(
                &[(v(x0 - 0.05, y + 0.4, 0.7), 0.018), (v(x0 - 0.05, y + 0.4, top + 0.05), 0.018)],
                6,
                paint::STEEL,
            ));
        }
        for i in 0..6 {
            let h = 0.85 + 0.3 * i as f32;
            s.add(Sculpt::tube(&[(v(x0 - 0.05, 0.22, h), 0.012), (v(x0 - 0.05, 0.58, h), 0.012)], 6, paint::STEEL));
        }
        for x in [-1.0, 0.2, 1.4] {
            let x = 0.5 * (x0 + x1) + x;
            let placard = Region::side(&rect(x, x + 0.3, z + 0.3, z + 0.6).map(Vec2::from)).facing(Vec3::Y, 0.5);
            if x < 0.5 * (x0 + x1) - 0.5 {
                s.paint_both(&placard, paint::ORANGE);
            }
        }
        s
    });
    blueprint.scaled(draw.range("scale", 1.0, 1.06))
}

/// A concrete mixer on three axles.
pub(crate) fn mixer(draw: &DesignDraw) -> VehicleBlueprint {
    let length = draw.range("length", 7.5, 7.9);
    let striped = draw.chance("striped drum", 0.6);
    let lorry = Lorry { length, cab: Cab::Day, rear_axles_d: vec![4.05, 5.2], height: 3.42 };
    let blueprint = lorry.blueprint(move |lorry| {
        let (x0, x1) = (-lorry.length, lorry.body_front());
        // The drum lies on a pedestal behind the cab and rises to its mouth.
        let profile = [
            (0.0, 0.0),
            (0.55, 0.02),
            (0.72, 0.12),
            (1.13, 1.25),
            (1.15, 1.75),
            (1.12, 2.1),
            (0.62, 3.95),
            (0.55, 4.1),
            (0.50, 4.1),
            (0.44, 3.7),
            (0.0, 3.6),
        ];
        let mut drum = Sculpt::lathe(&profile, 32, 35.0, if striped { paint::CARGO_WHITE } else { paint::BODY });
        if striped {
            let turn = Affine3A::from_axis_angle(Vec3::new(0.35, 0.0, 0.94).normalize(), 0.0);
            for (a, b) in [(0.7, 1.05), (1.5, 1.85), (2.35, 2.7)] {
                let slanted = Vec3::new(0.22, 0.0, 1.0).normalize();
                drum.paint(&Region::all().beyond(slanted, a).within(slanted, b), paint::BODY);
            }
            drum = drum.placed(turn);
        }
        let tilt = Quat::from_rotation_y(-std::f32::consts::FRAC_PI_2 + 0.21);
        let foot = v(x1 - 0.42, 0.0, 1.88);
        let mut s = drum.placed(Affine3A::from_rotation_translation(tilt, foot));
        s.add(block(v(x1 - 0.75, -0.55, FRAME_Z), v(x1 - 0.25, 0.55, 1.75), paint::STEEL));
        s.add(block(v(x1 - 0.3, -0.95, FRAME_Z + 0.1), v(x1 - 0.05, 0.95, 2.1), paint::CARGO_WHITE));
        let rear = x0 + 0.75;
        s.add(block(v(rear, 0.42, FRAME_Z), v(rear + 0.12, 0.54, 2.25), paint::CHASSIS).both_sides());
        s.add(block(v(rear, -0.54, 1.98), v(rear + 0.12, 0.54, 2.1), paint::CHASSIS));
        // Hopper above, chute below, ladder at the side.
        s.add(Sculpt::sweep(
            &[(v(x0 + 0.55, 0.0, 2.75), Vec2::new(0.32, 0.28)), (v(x0 + 0.42, 0.0, 3.36), Vec2::new(0.55, 0.42))],
            Vec3::Y,
            16,
            3.5,
            true,
            paint::STEEL,
        ));
        s.add(Sculpt::sweep(
            &[
                (v(x0 + 0.45, 0.0, 2.35), Vec2::new(0.22, 0.05)),
                (v(x0 + 0.30, 0.25, 1.75), Vec2::new(0.26, 0.05)),
                (v(x0 + 0.15, 0.62, 1.18), Vec2::new(0.24, 0.05)),
            ],
            Vec3::Y,
            10,
            3.0,
            true,
            paint::STEEL,
        ));
        s.add(block(v(x0 + 0.1, 0.9, 0.95), v(x0 + 0.85, 1.15, 1.0), paint::CHASSIS).both_sides());
        s.add(block(v(x0 + 0.9, 1.02, 0.92), v(x1 - 0.9, 1.18, 1.02), paint::CHASSIS).both_sides());
        s
    });
    blueprint.scaled(draw.range("scale", 1.02, 1.06))
}

/// What pulls semi-trailers, without one.
pub(crate) fn tractor(draw: &DesignDraw) -> VehicleBlueprint {
    tractor_unit(draw).0.scaled(draw.range("scale", 1.02, 1.06))
}

/// A tractor before it is scaled, and x of its fifth wheel.
pub(super) fn tractor_unit(draw: &DesignDraw) -> (VehicleBlueprint, f32) {
    let length = draw.range("length", 5.45, 5.75);
    let three = draw.chance("three axles", 0.3);
    let rear_axles_d = if three { vec![4.0, 4.98] } else { vec![4.55] };
    let fifth_wheel = -rear_axles_d[0];
    let fairing = draw.chance("fairing", 0.7);
    let height = CAB_TOP + 0.62;
    let lorry = Lorry { length, cab: Cab::Sleeper, rear_axles_d, height };
    let blueprint = lorry.blueprint(move |lorry| {
        let x1 = lorry.body_front() + 0.06;
        let last = lorry.rear_axles_d[0];
        let mut s = Sculpt::post(v(-last, 0.0, FRAME_Z + 0.02), 0.14, 0.46, 0.44, 24, paint::CHASSIS);
        s.add(block(v(-last - 0.55, -0.2, FRAME_Z), v(-last + 0.5, 0.2, FRAME_Z + 0.08), paint::CHASSIS));
        s.add(block(v(x1 - 0.62, -0.4, FRAME_Z), v(x1 - 0.1, 0.4, FRAME_Z + 0.04), paint::STEEL));
        if fairing {
            s.add(
                block(v(x1 - 0.5, 1.02, FRAME_Z - 0.2), v(x1 - 0.02, 1.10, CAB_TOP + 0.45), paint::BODY).both_sides(),
            );
            s.add(block(v(x1 - 1.3, 1.05, 0.45), v(x1 - 0.02, 1.12, FRAME_Z), paint::BODY).both_sides());
        }
        for (x, half) in [(-last - 0.75, 0.32), (-last + 0.72, 0.32)] {
            s.add(
                block(v(x - 0.03, 1.13 - 2.0 * half * 0.5, 0.95), v(x + 0.03, 1.15, 0.99), paint::RUBBER).both_sides(),
            );
        }
        s
    });
    (blueprint, fifth_wheel)
}

/// Collects household waste from behind.
pub(crate) fn refuse(draw: &DesignDraw) -> VehicleBlueprint {
    let length = draw.range("length", 7.5, 8.1);
    let top = draw.range("height", 3.05, 3.25);
    let lorry = Lorry { length, cab: Cab::Day, rear_axles_d: vec![4.35, 5.5], height: top };
    let blueprint = lorry.blueprint(move |lorry| {
        let (x0, x1, z0) = (-lorry.length, lorry.body_front() + 0.02, FRAME_Z + 0.06);
        let tail = x0 + 1.75;
        let mut s = Sculpt::cuboid(v(tail - 0.05, -W + 0.03, z0), v(x1, W - 0.03, top), 0.16, paint::CARGO_WHITE);
        let sides = Region::all().beyond(Vec3::Z, z0 + 0.55).within(Vec3::Z, top - 0.5);
        s.paint(&sides.clone().facing(Vec3::Y, 0.9), paint::BODY);
        s.paint(&sides.facing(-Vec3::Y, 0.9), paint::BODY);
        for i in 0..5 {
            let x = tail + (x1 - 0.2 - tail) * i as f32 / 4.0;
            s.add(block(v(x, W - 0.05, z0 + 0.1), v(x + 0.1, W, top - 0.2), paint::STEEL).both_sides());
        }
        // The loader: a hopper whose upper half leans out.
        let hopper = [
            (x0 + 0.25, 0.62),
            (tail, 0.72),
            (tail, top - 0.06),
            (tail - 0.5, top - 0.02),
            (x0 + 0.42, top - 0.55),
            (x0 + 0.12, 1.85),
            (x0 + 0.62, 1.62),
            (x0 + 0.55, 1.22),
            (x0 + 0.06, 1.12),
        ];
        s.add(Sculpt::slab(&hopper.map(Vec2::from), -W + 0.06, W - 0.06, 25.0, paint::CARGO_WHITE));
        s.add(block(v(x0 + 0.58, -W + 0.14, 1.2), v(x0 + 0.66, W - 0.14, 1.66), paint::DARK));
        let chevron = Region::all().within(Vec3::X, x0 + 0.4).within(Vec3::Z, 1.14).facing(-Vec3::X, 0.2);
        s.paint(&chevron, paint::YELLOW);
        // Lifting arms, footboards, handles, beacons.
        s.add(
            Sculpt::tube(&[(v(x0 + 0.5, W - 0.02, 2.5), 0.05), (v(x0 + 0.35, W - 0.02, 1.3), 0.06)], 8, paint::STEEL)
                .both_sides(),
        );
        s.add(block(v(x0, 0.72, 0.46), v(x0 + 0.3, 1.14, 0.50), paint::STEEL).both_sides());
        for y in [-0.9, 0.9] {
            s.add(Sculpt::post(v(x0 + 0.75, y, top - 0.42), 0.16, 0.07, 0.06, 10, paint::AMBER_LIGHT));
        }
        s.add(Sculpt::cuboid(v(-0.95, -0.5, CAB_TOP - 0.02), v(-0.75, 0.5, CAB_TOP + 0.10), 0.03, paint::AMBER_LIGHT));
        s
    });
    blueprint.scaled(draw.range("scale", 1.02, 1.06))
}
