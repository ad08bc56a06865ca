//! What street vendors sell from and bring: carts, blankets, crates.

use super::paint;
use super::part::{block, rod, v};
use super::seat::parasol;
use crate::shape::Sculpt;
use endless_scene::{Material, Surface};
use endless_world::{Stream, math};
use glam::{Affine3A, Quat, Vec2, Vec3};
use std::f32::consts::TAU;

const WOOD: Material = paint::fixed(Surface::Wood, [0.28, 0.19, 0.11]);
const BRIGHT: Material = paint::fixed(Surface::Metal, [0.52, 0.53, 0.54]);
const RUBBER: Material = paint::fixed(Surface::Rubber, [0.022; 3]);
const GOODS: [Material; 6] = [
    paint::fixed(Surface::Plastic, [0.55, 0.05, 0.03]),
    paint::fixed(Surface::Plastic, [0.70, 0.28, 0.02]),
    paint::fixed(Surface::Plastic, [0.10, 0.30, 0.04]),
    paint::fixed(Surface::Plastic, [0.72, 0.55, 0.05]),
    paint::fixed(Surface::Plastic, [0.30, 0.04, 0.12]),
    paint::fixed(Surface::Plastic, [0.70, 0.68, 0.62]),
];
const COLORS: [Material; 4] = [
    paint::fixed(Surface::Painted, [0.50, 0.05, 0.04]),
    paint::fixed(Surface::Painted, [0.62, 0.40, 0.03]),
    paint::fixed(Surface::Painted, [0.03, 0.14, 0.40]),
    paint::fixed(Surface::Painted, [0.66, 0.66, 0.63]),
];
const CLOTHS: [Material; 4] = [
    paint::fixed(Surface::Cloth, [0.62, 0.40, 0.03]),
    paint::fixed(Surface::Cloth, [0.03, 0.14, 0.42]),
    paint::fixed(Surface::Cloth, [0.46, 0.04, 0.035]),
    paint::fixed(Surface::Cloth, [0.05, 0.22, 0.10]),
];

/// A spoked wheel whose axle lies along y.
fn spoked(at: Vec3, r: f32) -> Sculpt {
    let ring = [(0.90 * r, -0.02), (r, -0.02), (r, 0.02), (0.90 * r, 0.02), (0.90 * r, -0.02)];
    let mut s = Sculpt::lathe(&ring, 24, 30.0, RUBBER);
    s.add(Sculpt::post(v(0.0, 0.0, -0.035), 0.07, 0.12 * r, 0.12 * r, 10, paint::STEEL));
    for i in 0..8 {
        let (sin, cos) = math::sin_cos(TAU * i as f32 / 8.0);
        s.add(rod(v(0.1 * r * cos, 0.1 * r * sin, 0.0), v(0.92 * r * cos, 0.92 * r * sin, 0.0), 0.006, paint::STEEL));
    }
    s.placed(Affine3A::from_rotation_translation(Quat::from_rotation_x(std::f32::consts::FRAC_PI_2), at))
}

/// Fruit or bottles on a level, in rows.
fn goods(s: &mut Sculpt, low: Vec3, high: Vec2, r: f32, stream: &mut Stream) {
    let count = |length: f32| ((length / (2.1 * r)) as usize).max(1);
    let (nx, ny) = (count(high.x - low.x), count(high.y - low.y));
    let mut color = *stream.pick(&GOODS);
    for i in 0..nx {
        if i % 3 == 0 {
            color = *stream.pick(&GOODS);
        }
        for j in 0..ny {
            let x = low.x + (high.x - low.x) * (i as f32 + 0.5) / nx as f32;
            let y = low.y + (high.y - low.y) * (j as f32 + 0.5) / ny as f32;
            let tall = r * stream.range_f32(0.85, 1.15);
            s.add(Sculpt::ellipsoid(v(x, y, low.z + 0.8 * tall), v(r, r, tall), 8, color));
        }
    }
}

/// A vendor's cart along x, its handle towards −x, facing +y: with a parasol, with a roof on posts, or with a glass case
/// under a roof.
pub(crate) fn food_cart(variant: u32) -> Sculpt {
    let mut stream = Stream::named(u64::from(variant), "food cart", &[]);
    let body = COLORS[variant as usize % 4];
    let cloth = CLOTHS[(variant as usize + 1) % 4];
    let mut s = Sculpt::new();
    let (x0, x1, y, top) = (-0.68, 0.68, 0.38, 0.88);
    s.add(block(v(x0, -y, 0.42), v(x1, y, top), body));
    s.add(block(v(x0 - 0.04, -y - 0.05, top), v(x1 + 0.04, y + 0.05, top + 0.03), BRIGHT));
    // A sign on the front, in another colour.
    s.add(block(v(-0.5, y, 0.52), v(0.5, y + 0.008, 0.78), COLORS[(variant as usize + 3) % 4]));
    for side in [-1.0, 1.0] {
        s.add(spoked(v(0.22, side * (y + 0.06), 0.31), 0.31));
        s.add(rod(v(x0, side * 0.30, 0.80), v(x0 - 0.42, side * 0.30, 0.92), 0.018, paint::STEEL));
        s.add(rod(v(x0 + 0.06, side * 0.30, 0.42), v(x0 + 0.06, side * 0.30, 0.0), 0.02, paint::STEEL));
    }
    s.add(rod(v(x0 - 0.42, -0.30, 0.92), v(x0 - 0.42, 0.30, 0.92), 0.018, paint::STEEL));
    s.add(rod(v(0.22, -y - 0.05, 0.31), v(0.22, y + 0.05, 0.31), 0.02, paint::STEEL));
    s.add(block(v(0.18, -0.3, 0.31), v(0.26, 0.3, 0.43), paint::DARK_STEEL));
    match variant % 4 {
        0 | 3 => {
            s.add(rod(v(-0.10, 0.0, top), v(-0.10, 0.0, 2.35), 0.02, paint::STEEL));
            let small =
                Affine3A::from_scale_rotation_translation(v(0.8, 0.8, 0.8), Quat::IDENTITY, v(-0.10, 0.0, 0.29));
            s.add(parasol(cloth).placed(small));
            goods(&mut s, v(0.02, -0.34, top + 0.03), Vec2::new(0.62, 0.34), 0.055, &mut stream);
            s.add(Sculpt::post(v(-0.42, 0.0, top + 0.03), 0.24, 0.17, 0.20, 16, BRIGHT));
        }
        1 => {
            for (px, py) in [(x0 + 0.04, 0.34), (x1 - 0.04, 0.34)] {
                s.add(rod(v(px, py, top), v(px, py, 2.0), 0.016, paint::STEEL).both_sides());
            }
            s.add(sheet(0.86, 0.60, 2.0, cloth));
            // A grill with its smoke hood, pots.
            s.add(block(v(-0.55, -0.28, top + 0.03), v(0.0, 0.28, top + 0.13), paint::DARK_STEEL));
            for px in [0.2, 0.48] {
                s.add(Sculpt::post(v(px, -0.1, top + 0.03), 0.22, 0.13, 0.13, 16, BRIGHT));
            }
            goods(&mut s, v(-0.5, -0.22, top + 0.13), Vec2::new(-0.05, 0.22), 0.05, &mut stream);
        }
        _ => {
            // Panes, as of a fridge, with shelves behind.
            s.add(block(v(-0.5, -0.30, top + 0.03), v(0.55, 0.30, top + 0.55), paint::GLASS));
            s.add(block(v(-0.52, -0.32, top + 0.55), v(0.57, 0.32, top + 0.59), body));
            for px in [-0.5, 0.53] {
                s.add(block(v(px, 0.285, top + 0.03), v(px + 0.025, 0.31, top + 0.57), BRIGHT).both_sides());
                s.add(rod(v(px + 0.01, 0.30, top + 0.57), v(px + 0.01, 0.30, 2.0), 0.014, paint::STEEL).both_sides());
            }
            s.add(sheet(0.80, 0.56, 2.0, cloth));
        }
    }
    s
}

/// A roof of cloth with a valance, over (±x, ±y).
fn sheet(x: f32, y: f32, z: f32, cloth: Material) -> Sculpt {
    let mut s = Sculpt::cuboid(v(-x, -y, z), v(x, y, z + 0.035), 0.0, cloth);
    let pale = paint::fixed(Surface::Cloth, [0.68, 0.66, 0.60]);
    let n = 8;
    for i in 0..n {
        let (a, b) = (-x + 2.0 * x * i as f32 / n as f32, -x + 2.0 * x * (i + 1) as f32 / n as f32);
        let color = if i % 2 == 0 { pale } else { cloth };
        s.add(block(v(a, y - 0.012, z - 0.14), v(b, y, z), color).both_sides());
    }
    for side in [-1.0f32, 1.0] {
        let (a, b) = (side * x, side * (x - 0.012));
        s.add(block(v(a.min(b), -y, z - 0.14), v(a.max(b), y, z), cloth));
    }
    s
}

/// A flat cart on two wheels along x, its handle towards −x: empty, with cartons, with sacks.
pub(crate) fn hand_cart(variant: u32) -> Sculpt {
    let mut stream = Stream::named(u64::from(variant), "hand cart", &[]);
    let (x0, x1, y, z) = (-0.75, 0.75, 0.42, 0.52);
    let mut s = Sculpt::new();
    for k in 0..6 {
        let from = -y + 2.0 * y * k as f32 / 6.0;
        s.add(block(v(x0, from, z), v(x1, from + 2.0 * y / 6.0 - 0.012, z + 0.03), WOOD));
    }
    s.add(block(v(x0 - 0.75, 0.33, z - 0.06), v(x1, 0.39, z), WOOD).both_sides());
    s.add(rod(v(x0 - 0.72, -0.36, z - 0.03), v(x0 - 0.72, 0.36, z - 0.03), 0.02, WOOD));
    for side in [-1.0, 1.0] {
        s.add(spoked(v(0.05, side * (y + 0.07), 0.34), 0.34));
        s.add(block(v(x0, side * y - 0.015, z), v(x1, side * y + 0.015, z + 0.18), WOOD));
    }
    s.add(rod(v(0.05, -y - 0.06, 0.34), v(0.05, y + 0.06, 0.34), 0.02, paint::STEEL));
    s.add(block(v(0.0, -0.36, 0.34), v(0.10, 0.36, z - 0.02), WOOD));
    s.add(rod(v(x0 + 0.05, 0.3, z), v(x0 + 0.02, 0.3, 0.0), 0.022, WOOD).both_sides());
    let card = paint::fixed(Surface::Wood, [0.36, 0.25, 0.14]);
    match variant % 3 {
        1 => {
            for i in 0..3 {
                for j in 0..2 {
                    let (x, w) = (x0 + 0.06 + 0.46 * i as f32, -y + 0.03 + 0.40 * j as f32);
                    let high = stream.range_f32(0.28, 0.75);
                    s.add(block(v(x, w, z + 0.03), v(x + 0.44, w + 0.38, z + 0.03 + high), card));
                }
            }
        }
        2 => {
            let sack = paint::fixed(Surface::Cloth, [0.48, 0.42, 0.30]);
            for layer in 0..3 {
                for i in 0..3 - layer / 2 {
                    let x = x0 + 0.28 + 0.46 * i as f32 + 0.1 * layer as f32;
                    let at = |t: f32, fat: f32| {
                        (v(x, t * 0.38, z + 0.13 + 0.18 * layer as f32), Vec2::new(0.21, 0.095) * fat)
                    };
                    let path = [at(-1.0, 0.5), at(-0.8, 0.9), at(-0.3, 1.0), at(0.3, 1.0), at(0.8, 0.9), at(1.0, 0.5)];
                    s.add(Sculpt::sweep(&path, Vec3::X, 10, 2.5, true, sack));
                }
            }
        }
        _ => {}
    }
    s
}

/// Goods on a blanket on the ground, 1.7 m along y, facing +x.
pub(crate) fn vendor_blanket(variant: u32) -> Sculpt {
    let mut stream = Stream::named(u64::from(variant), "vendor blanket", &[]);
    let mut s = block(v(-0.6, -0.85, 0.0), v(0.6, 0.85, 0.012), CLOTHS[variant as usize % 4]);
    for i in 0..5 {
        for j in 0..8 {
            let at = v(-0.48 + 0.24 * i as f32, -0.72 + 0.206 * j as f32, 0.012);
            let half = v(stream.range_f32(0.05, 0.09), stream.range_f32(0.05, 0.08), stream.range_f32(0.015, 0.08));
            if stream.chance(0.12) {
                continue;
            }
            let color = *stream.pick(&GOODS);
            let turn = Quat::from_rotation_z(stream.range_f32(-0.4, 0.4));
            let place = Affine3A::from_rotation_translation(turn, at + Vec3::Z * half.z);
            s.add(Sculpt::cuboid(-half, half, 0.3 * half.z, color).placed(place));
        }
    }
    // A low stool beside, and a box.
    s.add(block(v(-0.95, -0.2, 0.26), v(-0.65, 0.14, 0.30), GOODS[2]));
    for (x, y) in [(-0.92, -0.17), (-0.68, -0.17), (-0.68, 0.11), (-0.92, 0.11)] {
        s.add(rod(v(x, y, 0.0), v(x, y, 0.27), 0.015, GOODS[2]));
    }
    s.add(block(v(-0.95, 0.4, 0.0), v(-0.65, 0.8, 0.32), paint::fixed(Surface::Wood, [0.36, 0.25, 0.14])));
    s
}

/// Crates for bottles and fruit, one on another.
pub(crate) fn crate_stack(variant: u32) -> Sculpt {
    let mut stream = Stream::named(u64::from(variant), "crate stack", &[]);
    let mut s = Sculpt::new();
    for column in 0..2 + variant % 2 {
        let high = 2 + stream.below(4);
        let x = 0.46 * (column as f32 - 0.5);
        let (shift, color) = (stream.range_f32(-0.03, 0.03), *stream.pick(&GOODS));
        for k in 0..high {
            let color = if stream.chance(0.3) { *stream.pick(&GOODS) } else { color };
            let turn = Quat::from_rotation_z(stream.range_f32(-0.06, 0.06));
            let at = v(x, shift, 0.28 * k as f32);
            s.add(one_crate(color).placed(Affine3A::from_rotation_translation(turn, at)));
        }
    }
    s
}

/// Open above, with slots in its walls.
fn one_crate(color: Material) -> Sculpt {
    let dark = Material { base_color: color.base_color.map(|c| 0.25 * c), ..color };
    let mut s = block(v(-0.20, -0.15, 0.0), v(0.20, 0.15, 0.18), dark);
    for (z0, z1) in [(0.0, 0.08), (0.20, 0.275)] {
        s.add(block(v(-0.21, 0.15, z0), v(0.21, 0.165, z1), color).both_sides());
        for x in [-0.21, 0.195] {
            s.add(block(v(x, -0.15, z0), v(x + 0.015, 0.15, z1), color));
        }
    }
    for (x, y) in [(-0.21, -0.165), (0.18, -0.165), (0.18, 0.135), (-0.21, 0.135)] {
        s.add(block(v(x, y, 0.0), v(x + 0.03, y + 0.03, 0.275), color));
    }
    s
}
