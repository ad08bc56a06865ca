//! What stands on squares and in parks.

use super::paint;
use crate::shape::Sculpt;
use endless_scene::{Material, Surface};
use endless_world::{Stream, math};
use glam::{Affine3A, Quat, Vec2, Vec3};
use std::f32::consts::TAU;

const STONE: Material = paint::fixed(Surface::Stone, [0.46, 0.43, 0.37]);
const BRONZE: Material = paint::fixed(Surface::Metal, [0.13, 0.16, 0.12]);

fn block(low: (f32, f32, f32), high: (f32, f32, f32), bevel: f32, material: Material) -> Sculpt {
    Sculpt::cuboid(Vec3::from(low), Vec3::from(high), bevel, material)
}

/// A table with two benches along x.
pub(crate) fn picnic_table() -> Sculpt {
    let mut s = Sculpt::new();
    for k in 0..5 {
        let y = -0.32 + 0.16 * k as f32;
        s.add(block((-0.9, y - 0.07, 0.72), (0.9, y + 0.07, 0.76), 0.008, paint::SLATS));
    }
    for side in [-1.0f32, 1.0] {
        for k in 0..2 {
            let y = side * (0.62 + 0.15 * k as f32);
            s.add(block((-0.9, y - 0.065, 0.42), (0.9, y + 0.065, 0.46), 0.008, paint::SLATS));
        }
    }
    for x in [-0.62, 0.62] {
        s.add(block((x - 0.02, -0.8, 0.34), (x + 0.02, 0.8, 0.42), 0.0, paint::SLATS));
        s.add(block((x - 0.02, -0.36, 0.64), (x + 0.02, 0.36, 0.72), 0.0, paint::SLATS));
        for side in [-1.0, 1.0] {
            s.add(Sculpt::sweep(
                &[
                    (Vec3::new(x + 0.04, side * 0.62, 0.0), Vec2::new(0.02, 0.05)),
                    (Vec3::new(x + 0.04, side * 0.20, 0.70), Vec2::new(0.02, 0.05)),
                ],
                Vec3::X,
                8,
                6.0,
                true,
                paint::SLATS,
            ));
        }
    }
    s
}

/// A basin of 5 m with a bowl on a column and water.
pub(crate) fn fountain() -> Sculpt {
    let water = paint::fixed(Surface::Water, [0.05, 0.10, 0.11]);
    let mut s = Sculpt::lathe(
        &[
            (0.0, 0.0),
            (2.5, 0.0),
            (2.5, 0.12),
            (2.4, 0.14),
            (2.4, 0.45),
            (2.48, 0.48),
            (2.48, 0.56),
            (2.16, 0.56),
            (2.12, 0.20),
            (0.0, 0.20),
        ],
        8,
        20.0,
        STONE,
    );
    s.add(Sculpt::lathe(&[(2.13, 0.40), (0.0, 0.401)], 8, 20.0, water));
    s.add(Sculpt::lathe(
        &[
            (0.0, 0.2),
            (0.45, 0.2),
            (0.45, 0.5),
            (0.24, 0.6),
            (0.18, 1.05),
            (0.28, 1.2),
            (0.95, 1.42),
            (1.0, 1.5),
            (0.92, 1.5),
            (0.2, 1.36),
            (0.16, 1.75),
            (0.36, 1.95),
            (0.38, 2.0),
            (0.0, 2.0),
        ],
        20,
        35.0,
        STONE,
    ));
    s.add(Sculpt::lathe(&[(0.93, 1.46), (0.0, 1.462)], 20, 20.0, water));
    let spray = paint::fixed(Surface::Plaster, [0.70, 0.74, 0.76]);
    for k in 0..8 {
        let (sin, cos) = math::sin_cos(TAU * k as f32 / 8.0);
        let path: Vec<(Vec3, f32)> = (0..6)
            .map(|i| {
                let t = i as f32 / 5.0;
                let r = 0.95 + 0.45 * t;
                (Vec3::new(cos * r, sin * r, 1.50 - 1.1 * t * t), 0.012)
            })
            .collect();
        s.add(Sculpt::tube(&path, 5, spray));
    }
    s
}

/// A standing figure of bronze on a plinth, facing +x; 4.2 m.
pub(crate) fn monument() -> Sculpt {
    let mut s = block((-1.0, -1.0, 0.0), (1.0, 1.0, 0.25), 0.02, STONE);
    s.add(block((-0.75, -0.75, 0.25), (0.75, 0.75, 0.45), 0.02, STONE));
    s.add(block((-0.55, -0.55, 0.45), (0.55, 0.55, 1.95), 0.02, STONE));
    s.add(block((-0.65, -0.65, 1.95), (0.65, 0.65, 2.12), 0.03, STONE));
    s.add(block((0.545, -0.35, 1.0), (0.56, 0.35, 1.5), 0.0, BRONZE));
    let limb = |s: &mut Sculpt, points: &[(f32, f32, f32, f32)]| {
        let path: Vec<(Vec3, f32)> = points.iter().map(|&(x, y, z, r)| (Vec3::new(x, y, 2.12 + z), r)).collect();
        s.add(Sculpt::tube(&path, 10, BRONZE));
    };
    limb(
        &mut s,
        &[(0.16, 0.14, 0.0, 0.08), (0.02, 0.13, 0.12, 0.09), (0.03, 0.12, 0.55, 0.11), (0.0, 0.10, 1.0, 0.14)],
    );
    limb(
        &mut s,
        &[(0.02, -0.16, 0.0, 0.08), (-0.12, -0.14, 0.12, 0.09), (-0.06, -0.13, 0.55, 0.11), (0.0, -0.10, 1.0, 0.14)],
    );
    // Coat, shoulders, head.
    let coat = [(0.42, 0.27), (0.7, 0.29), (1.05, 0.23), (1.45, 0.29), (1.58, 0.22), (1.64, 0.09)];
    let sections: Vec<(Vec3, Vec2)> =
        coat.iter().map(|&(z, r)| (Vec3::Z * (2.12 + z), Vec2::new(0.65 * r, r))).collect();
    s.add(Sculpt::sweep(&sections, Vec3::X, 14, 2.3, true, BRONZE));
    s.add(Sculpt::ellipsoid(Vec3::new(0.03, 0.0, 3.93), Vec3::new(0.13, 0.105, 0.16), 14, BRONZE));
    limb(
        &mut s,
        &[(0.0, 0.27, 1.50, 0.085), (0.10, 0.36, 1.20, 0.075), (0.35, 0.30, 1.15, 0.06), (0.42, 0.27, 1.17, 0.055)],
    );
    limb(&mut s, &[(0.0, -0.27, 1.50, 0.085), (-0.06, -0.37, 1.18, 0.075), (0.02, -0.36, 0.88, 0.06)]);
    s.add(block((0.38, 0.17, 3.26), (0.52, 0.36, 3.30), 0.0, BRONZE));
    s
}

/// A stall 2.6 m along y under a striped roof, goods on its table, facing +x.
pub(crate) fn market_stall(variant: u32) -> Sculpt {
    let mut stream = Stream::named(u64::from(variant), "market stall", &[]);
    let cloth = [[0.50, 0.05, 0.04], [0.04, 0.22, 0.12], [0.05, 0.14, 0.36]][variant as usize % 3];
    let stripe = |k: usize| paint::fixed(Surface::Cloth, if k.is_multiple_of(2) { cloth } else { [0.72, 0.70, 0.64] });
    let mut s = Sculpt::new();
    for (x, y) in [(-0.85, -1.25), (0.85, -1.25), (0.85, 1.25), (-0.85, 1.25)] {
        s.add(Sculpt::post(Vec3::new(x, y, 0.0), 2.2, 0.025, 0.025, 8, paint::STEEL));
    }
    for k in 0..10 {
        let (y0, y1) = (-1.4 + 0.28 * k as f32, -1.4 + 0.28 * (k + 1) as f32);
        let m = stripe(k);
        let p = |x: f32, y: f32, z: f32| Vec3::new(x, y, z);
        for (x, drop) in [(1.1f32, 0.004f32), (-1.1, 0.004)] {
            let front = [p(x, y0, 2.12), p(x, y1, 2.12), p(0.0, y1, 2.62), p(0.0, y0, 2.62)];
            let front = if x > 0.0 { front } else { [front[1], front[0], front[3], front[2]] };
            s.quad(front, m);
            let [a, b, c, d] = front.map(|q| q - Vec3::Z * drop);
            s.quad([b, a, d, c], m);
            let hang = [p(x, y0, 1.94), p(x, y1, 1.94), p(x, y1, 2.12), p(x, y0, 2.12)];
            let hang = if x > 0.0 { hang } else { [hang[1], hang[0], hang[3], hang[2]] };
            s.quad(hang, m);
            let inward = Vec3::X * -0.004 * x.signum();
            let [a, b, c, d] = hang.map(|q| q + inward);
            s.quad([b, a, d, c], m);
        }
    }
    let wood = paint::fixed(Surface::Wood, [0.28, 0.19, 0.11]);
    s.add(block((-0.15, -1.2, 0.78), (0.80, 1.2, 0.83), 0.0, wood));
    s.add(block((0.77, -1.2, 0.20), (0.79, 1.2, 0.80), 0.0, stripe(1)));
    let goods = [
        [0.55, 0.05, 0.03],
        [0.70, 0.28, 0.02],
        [0.10, 0.30, 0.04],
        [0.72, 0.55, 0.05],
        [0.30, 0.04, 0.12],
        [0.30, 0.16, 0.07],
    ];
    for row in 0..2 {
        for k in 0..5 {
            let (x, y) = (0.05 + 0.42 * row as f32, -0.98 + 0.49 * k as f32);
            let tilt = Affine3A::from_rotation_translation(Quat::from_rotation_y(0.22), Vec3::new(x + 0.14, y, 0.90));
            let mut crate_ = block((-0.18, -0.21, 0.0), (0.18, 0.21, 0.10), 0.0, wood);
            let m = paint::fixed(Surface::Plastic, *stream.pick(&goods));
            for i in 0..12 {
                let at = Vec3::new(-0.13 + 0.087 * (i % 4) as f32, -0.14 + 0.14 * (i / 4) as f32, 0.11);
                crate_.add(Sculpt::ellipsoid(at, Vec3::new(0.05, 0.06, 0.05), 8, m));
            }
            s.add(crate_.placed(tilt));
        }
    }
    s
}

/// A square grate about a tree with a guard of bars, 1.7 m high.
pub(crate) fn tree_guard() -> Sculpt {
    let mut s = Sculpt::new();
    let iron = paint::DARK_STEEL;
    for k in 0..8 {
        let turn = Affine3A::from_rotation_z(TAU * k as f32 / 8.0);
        let bar = Sculpt::tube(
            &[
                (Vec3::new(0.42, 0.0, 0.0), 0.010),
                (Vec3::new(0.34, 0.0, 0.25), 0.010),
                (Vec3::new(0.30, 0.0, 1.5), 0.010),
                (Vec3::new(0.38, 0.0, 1.72), 0.010),
            ],
            6,
            iron,
        );
        s.add(bar.placed(turn));
    }
    for (z, r) in [(0.25, 0.345), (0.85, 0.325), (1.48, 0.305)] {
        let ring = [(r - 0.008, z), (r + 0.008, z), (r + 0.008, z + 0.03), (r - 0.008, z + 0.03), (r - 0.008, z)];
        s.add(Sculpt::lathe(&ring, 20, 30.0, iron));
    }
    for k in 0..8 {
        let x = -0.66 + 0.19 * k as f32;
        for (a, b) in [(-0.7, -0.24), (0.24, 0.7)] {
            s.add(block((x - 0.07, a, 0.0), (x + 0.07, b, 0.018), 0.0, iron));
        }
    }
    s
}

/// A stand for five bicycles: pairs of low loops in a row along y on two rails.
pub(crate) fn bike_stand() -> Sculpt {
    let mut s = Sculpt::new();
    for x in [-0.3, 0.3] {
        s.add(block((x - 0.03, -1.2, 0.0), (x + 0.03, 1.2, 0.04), 0.0, paint::STEEL));
    }
    for k in 0..5 {
        let y = -1.0 + 0.5 * k as f32;
        for dy in [-0.04, 0.04] {
            let path: Vec<(Vec3, f32)> = (0..=10)
                .map(|i| {
                    let (sin, cos) = math::sin_cos(std::f32::consts::PI * i as f32 / 10.0);
                    (Vec3::new(-0.3 * cos, y + dy, 0.03 + 0.42 * sin), 0.011)
                })
                .collect();
            s.add(Sculpt::tube(&path, 6, paint::STEEL));
        }
    }
    s
}

/// A bench of stone blocks and one timber seat, along y.
pub(crate) fn stone_bench() -> Sculpt {
    let mut s = Sculpt::new();
    for y in [-0.8, 0.8] {
        s.add(block((-0.22, y - 0.16, 0.0), (0.22, y + 0.16, 0.38), 0.015, STONE));
    }
    s.add(block((-0.26, -1.1, 0.38), (0.26, 1.1, 0.48), 0.02, STONE));
    s
}
