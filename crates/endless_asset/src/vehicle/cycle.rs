//! Bicycle.

use super::VehicleSpec;
use super::assemble::{Assembly, Built, RiderFit};
use super::paint;
use super::wheel::{Rim, wheel};
use crate::Material;
use crate::shape::Sculpt;
use endless_world::ObjectClass;
use glam::{Affine3A, Quat, Vec2, Vec3};
use std::f32::consts::FRAC_PI_2;

const fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

fn rod(a: Vec3, b: Vec3, radius: f32, material: Material) -> Sculpt {
    Sculpt::tube(&[(a, radius), (b, radius)], 8, material)
}

/// A city bicycle with mudguards and a rack.
pub(crate) fn all() -> Vec<Built> {
    let r = 0.345;
    let (front, rear) = (0.54, -0.52);
    let crank = v(-0.08, 0.0, 0.29);
    let seat = v(-0.27, 0.0, 0.90);
    let head = v(0.37, 0.0, 0.86);
    let mut s = Sculpt::new();
    let tubes = [
        (crank, seat - v(0.0, 0.0, 0.07), 0.017),
        (head - v(0.0, 0.0, 0.10) * 0.6, crank, 0.020),
        (head, v(-0.235, 0.0, 0.78), 0.017),
    ];
    for (a, b, radius) in tubes {
        s.add(rod(a, b, radius, paint::BODY));
    }
    s.add(rod(crank, v(rear, 0.045, r), 0.011, paint::BODY).both_sides());
    s.add(rod(v(-0.235, 0.0, 0.78), v(rear, 0.045, r), 0.009, paint::BODY).both_sides());
    s.add(
        Sculpt::tube(
            &[(v(front, 0.045, r), 0.010), (v(0.46, 0.045, 0.56), 0.013), (v(0.42, 0.02, 0.72), 0.016)],
            8,
            paint::BODY,
        )
        .both_sides(),
    );
    s.add(rod(v(0.42, 0.0, 0.70), v(0.345, 0.0, 0.98), 0.017, paint::BODY));
    // Handlebar, grips, bell, lamp.
    let grip = v(0.22, 0.27, 1.04);
    s.add(
        Sculpt::tube(
            &[
                (v(0.35, 0.0, 0.99), 0.012),
                (v(0.38, 0.12, 1.03), 0.012),
                (v(0.30, 0.27, 1.045), 0.012),
                (grip - v(0.06, 0.0, 0.0), 0.012),
            ],
            8,
            paint::STEEL,
        )
        .both_sides(),
    );
    s.add(rod(grip + v(0.05, 0.0, 0.0), grip - v(0.07, 0.0, 0.0), 0.018, paint::RUBBER).both_sides());
    s.add(Sculpt::ellipsoid(v(0.44, 0.0, 0.84), v(0.035, 0.032, 0.03), 10, paint::WHITE));
    // Saddle.
    s.add(Sculpt::sweep(
        &[
            (seat + v(0.16, 0.0, 0.005), Vec2::new(0.015, 0.012)),
            (seat + v(0.08, 0.0, 0.01), Vec2::new(0.032, 0.025)),
            (seat + v(-0.05, 0.0, 0.015), Vec2::new(0.085, 0.032)),
            (seat + v(-0.12, 0.0, 0.02), Vec2::new(0.075, 0.022)),
        ],
        Vec3::Y,
        12,
        2.2,
        true,
        paint::SEAT,
    ));
    s.add(rod(seat - v(0.0, 0.0, 0.10), seat, 0.013, paint::STEEL));
    // Chain wheel, cranks, pedals, chain.
    let ring = Sculpt::post(v(0.0, 0.0, -0.004), 0.008, 0.095, 0.095, 20, paint::STEEL);
    let upright = Affine3A::from_rotation_translation(Quat::from_rotation_x(FRAC_PI_2), crank - v(0.0, 0.05, 0.0));
    s.add(ring.placed(upright));
    for (y, z) in [(0.09f32, -0.165f32), (-0.09, 0.165)] {
        let pedal = crank + v(0.035 * y.signum(), y, z);
        s.add(rod(crank + v(0.0, y * 0.75, 0.0), pedal, 0.011, paint::STEEL));
        let side = 0.055 * y.signum();
        s.add(Sculpt::cuboid(
            pedal + v(-0.045, side - 0.045, -0.012),
            pedal + v(0.045, side + 0.045, 0.012),
            0.0,
            paint::TRIM,
        ));
    }
    for z in [0.088, -0.04] {
        s.add(rod(crank + v(0.0, -0.05, z), v(rear, -0.05, r + z * 0.4), 0.005, paint::CHASSIS));
    }
    // Mudguards and rack.
    for (x, from, to) in [(front, 30.0f32, 190.0f32), (rear, 20.0, 180.0)] {
        let path: Vec<(Vec3, Vec2)> = (0..=10)
            .map(|i| {
                let (sin, cos) = endless_world::math::sin_cos((from + (to - from) * i as f32 / 10.0).to_radians());
                (v(x + cos * (r + 0.022), 0.0, r + sin * (r + 0.022)), Vec2::new(0.026, 0.006))
            })
            .collect();
        s.add(Sculpt::sweep(&path, Vec3::Y, 6, 2.0, true, paint::TRIM));
    }
    s.add(rod(v(-0.30, 0.06, 0.745), v(-0.74, 0.06, 0.745), 0.007, paint::STEEL).both_sides());
    s.add(rod(v(rear, 0.06, r), v(-0.62, 0.06, 0.745), 0.006, paint::STEEL).both_sides());
    for i in 0..4 {
        let x = -0.36 - 0.12 * i as f32;
        s.add(rod(v(x, -0.06, 0.745), v(x, 0.06, 0.745), 0.006, paint::STEEL));
    }
    s.add(Sculpt::cuboid(v(-0.775, -0.035, 0.70), v(-0.755, 0.035, 0.74), 0.006, paint::TAIL));
    let spec = VehicleSpec {
        cruise_mps: 4.8,
        acceleration_mps2: 0.9,
        frequency: 3.0,
        parks: false,
        ridden: true,
        ..VehicleSpec::blank("bicycle.city", ObjectClass::Bicycle)
    };
    let mut a = Assembly::new(spec, s, wheel(r, 0.04, 0.91, Rim::Wire, paint::STEEL), r);
    a.single(front, true);
    a.single(rear, false);
    a.fit = Some(RiderFit {
        seat: seat + v(-0.03, 0.0, 0.03),
        grip,
        foot: crank + v(0.035, 0.145, -0.15),
        right_foot: v(-0.07, 0.0, 0.33),
        lean_rad: 0.30,
        helmet: 0.55,
    });
    vec![a.finish(0.60)]
}
