//! Vehicles that draw trailers: lorries with semi-trailers, cars with a trailer.

use super::assemble::{HitchMeasures, VehicleBlueprint};
use super::car::plate;
use super::draw::DesignDraw;
use super::heavy::tractor_unit;
use super::lorry::FRAME_Z;
use super::truck::closed_box;
use super::{cars, paint};
use crate::shape::Sculpt;
use endless_scene::Material;
use glam::Vec3;

/// From the kingpin to the front and the rear of a semi-trailer, and to its axles, before scaling, metres.
const AHEAD_M: f32 = 1.25;
const BEHIND_M: f32 = 11.55;
const AXLES_M: [f32; 3] = [6.25, 7.5, 8.75];

const fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

fn block(low: Vec3, high: Vec3, material: Material) -> Sculpt {
    Sculpt::cuboid(low, high, 0.0, material)
}

/// A tractor with a semi-trailer of three axles: a box, or curtains in the lorry's colour.
pub(crate) fn semi(draw: &DesignDraw) -> VehicleBlueprint {
    let (tractor, kingpin) = tractor_unit(draw);
    let curtain = draw.chance("curtain sides", 0.55);
    let top = draw.range("height of the trailer", 3.70, 3.82);
    let joint = HitchMeasures {
        hitch: kingpin,
        axle: kingpin - AXLES_M[1],
        front: kingpin + AHEAD_M,
        towing_rear: tractor.size.rear,
    };
    let rear = kingpin - BEHIND_M;
    let blueprint = tractor.towing(joint, rear - 0.03, top, move || {
        let mut body = closed_box(-rear, kingpin + AHEAD_M, FRAME_Z + 0.22, top, curtain);
        body.add(undercarriage(kingpin, rear));
        let wheels = AXLES_M.map(|d| (kingpin - d, 0.98));
        (body, wheels.to_vec())
    });
    blueprint.scaled(draw.range("scale", 1.02, 1.05))
}

/// Rails, legs, axles, guards, bumper and lamps of a semi-trailer.
fn undercarriage(kingpin: f32, rear: f32) -> Sculpt {
    let floor = FRAME_Z + 0.22;
    let mut s = block(v(rear + 0.1, 0.36, 0.92), v(kingpin - 1.0, 0.48, floor), paint::CHASSIS).both_sides();
    // The plate above the fifth wheel.
    s.add(block(v(kingpin - 1.0, -0.9, floor - 0.1), v(kingpin + AHEAD_M - 0.1, 0.9, floor), paint::CHASSIS));
    // Legs, wound up while it is drawn.
    s.add(block(v(kingpin - 2.45, 0.62, 0.55), v(kingpin - 2.3, 0.76, floor), paint::STEEL).both_sides());
    for d in AXLES_M {
        let x = kingpin - d;
        s.add(block(v(x - 0.07, -0.9, 0.37), v(x + 0.07, 0.9, 0.51), paint::CHASSIS));
    }
    for z in [0.50, 0.76] {
        let guard = block(v(kingpin - AXLES_M[0] + 0.62, 1.12, z), v(kingpin - 2.8, 1.15, z + 0.11), paint::STEEL);
        s.add(guard.both_sides());
    }
    s.add(block(v(kingpin - 4.6, 0.45, 0.5), v(kingpin - 3.2, 1.1, 0.9), paint::CHASSIS).mirrored());
    for x in [kingpin - AXLES_M[0] + 0.55, kingpin - AXLES_M[2] - 0.57] {
        s.add(block(v(x, 0.78, 0.42), v(x + 0.02, 1.16, 0.95), paint::RUBBER).both_sides());
    }
    s.add(Sculpt::cuboid(v(rear, -1.16, 0.48), v(rear + 0.10, 1.16, 0.64), 0.02, paint::CHASSIS));
    let lamp =
        |y0: f32, y1: f32, m: Material| Sculpt::cuboid(v(rear - 0.015, y0, 0.94), v(rear + 0.05, y1, 1.10), 0.012, m);
    s.add(block(v(rear, -1.14, 0.9), v(rear + 0.12, 1.14, 1.14), paint::CHASSIS));
    s.add(lamp(0.88, 1.12, paint::TAIL).both_sides());
    s.add(lamp(0.74, 0.87, paint::LEFT));
    s.add(lamp(0.74, 0.87, paint::RIGHT).mirrored());
    s.add(lamp(0.62, 0.73, paint::REVERSE).both_sides());
    plate(&mut s, v(rear, 0.0, 1.02), -1.0);
    s
}

/// A car with a trailer of one axle: open, or under a cover.
pub(crate) fn car_with_trailer(draw: &DesignDraw) -> VehicleBlueprint {
    let car = cars::estate(draw);
    let rear = car.size.rear;
    let (hitch, z0) = (rear - 0.10, 0.52);
    let long = draw.range("trailer length", 2.0, 2.5);
    let covered = draw.chance("covered", 0.6);
    let top = if covered { draw.range("cover", 1.35, 1.6) } else { z0 + 0.42 };
    let (front, end) = (hitch - 1.05, hitch - 1.05 - long);
    let axle = front - 0.56 * long;
    let joint = HitchMeasures { hitch, axle, front: hitch + 0.06, towing_rear: rear };
    let half = draw.range("trailer half width", 0.60, 0.66);
    let wheel_y = half + 0.17;
    car.towing(joint, end - 0.03, top, move || {
        let mut s =
            Sculpt::tube(&[(v(front + 0.05, 0.0, z0 + 0.02), 0.035), (v(hitch, 0.0, 0.46), 0.03)], 8, paint::STEEL);
        s.add(
            Sculpt::tube(
                &[(v(front - 0.2, half - 0.1, z0), 0.03), (v(hitch - 0.4, 0.02, 0.49), 0.03)],
                8,
                paint::STEEL,
            )
            .both_sides(),
        );
        s.add(Sculpt::cuboid(v(hitch - 0.14, -0.05, 0.43), v(hitch + 0.06, 0.05, 0.53), 0.015, paint::CHASSIS));
        // A trough of sheet metal.
        let wall = 0.03;
        s.add(block(v(end, -half, z0), v(front, half, z0 + 0.04), paint::BRIGHT_STEEL));
        s.add(block(v(end, half - wall, z0 + 0.04), v(front, half, z0 + 0.42), paint::BRIGHT_STEEL).both_sides());
        for (a, b) in [(end, end + wall), (front - wall, front)] {
            s.add(block(v(a, -half + wall, z0 + 0.04), v(b, half - wall, z0 + 0.42), paint::BRIGHT_STEEL));
        }
        if covered {
            let cover = Sculpt::cuboid(
                v(end - 0.005, -half - 0.005, z0 + 0.30),
                v(front + 0.005, half + 0.005, top),
                0.06,
                paint::BLUE,
            );
            s.add(cover);
        }
        let tyre = v(axle, wheel_y, 0.31);
        s.add(block(tyre + v(-0.42, -0.12, 0.36), tyre + v(0.42, 0.13, 0.39), paint::TRIM).both_sides());
        for x in [-0.42, 0.39] {
            s.add(block(tyre + v(x, -0.12, 0.10), tyre + v(x + 0.03, 0.13, 0.36), paint::TRIM).both_sides());
        }
        s.add(block(v(axle - 0.03, -wheel_y, 0.28), v(axle + 0.03, wheel_y, 0.34), paint::CHASSIS));
        s.add(block(v(end - 0.01, -half - 0.06, z0 - 0.08), v(end + 0.05, half + 0.06, z0 + 0.04), paint::CHASSIS));
        let lamp = |y0: f32, y1: f32, m: Material| {
            Sculpt::cuboid(v(end - 0.03, y0, z0 - 0.06), v(end, y1, z0 + 0.03), 0.01, m)
        };
        s.add(lamp(half - 0.08, half + 0.05, paint::TAIL).both_sides());
        s.add(lamp(half - 0.19, half - 0.09, paint::LEFT));
        s.add(lamp(half - 0.19, half - 0.09, paint::RIGHT).mirrored());
        plate(&mut s, v(end, 0.0, z0 + 0.14), -1.0);
        (s, vec![(axle, wheel_y)])
    })
}
