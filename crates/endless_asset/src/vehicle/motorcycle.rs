//! Commuter motorcycle and scooter.

use super::VehicleSpec;
use super::assemble::{Assembly, Built, RiderFit};
use super::paint;
use super::wheel::{Rim, wheel};
use crate::Material;
use crate::shape::{Region, Sculpt};
use endless_world::ObjectClass;
use glam::{Vec2, Vec3};

/// Both.
pub(crate) fn all() -> Vec<Built> {
    vec![commuter(), scooter()]
}

const fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

fn spec(name: &'static str, frequency: f64, cruise_mps: f32) -> VehicleSpec {
    VehicleSpec {
        cruise_mps,
        acceleration_mps2: 2.4,
        frequency,
        parks: true,
        ridden: true,
        ..VehicleSpec::blank(name, ObjectClass::Motorcycle)
    }
}

fn rod(a: Vec3, b: Vec3, radius: f32, material: Material) -> Sculpt {
    Sculpt::tube(&[(a, radius), (b, radius)], 8, material)
}

/// A flat-sided smooth body along a path: half width and half height a point.
fn hull(path: &[(Vec3, f32, f32)], material: Material) -> Sculpt {
    let sections: Vec<(Vec3, Vec2)> = path.iter().map(|&(p, w, h)| (p, Vec2::new(w, h))).collect();
    Sculpt::sweep(&sections, Vec3::Y, 14, 2.6, true, material)
}

/// A curved sheet over a wheel, from one angle to another (0 = ahead, 90 = above).
fn mudguard(centre: Vec3, radius: f32, half_width: f32, from_deg: f32, to_deg: f32, material: Material) -> Sculpt {
    let n = 8;
    let path: Vec<(Vec3, Vec2)> = (0..=n)
        .map(|i| {
            let angle = (from_deg + (to_deg - from_deg) * i as f32 / n as f32).to_radians();
            let (sin, cos) = endless_world::math::sin_cos(angle);
            (centre + v(cos, 0.0, sin) * radius, Vec2::new(half_width, 0.012))
        })
        .collect();
    Sculpt::sweep(&path, Vec3::Y, 8, 2.0, true, material)
}

fn mirrors_and_bars(s: &mut Sculpt, stem: Vec3, grip: Vec3) {
    let bend = v(stem.x + 0.02, 0.16, grip.z + 0.015);
    s.add(Sculpt::tube(&[(stem, 0.013), (bend, 0.013), (grip, 0.013)], 8, paint::CHROME).both_sides());
    s.add(rod(grip - v(-0.02, 0.07, 0.0), grip + v(-0.02, 0.07, 0.0), 0.019, paint::RUBBER).both_sides());
    s.add(rod(grip + v(0.05, -0.05, -0.01), grip + v(0.05, 0.08, -0.02), 0.006, paint::STEEL).both_sides());
    let top = grip + v(0.02, 0.03, 0.22);
    s.add(rod(grip + v(0.02, -0.10, 0.0), top, 0.006, paint::TRIM).both_sides());
    let mut glass = Sculpt::ellipsoid(top + v(0.0, 0.02, 0.02), v(0.022, 0.062, 0.042), 10, paint::TRIM);
    glass.paint(&Region::all().facing(-Vec3::X, 0.75), paint::CHROME);
    s.add(glass.both_sides());
}

fn indicators(s: &mut Sculpt, at: Vec3) {
    let lens = |m: Material| Sculpt::ellipsoid(at, v(0.03, 0.03, 0.022), 8, m);
    s.add(lens(paint::LEFT));
    s.add(lens(paint::RIGHT).mirrored());
    s.add(rod(v(at.x, 0.02, at.z), at, 0.008, paint::TRIM).both_sides());
}

fn commuter() -> Built {
    let r = 0.295;
    let (front, rear) = (0.66, -0.65);
    let mut s = Sculpt::new();
    // Fork, with its headlamp and clocks.
    let head = v(0.40, 0.0, 0.92);
    s.add(rod(v(front, 0.075, r), v(0.425, 0.075, 0.90), 0.024, paint::STEEL).both_sides());
    s.add(rod(v(front, 0.075, r), v(0.545, 0.075, 0.60), 0.031, paint::ENGINE).both_sides());
    s.add(Sculpt::cuboid(head - v(0.04, 0.11, 0.03), head + v(0.05, 0.11, 0.02), 0.015, paint::ENGINE));
    let mut lamp = Sculpt::ellipsoid(v(0.50, 0.0, 0.86), v(0.10, 0.095, 0.095), 16, paint::BODY);
    lamp.paint(&Region::all().beyond(Vec3::X, 0.535), paint::HEAD);
    s.add(lamp);
    s.add(hull(
        &[(v(0.52, 0.0, 0.94), 0.07, 0.02), (v(0.44, 0.0, 1.02), 0.10, 0.03), (v(0.38, 0.0, 1.03), 0.08, 0.02)],
        paint::TRIM,
    ));
    s.add(mudguard(v(front, 0.0, r), r + 0.04, 0.062, 25.0, 165.0, paint::BODY));
    mirrors_and_bars(&mut s, head + v(-0.02, 0.0, 0.06), v(0.28, 0.34, 1.04));
    indicators(&mut s, v(0.44, 0.17, 0.84));
    // Frame, engine, exhaust.
    s.add(Sculpt::tube(
        &[(head, 0.024), (v(0.30, 0.0, 0.60), 0.020), (v(0.22, 0.0, 0.26), 0.020), (v(-0.20, 0.0, 0.24), 0.020)],
        8,
        paint::CHASSIS,
    ));
    s.add(Sculpt::tube(&[(head, 0.028), (v(0.05, 0.0, 0.78), 0.024), (v(-0.55, 0.0, 0.74), 0.018)], 8, paint::CHASSIS));
    s.add(Sculpt::cuboid(v(-0.20, -0.13, 0.24), v(0.16, 0.13, 0.44), 0.05, paint::ENGINE));
    s.add(Sculpt::ellipsoid(v(-0.07, 0.0, 0.34), v(0.13, 0.165, 0.11), 12, paint::ENGINE));
    for i in 0..7 {
        let z = 0.44 + 0.03 * i as f32;
        let x = 0.10 + 0.01 * i as f32;
        s.add(Sculpt::cuboid(v(x - 0.09, -0.085, z), v(x + 0.08, 0.085, z + 0.016), 0.0, paint::ENGINE));
    }
    s.add(Sculpt::cuboid(v(0.04, -0.06, 0.42), v(0.16, 0.06, 0.66), 0.02, paint::CHASSIS));
    let pipe = [
        (v(0.20, -0.05, 0.55), 0.022),
        (v(0.30, -0.10, 0.42), 0.022),
        (v(0.18, -0.13, 0.24), 0.022),
        (v(-0.25, -0.16, 0.22), 0.024),
    ];
    s.add(Sculpt::tube(&pipe, 8, paint::STEEL));
    s.add(Sculpt::tube(
        &[
            (v(-0.25, -0.16, 0.22), 0.030),
            (v(-0.34, -0.17, 0.25), 0.048),
            (v(-0.82, -0.18, 0.36), 0.052),
            (v(-0.86, -0.18, 0.37), 0.03),
        ],
        12,
        paint::CHROME,
    ));
    // Tank, side panels, seat, tail.
    s.add(hull(
        &[
            (v(0.36, 0.0, 0.83), 0.07, 0.05),
            (v(0.28, 0.0, 0.85), 0.125, 0.095),
            (v(0.12, 0.0, 0.855), 0.145, 0.105),
            (v(-0.04, 0.0, 0.83), 0.12, 0.085),
            (v(-0.14, 0.0, 0.80), 0.08, 0.05),
        ],
        paint::BODY,
    ));
    s.add(Sculpt::post(v(0.14, 0.0, 0.955), 0.014, 0.035, 0.03, 12, paint::CHROME));
    s.add(hull(
        &[(v(0.0, 0.0, 0.66), 0.10, 0.09), (v(-0.2, 0.0, 0.66), 0.115, 0.08), (v(-0.42, 0.0, 0.70), 0.09, 0.05)],
        paint::BODY,
    ));
    s.add(hull(
        &[
            (v(-0.08, 0.0, 0.80), 0.07, 0.03),
            (v(-0.18, 0.0, 0.785), 0.12, 0.045),
            (v(-0.40, 0.0, 0.79), 0.135, 0.05),
            (v(-0.62, 0.0, 0.83), 0.11, 0.045),
            (v(-0.74, 0.0, 0.85), 0.07, 0.03),
        ],
        paint::SEAT,
    ));
    s.add(hull(
        &[(v(-0.35, 0.0, 0.715), 0.10, 0.045), (v(-0.62, 0.0, 0.755), 0.09, 0.04), (v(-0.84, 0.0, 0.80), 0.055, 0.028)],
        paint::BODY,
    ));
    s.add(
        Sculpt::tube(
            &[(v(-0.45, 0.13, 0.80), 0.011), (v(-0.80, 0.11, 0.90), 0.011), (v(-0.86, 0.0, 0.91), 0.011)],
            6,
            paint::CHROME,
        )
        .both_sides(),
    );
    s.add(Sculpt::cuboid(v(-0.90, -0.07, 0.735), v(-0.83, 0.07, 0.80), 0.02, paint::TAIL));
    s.add(mudguard(v(rear, 0.0, r), r + 0.05, 0.07, 60.0, 165.0, paint::TRIM));
    s.add(Sculpt::cuboid(v(-0.945, -0.09, 0.50), v(-0.925, 0.09, 0.66), 0.0, paint::PLATE));
    indicators(&mut s, v(-0.84, 0.15, 0.71));
    // Swing arm, shock absorbers, chain case, pegs, stand.
    s.add(rod(v(-0.14, 0.07, 0.38), v(rear, 0.09, r), 0.022, paint::CHASSIS).both_sides());
    s.add(rod(v(rear, 0.12, r), v(-0.45, 0.12, 0.72), 0.030, paint::CHROME).both_sides());
    s.add(Sculpt::cuboid(v(rear - 0.02, 0.085, r - 0.045), v(-0.15, 0.105, r + 0.085), 0.015, paint::CHASSIS));
    s.add(rod(v(-0.02, 0.12, 0.29), v(-0.02, 0.27, 0.29), 0.014, paint::RUBBER).both_sides());
    s.add(rod(v(-0.42, 0.12, 0.36), v(-0.42, 0.23, 0.36), 0.012, paint::RUBBER).both_sides());
    let mut a = Assembly::new(
        spec("motorcycle.commuter", 4.0, 13.5),
        s,
        wheel(r, 0.10, 0.80, Rim::Alloy(6), paint::DARK_ALLOY),
        r,
    );
    a.single(front, true);
    a.single(rear, false);
    a.headlights = vec![v(0.59, 0.0, 0.86)];
    a.fit = Some(RiderFit {
        seat: v(-0.22, 0.0, 0.835),
        grip: v(0.27, 0.34, 1.045),
        foot: v(0.0, 0.20, 0.30),
        right_foot: Vec3::ZERO,
        lean_rad: 0.16,
        helmet: 0.97,
    });
    a.finish(0.78)
}

fn scooter() -> Built {
    let r = 0.225;
    let (front, rear) = (0.62, -0.64);
    let mut s = Sculpt::new();
    s.add(rod(v(front, 0.065, r), v(0.47, 0.065, 0.62), 0.022, paint::STEEL).both_sides());
    s.add(rod(v(0.50, 0.0, 0.55), v(0.40, 0.0, 1.0), 0.03, paint::CHASSIS));
    s.add(mudguard(v(front, 0.0, r), r + 0.035, 0.075, 5.0, 165.0, paint::BODY));
    // Leg shield, from the floor up to the handlebar cowl.
    s.add(hull(
        &[
            (v(0.30, 0.0, 0.28), 0.17, 0.03),
            (v(0.40, 0.0, 0.36), 0.20, 0.05),
            (v(0.46, 0.0, 0.58), 0.215, 0.055),
            (v(0.45, 0.0, 0.76), 0.175, 0.06),
            (v(0.42, 0.0, 0.90), 0.09, 0.05),
        ],
        paint::BODY,
    ));
    s.add(hull(
        &[(v(0.36, 0.0, 0.35), 0.17, 0.03), (v(0.385, 0.0, 0.60), 0.19, 0.03), (v(0.37, 0.0, 0.80), 0.14, 0.03)],
        paint::TRIM,
    ));
    let mut cowl = hull(
        &[
            (v(0.50, 0.0, 0.96), 0.07, 0.05),
            (v(0.43, 0.0, 0.99), 0.14, 0.075),
            (v(0.34, 0.0, 1.0), 0.12, 0.05),
            (v(0.30, 0.0, 1.0), 0.06, 0.03),
        ],
        paint::BODY,
    );
    cowl.paint(&Region::all().beyond(Vec3::X, 0.455).facing(Vec3::X, 0.1).beyond(Vec3::Z, 0.93), paint::HEAD);
    s.add(cowl);
    mirrors_and_bars(&mut s, v(0.36, 0.0, 0.99), v(0.28, 0.32, 1.02));
    indicators(&mut s, v(0.49, 0.15, 0.78));
    // Floor, with the trim of its edges, and the belly.
    s.add(Sculpt::cuboid(v(-0.22, -0.20, 0.24), v(0.36, 0.20, 0.30), 0.03, paint::TRIM));
    s.add(Sculpt::cuboid(v(-0.20, -0.16, 0.17), v(0.30, 0.16, 0.25), 0.04, paint::ENGINE));
    // Seat body, bulging over the engine, and the seat.
    s.add(hull(
        &[
            (v(-0.16, 0.0, 0.47), 0.12, 0.20),
            (v(-0.26, 0.0, 0.50), 0.175, 0.22),
            (v(-0.50, 0.0, 0.56), 0.195, 0.16),
            (v(-0.74, 0.0, 0.63), 0.15, 0.10),
            (v(-0.90, 0.0, 0.68), 0.07, 0.05),
        ],
        paint::BODY,
    ));
    s.add(hull(
        &[
            (v(-0.10, 0.0, 0.72), 0.08, 0.03),
            (v(-0.22, 0.0, 0.735), 0.145, 0.05),
            (v(-0.48, 0.0, 0.745), 0.155, 0.05),
            (v(-0.72, 0.0, 0.775), 0.12, 0.04),
            (v(-0.80, 0.0, 0.785), 0.06, 0.02),
        ],
        paint::SEAT,
    ));
    s.add(Sculpt::cuboid(v(-0.34, 0.03, 0.16), v(-0.70, 0.15, 0.32).max(v(-0.30, 0.15, 0.32)), 0.04, paint::ENGINE));
    s.add(Sculpt::tube(
        &[
            (v(-0.30, -0.12, 0.22), 0.03),
            (v(-0.42, -0.16, 0.25), 0.055),
            (v(-0.80, -0.17, 0.32), 0.058),
            (v(-0.84, -0.17, 0.33), 0.03),
        ],
        12,
        paint::STEEL,
    ));
    s.add(rod(v(rear, 0.13, r), v(-0.62, 0.13, 0.55), 0.026, paint::STEEL).both_sides());
    s.add(Sculpt::cuboid(v(-0.96, -0.10, 0.63), v(-0.86, 0.10, 0.70), 0.025, paint::TAIL));
    indicators(&mut s, v(-0.88, 0.13, 0.66));
    s.add(
        Sculpt::tube(
            &[(v(-0.52, 0.15, 0.78), 0.012), (v(-0.84, 0.12, 0.84), 0.012), (v(-0.90, 0.0, 0.85), 0.012)],
            6,
            paint::CHROME,
        )
        .both_sides(),
    );
    s.add(mudguard(v(rear, 0.0, r), r + 0.05, 0.07, 80.0, 165.0, paint::TRIM));
    s.add(Sculpt::cuboid(v(-0.935, -0.09, 0.42), v(-0.92, 0.09, 0.57), 0.0, paint::PLATE));
    let mut a = Assembly::new(
        spec("motorcycle.scooter", 2.0, 12.0),
        s,
        wheel(r, 0.11, 0.66, Rim::Alloy(5), paint::DARK_ALLOY),
        r,
    );
    a.single(front, true);
    a.single(rear, false);
    a.headlights = vec![v(0.50, 0.0, 0.98)];
    a.fit = Some(RiderFit {
        seat: v(-0.32, 0.0, 0.785),
        grip: v(0.27, 0.32, 1.025),
        foot: v(0.16, 0.13, 0.30),
        right_foot: Vec3::ZERO,
        lean_rad: 0.02,
        helmet: 0.93,
    });
    a.finish(0.74)
}
