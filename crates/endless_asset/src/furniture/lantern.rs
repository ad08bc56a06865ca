//! Lamps of old towns, squares, parks and wide roads.

use super::lamp::pole;
use super::paint;
use crate::shape::Sculpt;
use endless_scene::{Material, Surface};
use endless_world::ClassTag;
use glam::{Vec2, Vec3};

const IRON: Material = Material::new(Surface::Painted, [0.022, 0.028, 0.026], ClassTag::Poles);

/// A cast-iron post with a four-sided lantern; lens at 3.75 m.
pub(crate) fn lantern_post() -> Sculpt {
    let profile = [
        (0.0, 0.0),
        (0.20, 0.0),
        (0.20, 0.10),
        (0.15, 0.16),
        (0.14, 0.55),
        (0.10, 0.62),
        (0.12, 0.70),
        (0.065, 0.78),
        (0.052, 2.0),
        (0.075, 2.03),
        (0.075, 2.09),
        (0.05, 2.12),
        (0.042, 3.15),
        (0.085, 3.20),
        (0.085, 3.25),
        (0.035, 3.30),
        (0.035, 3.42),
        (0.0, 3.42),
    ];
    let mut s = Sculpt::lathe(&profile, 14, 32.0, IRON);
    // The ladder's bar.
    s.add(Sculpt::tube(
        &[(Vec3::Y * -0.32 + Vec3::Z * 3.08, 0.014), (Vec3::Y * 0.32 + Vec3::Z * 3.08, 0.014)],
        8,
        IRON,
    ));
    let four = |profile: &[(f32, f32)], m: Material| Sculpt::lathe(profile, 4, 20.0, m);
    s.add(four(&[(0.0, 3.40), (0.15, 3.42), (0.16, 3.46), (0.0, 3.47)], IRON));
    s.add(four(&[(0.0, 3.47), (0.145, 3.47), (0.235, 4.02), (0.0, 4.03)], paint::LAMP));
    for k in 0..4 {
        let (sin, cos) = endless_world::math::sin_cos(std::f32::consts::FRAC_PI_2 * k as f32);
        let out = Vec3::new(cos, sin, 0.0);
        s.add(Sculpt::tube(&[(out * 0.152 + Vec3::Z * 3.45, 0.013), (out * 0.245 + Vec3::Z * 4.03, 0.013)], 6, IRON));
    }
    s.add(four(&[(0.0, 4.02), (0.29, 4.02), (0.28, 4.06), (0.10, 4.22), (0.09, 4.28), (0.0, 4.29)], IRON));
    s.add(Sculpt::ellipsoid(Vec3::Z * 4.33, Vec3::new(0.035, 0.035, 0.06), 8, IRON));
    s
}

/// An opal globe, or a disc, on a slender post; lens at 3.6 m.
pub(crate) fn park_lamp(variant: u32) -> Sculpt {
    let mut s = pole(3.4, 0.055, 0.045, paint::DARK_POLE);
    if variant.is_multiple_of(2) {
        s.add(Sculpt::lathe(&[(0.0, 3.36), (0.11, 3.38), (0.11, 3.42), (0.0, 3.43)], 14, 30.0, paint::DARK_POLE));
        s.add(Sculpt::ellipsoid(Vec3::Z * 3.64, Vec3::splat(0.23), 20, paint::LAMP));
    } else {
        s.add(Sculpt::post(Vec3::Z * 3.40, 0.22, 0.10, 0.10, 16, paint::LAMP));
        s.add(Sculpt::lathe(
            &[(0.0, 3.62), (0.38, 3.64), (0.38, 3.67), (0.12, 3.78), (0.0, 3.79)],
            24,
            35.0,
            paint::DARK_POLE,
        ));
    }
    s
}

/// Ten metres with an arm to either side along x, lenses at (±2.1, 0, 9.9).
pub(crate) fn double_lamp() -> Sculpt {
    let mut s = pole(9.6, 0.11, 0.07, paint::POLE);
    let arm: Vec<(Vec3, f32)> = [(0.0, 9.3), (0.10, 9.62), (0.45, 9.86), (1.0, 9.95), (1.8, 9.99)]
        .iter()
        .map(|&(x, z)| (Vec3::new(x, 0.0, z), 0.045 - 0.008 * x))
        .collect();
    let mut side = Sculpt::tube(&arm, 10, paint::POLE);
    let head = [
        (Vec3::new(1.70, 0.0, 9.985), Vec2::new(0.06, 0.035)),
        (Vec3::new(1.85, 0.0, 9.985), Vec2::new(0.13, 0.04)),
        (Vec3::new(2.35, 0.0, 9.97), Vec2::new(0.13, 0.035)),
        (Vec3::new(2.45, 0.0, 9.965), Vec2::new(0.05, 0.015)),
    ];
    side.add(Sculpt::sweep(&head, Vec3::Y, 12, 4.0, true, paint::DARK_POLE));
    side.add(Sculpt::cuboid(Vec3::new(1.88, -0.10, 9.915), Vec3::new(2.32, 0.10, 9.94), 0.01, paint::LAMP));
    let other = side.clone().placed(glam::Affine3A::from_rotation_z(std::f32::consts::PI));
    s.add(side);
    s.add(other);
    s
}

/// Twenty metres with a ring of floodlights.
pub(crate) fn high_mast() -> Sculpt {
    let mut s = pole(19.6, 0.26, 0.11, paint::POLE);
    s.add(Sculpt::post(Vec3::ZERO, 0.35, 0.55, 0.55, 18, paint::CONCRETE));
    s.add(Sculpt::post(Vec3::Z * 19.3, 0.5, 0.28, 0.28, 14, paint::DARK_POLE));
    for k in 0..6 {
        let turn = glam::Affine3A::from_rotation_z(std::f32::consts::TAU * k as f32 / 6.0);
        let mut arm =
            Sculpt::tube(&[(Vec3::new(0.2, 0.0, 19.5), 0.03), (Vec3::new(0.95, 0.0, 19.5), 0.03)], 6, paint::POLE);
        arm.add(Sculpt::cuboid(Vec3::new(0.85, -0.26, 19.30), Vec3::new(1.35, 0.26, 19.55), 0.03, paint::DARK_POLE));
        arm.add(Sculpt::cuboid(Vec3::new(0.90, -0.21, 19.27), Vec3::new(1.30, 0.21, 19.295), 0.0, paint::LAMP));
        s.add(arm.placed(turn));
    }
    s
}
