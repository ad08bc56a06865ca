//! Benches and cafe tables.

use super::paint;
use crate::shape::Sculpt;
use endless_scene::{Material, Surface};
use endless_world::{BenchSeat, math};
use glam::{Affine3A, Quat, Vec3};
use std::f32::consts::TAU;

/// A slatted bench along y, facing +x.
pub(crate) fn bench() -> Sculpt {
    let mut s = Sculpt::new();
    for i in 0..4 {
        let x = -0.20 + 0.115 * i as f32;
        s.add(Sculpt::cuboid(
            Vec3::new(x, -0.9, 0.43),
            Vec3::new(x + 0.095, 0.9, BenchSeat::HEIGHT_M),
            0.01,
            paint::SLATS,
        ));
    }
    for i in 0..3 {
        let z = 0.55 + 0.12 * i as f32;
        let x = -0.24 - 0.03 * i as f32;
        s.add(Sculpt::cuboid(Vec3::new(x, -0.9, z), Vec3::new(x + 0.032, 0.9, z + 0.095), 0.01, paint::SLATS));
    }
    for y in [-0.72, 0.0, 0.72] {
        let at = |x: f32, z: f32| (Vec3::new(x, y, z), 0.02);
        s.add(Sculpt::tube(
            &[at(0.22, 0.0), at(0.19, 0.41), at(-0.22, 0.41), at(-0.24, 0.55), at(-0.31, 0.88)],
            8,
            paint::DARK_STEEL,
        ));
        s.add(Sculpt::tube(&[at(-0.28, 0.0), at(-0.22, 0.41)], 8, paint::DARK_STEEL));
    }
    s
}

/// A chair facing +x.
fn chair() -> Sculpt {
    let frame = paint::fixed(Surface::Metal, [0.30, 0.30, 0.31]);
    let seat = paint::fixed(Surface::Plastic, [0.22, 0.14, 0.08]);
    let mut s = Sculpt::cuboid(Vec3::new(-0.21, -0.21, 0.43), Vec3::new(0.21, 0.21, 0.455), 0.01, seat);
    s.add(Sculpt::cuboid(Vec3::new(-0.235, -0.20, 0.58), Vec3::new(-0.215, 0.20, 0.84), 0.008, seat));
    for (x, y, top) in [(0.19, 0.19, 0.43), (-0.20, 0.19, 0.84)] {
        s.add(
            Sculpt::tube(&[(Vec3::new(x * 1.1, y * 1.1, 0.0), 0.012), (Vec3::new(x, y, top), 0.012)], 6, frame)
                .both_sides(),
        );
    }
    s
}

/// A round table with parasol and four chairs.
pub(crate) fn cafe_table(variant: u32) -> Sculpt {
    let top = paint::fixed(Surface::Wood, [0.30, 0.20, 0.11]);
    let mut s = Sculpt::post(Vec3::Z * 0.71, 0.03, 0.36, 0.36, 24, top);
    s.add(Sculpt::post(Vec3::ZERO, 0.71, 0.028, 0.028, 10, paint::DARK_STEEL));
    s.add(Sculpt::post(Vec3::ZERO, 0.05, 0.28, 0.26, 20, paint::DARK_STEEL));
    for i in 0..4 {
        let (sin, cos) = math::sin_cos(0.4 + TAU * i as f32 / 4.0);
        let turn = Quat::from_rotation_z(0.4 + TAU * i as f32 / 4.0 + std::f32::consts::PI);
        s.add(chair().placed(Affine3A::from_rotation_translation(turn, Vec3::new(cos, sin, 0.0) * 0.68)));
    }
    let cloth = paint::fixed(
        Surface::Cloth,
        [[0.62, 0.58, 0.48], [0.42, 0.04, 0.035], [0.05, 0.17, 0.10]][variant as usize % 3],
    );
    s.add(Sculpt::tube(&[(Vec3::Z * 0.7, 0.02), (Vec3::Z * 2.55, 0.018)], 8, paint::STEEL));
    s.add(parasol(cloth));
    s
}

/// Eight panels, sagging between the ribs, with a valance; thin, closed below.
pub(super) fn parasol(cloth: Material) -> Sculpt {
    let n = 32;
    let ring = |r: f32, z: f32, sag: f32| -> Vec<Vec3> {
        (0..n)
            .map(|i| {
                let angle = TAU * i as f32 / n as f32;
                let between = 0.5 - 0.5 * math::cos(8.0 * angle);
                let (sin, cos) = math::sin_cos(angle);
                let r = r * (1.0 - 0.07 * between);
                Vec3::new(r * cos, r * sin, z - sag * between)
            })
            .collect()
    };
    let mut s = Sculpt::new();
    let rows = [
        ring(0.02, 2.17, 0.0),
        ring(1.28, 2.05, 0.0),
        ring(1.28, 2.05, 0.0),
        ring(1.33, 2.05, 0.03),
        ring(1.32, 2.19, 0.0),
        ring(0.75, 2.40, 0.03),
        ring(0.02, 2.60, 0.0),
    ];
    s.grid(&rows[..2], true, cloth);
    s.grid(&rows[2..], true, cloth);
    s.smooth(35.0)
}
