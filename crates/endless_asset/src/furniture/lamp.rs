//! Street lamps and plain poles.

use super::paint;
use crate::shape::{Region, Sculpt};
use crate::{Material, Surface};
use endless_world::ClassTag;
use glam::{Vec2, Vec3};

/// A tapered pole with a base plate.
pub(crate) fn pole(height: f32, r0: f32, r1: f32, material: Material) -> Sculpt {
    let mut s =
        Sculpt::cuboid(Vec3::new(-1.9 * r0, -1.9 * r0, 0.0), Vec3::new(1.9 * r0, 1.9 * r0, 0.03), 0.0, material);
    let profile =
        [(r0 * 1.25, 0.0), (r0 * 1.25, 0.9), (r0, 0.96), (r1, height - 0.02), (r1 * 0.6, height), (0.0, height)];
    s.add(Sculpt::lathe(&profile, 14, 30.0, material));
    let door = Region::all().facing(-Vec3::X, 0.9).beyond(Vec3::Z, 0.45).within(Vec3::Z, 0.80);
    s.paint(&door, Material { base_color: material.base_color.map(|c| c * 0.7), ..material });
    s
}

/// Eight metres, arm along +x.
pub(crate) fn street_lamp() -> Sculpt {
    let mut s = pole(7.2, 0.085, 0.055, paint::POLE);
    let arm: Vec<(Vec3, f32)> = [(0.0, 7.1), (0.02, 7.45), (0.14, 7.75), (0.42, 7.92), (0.9, 7.96), (1.7, 7.99)]
        .iter()
        .map(|&(x, z)| (Vec3::new(x, 0.0, z), 0.042 - 0.006 * x))
        .collect();
    s.add(Sculpt::tube(&arm, 10, paint::POLE));
    let head = [
        (Vec3::new(1.62, 0.0, 7.975), Vec2::new(0.05, 0.035)),
        (Vec3::new(1.72, 0.0, 7.975), Vec2::new(0.12, 0.045)),
        (Vec3::new(2.05, 0.0, 7.965), Vec2::new(0.155, 0.045)),
        (Vec3::new(2.30, 0.0, 7.955), Vec2::new(0.12, 0.035)),
        (Vec3::new(2.36, 0.0, 7.95), Vec2::new(0.04, 0.015)),
    ];
    s.add(Sculpt::sweep(&head, Vec3::Y, 14, 2.8, true, paint::DARK_POLE));
    s.add(Sculpt::cuboid(Vec3::new(1.80, -0.11, 7.90), Vec3::new(2.20, 0.11, 7.93), 0.012, paint::LAMP));
    s
}

/// Nine metres of timber with a cross-arm along y, insulators and a transformer's bracket.
pub(crate) fn utility_pole() -> Sculpt {
    let mut s = Sculpt::post(Vec3::ZERO, 9.0, 0.155, 0.105, 14, paint::TIMBER_POLE);
    let iron = Material::new(Surface::Metal, [0.18, 0.17, 0.16], ClassTag::Poles);
    let china = Material::new(Surface::Plastic, [0.30, 0.16, 0.10], ClassTag::Poles);
    for (z, half) in [(8.55, 1.15), (7.75, 0.75)] {
        s.add(Sculpt::cuboid(
            Vec3::new(0.10, -half, z - 0.055),
            Vec3::new(0.20, half, z + 0.055),
            0.01,
            paint::TIMBER_POLE,
        ));
        for y in [-0.92 * half, -0.42 * half, 0.42 * half, 0.92 * half] {
            s.add(
                Sculpt::lathe(
                    &[
                        (0.0, 0.0),
                        (0.02, 0.0),
                        (0.02, 0.05),
                        (0.05, 0.06),
                        (0.035, 0.10),
                        (0.05, 0.12),
                        (0.03, 0.17),
                        (0.0, 0.18),
                    ],
                    10,
                    40.0,
                    china,
                )
                .at(Vec3::new(0.15, y, z + 0.05)),
            );
        }
        s.add(
            Sculpt::tube(
                &[(Vec3::new(0.15, 0.55 * half, z - 0.03), 0.014), (Vec3::new(0.08, 0.0, z - 0.55), 0.014)],
                6,
                iron,
            )
            .both_sides(),
        );
    }
    s.add(Sculpt::post(Vec3::new(-0.30, 0.0, 6.35), 0.75, 0.20, 0.20, 16, paint::POLE));
    s.add(Sculpt::cuboid(Vec3::new(-0.25, -0.05, 6.5), Vec3::new(-0.05, 0.05, 6.62), 0.0, iron));
    s
}

/// Six metres of plain steel.
pub(crate) fn camera_pole() -> Sculpt {
    let mut s = pole(6.0, 0.075, 0.055, paint::POLE);
    s.add(Sculpt::cuboid(Vec3::new(-0.20, -0.14, 2.2), Vec3::new(-0.06, 0.14, 2.65), 0.015, paint::POLE));
    s
}
