//! Street lamps and plain poles.

use super::paint;
use crate::shape::{Region, Sculpt};
use endless_scene::{Material, Surface};
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

/// Eight metres, arm along +x; bent, straight, or of concrete. The lens is at the same place.
pub(crate) fn street_lamp(variant: u32) -> Sculpt {
    match variant % 3 {
        1 => straight_lamp(),
        2 => concrete_lamp(),
        _ => bent_lamp(),
    }
}

/// A flat head on a straight, slightly rising arm.
fn straight_lamp() -> Sculpt {
    let mut s = pole(8.0, 0.09, 0.06, paint::DARK_POLE);
    s.add(Sculpt::tube(
        &[(Vec3::new(0.0, 0.0, 7.80), 0.035), (Vec3::new(1.75, 0.0, 7.95), 0.028)],
        8,
        paint::DARK_POLE,
    ));
    s.add(Sculpt::cuboid(Vec3::new(1.65, -0.16, 7.93), Vec3::new(2.35, 0.16, 7.99), 0.02, paint::POLE));
    for k in 0..5 {
        let x = 1.72 + 0.11 * k as f32;
        s.add(Sculpt::cuboid(Vec3::new(x, -0.12, 7.99), Vec3::new(x + 0.03, 0.12, 8.02), 0.0, paint::POLE));
    }
    s.add(Sculpt::cuboid(Vec3::new(1.80, -0.12, 7.90), Vec3::new(2.20, 0.12, 7.93), 0.0, paint::LAMP));
    s
}

/// A spun concrete pole with a bracket and a bowl.
fn concrete_lamp() -> Sculpt {
    let concrete = Material::new(Surface::Concrete, [0.40, 0.39, 0.37], ClassTag::Poles);
    let mut s = Sculpt::post(Vec3::ZERO, 7.9, 0.14, 0.08, 14, concrete);
    let arm: Vec<(Vec3, f32)> =
        [(0.0, 7.3), (0.25, 7.62), (0.8, 7.86), (1.7, 7.98)].map(|(x, z)| (Vec3::new(x, 0.0, z), 0.026)).to_vec();
    s.add(Sculpt::tube(&arm, 8, paint::POLE));
    s.add(Sculpt::tube(&[(Vec3::new(0.0, 0.0, 7.75), 0.012), (Vec3::new(0.85, 0.0, 7.86), 0.012)], 6, paint::POLE));
    let head = [(1.62, 0.05), (1.75, 0.12), (2.1, 0.15), (2.32, 0.10), (2.38, 0.03)];
    let sections: Vec<(Vec3, Vec2)> =
        head.iter().map(|&(x, r)| (Vec3::new(x, 0.0, 7.985), Vec2::new(r, 0.45 * r))).collect();
    s.add(Sculpt::sweep(&sections, Vec3::Y, 14, 2.4, true, paint::POLE));
    s.add(Sculpt::ellipsoid(Vec3::new(2.0, 0.0, 7.9), Vec3::new(0.2, 0.11, 0.07), 16, paint::LAMP));
    s
}

/// Steel with a swan's neck.
fn bent_lamp() -> Sculpt {
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

/// Nine metres of concrete with a cross-arm along y, a transformer, a coil of cable and boxes: as crowded as in the
/// streets of Latin America and South Asia.
pub(crate) fn crowded_pole() -> Sculpt {
    let concrete = Material::new(Surface::Concrete, [0.40, 0.39, 0.37], ClassTag::Poles);
    let cable = Material::new(Surface::Rubber, [0.018; 3], ClassTag::Poles);
    let mut s = Sculpt::post(Vec3::ZERO, 9.0, 0.17, 0.10, 12, concrete);
    for (z, half) in [(8.6, 1.1), (7.9, 0.8)] {
        s.add(Sculpt::cuboid(Vec3::new(0.10, -half, z - 0.05), Vec3::new(0.18, half, z + 0.05), 0.0, paint::POLE));
        for y in [-0.9 * half, -0.3 * half, 0.3 * half, 0.9 * half] {
            s.add(Sculpt::post(
                Vec3::new(0.14, y, z + 0.05),
                0.16,
                0.045,
                0.025,
                10,
                Material { base_color: [0.30, 0.16, 0.10], ..cable },
            ));
        }
    }
    s.add(Sculpt::post(Vec3::new(-0.42, 0.0, 6.35), 0.95, 0.27, 0.27, 18, paint::POLE));
    s.add(Sculpt::cuboid(Vec3::new(-0.30, -0.05, 6.55), Vec3::new(-0.05, 0.05, 6.65), 0.0, paint::POLE));
    for y in [-0.12, 0.12] {
        s.add(Sculpt::post(
            Vec3::new(-0.42, y, 7.3),
            0.24,
            0.04,
            0.03,
            8,
            Material { base_color: [0.45, 0.42, 0.38], ..cable },
        ));
    }
    // Coils of slack cable, and splice boxes hung on the bundle.
    for (z, r) in [(5.55, 0.34), (5.25, 0.27)] {
        let ring: Vec<(Vec3, f32)> = (0..=14)
            .map(|i| {
                let (sin, cos) = endless_world::math::sin_cos(std::f32::consts::TAU * i as f32 / 14.0);
                (Vec3::new(0.20 + 0.02 * cos, r * cos, z + r * sin), 0.028)
            })
            .collect();
        s.add(Sculpt::tube(&ring, 5, cable));
    }
    for y in [-0.75, 0.55] {
        s.add(Sculpt::tube(&[(Vec3::new(0.17, y, 5.85), 0.07), (Vec3::new(0.17, y + 0.42, 5.88), 0.07)], 10, cable));
    }
    s.add(Sculpt::cuboid(Vec3::new(-0.30, -0.14, 3.1), Vec3::new(-0.12, 0.14, 3.65), 0.01, paint::POLE));
    for (x, y) in [(0.0, 0.14), (0.05, -0.13), (-0.13, 0.03)] {
        s.add(Sculpt::tube(&[(Vec3::new(x, y, 0.4), 0.022), (Vec3::new(0.7 * x, 0.7 * y, 6.2), 0.022)], 6, cable));
    }
    s
}

/// Six metres of plain steel.
pub(crate) fn camera_pole() -> Sculpt {
    let mut s = pole(6.0, 0.075, 0.055, paint::POLE);
    s.add(Sculpt::cuboid(Vec3::new(-0.20, -0.14, 2.2), Vec3::new(-0.06, 0.14, 2.65), 0.015, paint::POLE));
    s
}
