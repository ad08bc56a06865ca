//! What builders leave in the street, and what people put up at home: heaps, bricks, scaffolds, laundry, dishes.

use super::paint;
use super::part::{block, rod, v};
use crate::shape::Sculpt;
use endless_scene::{Material, Surface};
use endless_world::{Stream, math};
use glam::{Affine3A, Quat, Vec2, Vec3};
use std::f32::consts::TAU;

const PLANK: Material = paint::fixed(Surface::Wood, [0.36, 0.27, 0.17]);
const TUBE: Material = paint::fixed(Surface::Metal, [0.34, 0.35, 0.36]);
const FABRICS: [Material; 7] = [
    paint::fixed(Surface::Cloth, [0.70, 0.70, 0.68]),
    paint::fixed(Surface::Cloth, [0.05, 0.10, 0.28]),
    paint::fixed(Surface::Cloth, [0.42, 0.05, 0.05]),
    paint::fixed(Surface::Cloth, [0.02, 0.02, 0.022]),
    paint::fixed(Surface::Cloth, [0.60, 0.48, 0.08]),
    paint::fixed(Surface::Cloth, [0.08, 0.28, 0.26]),
    paint::fixed(Surface::Cloth, [0.55, 0.24, 0.32]),
];

/// Sand or gravel as it was tipped, 2.4 m across, with a shovel's bite.
pub(crate) fn sand_heap(variant: u32) -> Sculpt {
    let mut stream = Stream::named(u64::from(variant), "sand heap", &[]);
    let tones = [[0.42, 0.33, 0.20], [0.26, 0.25, 0.24], [0.34, 0.22, 0.13]];
    let material = paint::fixed(Surface::Gravel, tones[variant as usize % 3]);
    let lobes: [f32; 3] = [stream.range_f32(0.0, TAU), stream.range_f32(0.0, TAU), stream.range_f32(0.0, TAU)];
    let n = 28;
    let ring = |share: f32, z: f32, stream: &mut Stream| -> Vec<Vec3> {
        (0..n)
            .map(|i| {
                let angle = TAU * i as f32 / n as f32;
                let (sin, cos) = math::sin_cos(angle);
                let lobe = 0.10 * math::sin(2.0 * angle + lobes[0]) + 0.07 * math::sin(3.0 * angle + lobes[1]);
                let bite = 0.16 * math::smoothstep(0.75, 1.0, math::cos(angle - lobes[2])) * (1.0 - share);
                let r = 1.2 * share * (1.0 + lobe - bite) + stream.range_f32(-0.02, 0.02) * share;
                v(r * cos, r * sin, (z + stream.range_f32(-0.012, 0.012)).max(0.0))
            })
            .collect()
    };
    // At the angle of repose, its foot run out and its top rounded.
    let levels = [(1.0, 0.0), (0.88, 0.06), (0.70, 0.24), (0.50, 0.45), (0.32, 0.62), (0.16, 0.73), (0.05, 0.775)];
    let rows: Vec<Vec<Vec3>> = levels.iter().map(|&(share, z)| ring(share, z, &mut stream)).collect();
    let mut s = Sculpt::new();
    s.grid(&rows, true, material);
    s.polygon(&rows[levels.len() - 1], material);
    s.smooth(50.0)
}

/// Bricks or blocks on a pallet, some taken.
pub(crate) fn brick_pallet(variant: u32) -> Sculpt {
    let mut stream = Stream::named(u64::from(variant), "brick pallet", &[]);
    let tone: [f32; 3] = [[0.34, 0.13, 0.075], [0.42, 0.41, 0.39]][variant as usize % 2];
    // No two batches come out of the kiln alike.
    let fired = [0.85, 1.0, 1.14].map(|k| paint::fixed(Surface::Concrete, tone.map(|c| c * k)));
    let unit = [v(0.25, 0.12, 0.075), v(0.39, 0.19, 0.19)][variant as usize % 2];
    let mut s = Sculpt::new();
    for y in [-0.36, 0.0, 0.36] {
        s.add(block(v(-0.55, y - 0.05, 0.0), v(0.55, y + 0.05, 0.10), PLANK));
    }
    s.add(block(v(-0.55, -0.45, 0.10), v(0.55, 0.45, 0.13), PLANK));
    let count = |length: f32, unit: f32| (length / unit) as usize;
    let (nx, ny, nz) = (count(1.08, unit.x), count(0.88, unit.y), count(0.95, unit.z));
    let gap = 0.006;
    for i in 0..nx {
        for j in 0..ny {
            // Some have been taken off the top.
            let left = nz - [0, 0, 1, 1, 2][stream.below(5)];
            for k in 0..left {
                let inside = i > 0 && i + 1 < nx && j > 0 && j + 1 < ny && k + 3 < nz;
                if inside {
                    continue;
                }
                let low = v(
                    -0.5 * unit.x * nx as f32 + unit.x * i as f32,
                    -0.5 * unit.y * ny as f32 + unit.y * j as f32,
                    0.13 + unit.z * k as f32,
                );
                s.add(block(low, low + unit - gap, *stream.pick(&fired)));
            }
        }
    }
    s
}

/// One bay of a scaffold, 2.5 m along x and 4 m high before a wall at −y: frames, planks, rails, and netting or none.
pub(crate) fn scaffold_bay(variant: u32) -> Sculpt {
    let mut s = Sculpt::new();
    let (x, y, lift) = (1.25, 0.37, 2.0);
    for px in [-x, x] {
        for py in [-y, y] {
            s.add(block(v(px - 0.09, py - 0.09, 0.0), v(px + 0.09, py + 0.09, 0.02), TUBE));
            s.add(rod(v(px, py, 0.0), v(px, py, 2.0 * lift + 1.05), 0.025, TUBE));
        }
        for z in [0.3, lift, 2.0 * lift] {
            s.add(rod(v(px, -y, z), v(px, y, z), 0.022, TUBE));
        }
    }
    for level in [lift, 2.0 * lift] {
        for k in 0..3 {
            let from = -y + 0.015 + 0.245 * k as f32;
            s.add(block(v(-x, from, level + 0.02), v(x, from + 0.235, level + 0.06), PLANK));
        }
        // Rails and a toe board on the street's side.
        for z in [0.5, 1.0] {
            s.add(rod(v(-x, y, level + z), v(x, y, level + z), 0.02, TUBE));
        }
        s.add(block(v(-x, y + 0.02, level + 0.06), v(x, y + 0.045, level + 0.21), PLANK));
    }
    s.add(rod(v(-x, y + 0.03, 0.1), v(x, y + 0.03, lift), 0.02, TUBE));
    s.add(rod(v(x, y + 0.03, lift), v(-x, y + 0.03, 2.0 * lift), 0.02, TUBE));
    if variant % 2 == 1 {
        let net = paint::fixed(Surface::Cloth, [0.05, 0.20, 0.12]);
        s.add(block(v(-x, y + 0.06, 2.0), v(x, y + 0.07, 2.0 * lift + 1.0), net));
    }
    s
}

/// Two poles 4 m apart along x with lines between them, full of clothes.
pub(crate) fn laundry_line(variant: u32) -> Sculpt {
    let mut stream = Stream::named(u64::from(variant), "laundry line", &[]);
    let mut s = Sculpt::new();
    for x in [-2.0, 2.0] {
        s.add(rod(v(x, 0.0, 0.0), v(x, 0.0, 2.05), 0.03, TUBE));
        s.add(rod(v(x, -0.35, 1.98), v(x, 0.35, 1.98), 0.02, TUBE));
    }
    let sag = |x: f32| 1.98 - 0.16 * (1.0 - 0.25 * x * x);
    for y in [-0.3, 0.3] {
        let path: Vec<(Vec3, f32)> = (0..=8)
            .map(|i| {
                let x = -2.0 + 0.5 * i as f32;
                (v(x, y, sag(x)), 0.004)
            })
            .collect();
        s.add(Sculpt::tube(&path, 4, paint::DARK));
        let mut x = -1.75;
        while x < 1.5 {
            let kind = stream.below(4);
            let (wide, long) = [(0.46, 0.62), (0.85, 0.95), (0.36, 0.85), (0.30, 0.34)][kind];
            let (fabric, phase) = (*stream.pick(&FABRICS), stream.range_f32(0.0, TAU));
            if stream.chance(0.85) {
                s.add(Washing { wide, long, sleeved: kind == 0, fabric, phase }.hung(x, y, sag));
            }
            x += wide + stream.range_f32(0.05, 0.2);
        }
    }
    s
}

/// What hangs on a line.
#[derive(Debug, Clone, Copy)]
struct Washing {
    wide: f32,
    long: f32,
    /// A shirt, wider where its sleeves are.
    sleeved: bool,
    fabric: Material,
    phase: f32,
}

impl Washing {
    /// From x on along a line at y: a wavy sheet, seen from both sides.
    fn hung(&self, x: f32, y: f32, line: impl Fn(f32) -> f32) -> Sculpt {
        let n = 8;
        let point = |t: f32, i: usize, side: f32| {
            let u = i as f32 / n as f32;
            let out = if self.sleeved && t < 0.35 { 1.35 } else { 1.0 };
            let px = x + self.wide * (0.5 + (u - 0.5) * out);
            let wave = 0.03 * t * math::sin(9.0 * u + self.phase);
            v(px, y + side + wave, line(px) - 0.01 - self.long * t)
        };
        // Around it: along +x on the side of −y, and back.
        let around = |t: f32| -> Vec<Vec3> {
            (0..=n).map(|i| point(t, i, -0.006)).chain((0..=n).rev().map(|i| point(t, i, 0.006))).collect()
        };
        let mut s = Sculpt::new();
        s.grid(&[1.0, 0.7, 0.36, 0.34, 0.0].map(around), true, self.fabric);
        s.polygon(&around(1.0).into_iter().rev().collect::<Vec<_>>(), self.fabric);
        s.polygon(&around(0.0), self.fabric);
        s.smooth(60.0)
    }
}

/// A dish on a short mast, looking up towards +x.
pub(crate) fn satellite_dish(variant: u32) -> Sculpt {
    let r = [0.36, 0.48][variant as usize % 2];
    let dish = paint::fixed(Surface::Painted, [[0.60, 0.60, 0.58], [0.34, 0.35, 0.36]][variant as usize % 2]);
    let mut s = rod(v(0.0, 0.0, 0.0), v(0.0, 0.0, 0.62), 0.025, TUBE);
    s.add(block(v(-0.12, -0.12, 0.0), v(0.12, 0.12, 0.015), TUBE));
    let bowl = |k: f32| k * k * 0.25 * r;
    let ks = [0.0f32, 0.35, 0.7, 1.0];
    let mut profile: Vec<(f32, f32)> = ks.iter().map(|&k| (k * r, bowl(k) - 0.012)).collect();
    profile.extend(ks.iter().rev().map(|&k| (k * r, bowl(k))));
    let mut bowl = Sculpt::lathe(&profile, 28, 40.0, dish);
    bowl.add(rod(v(-0.9 * r, 0.0, 0.18 * r), v(-0.15 * r, 0.0, 0.95 * r), 0.012, TUBE));
    bowl.add(Sculpt::tube(&[(v(-0.22 * r, 0.0, 0.90 * r), 0.03), (v(-0.02 * r, 0.0, 0.98 * r), 0.035)], 10, dish));
    let turn = Quat::from_rotation_y(0.96);
    s.add(bowl.placed(Affine3A::from_rotation_translation(turn, v(0.05, 0.0, 0.62))));
    s
}

/// Concrete pipes, reinforcement or sacks of cement that wait to be used, along x.
pub(crate) fn building_stock(variant: u32) -> Sculpt {
    let mut s = Sculpt::new();
    match variant % 3 {
        0 => {
            let ring = [(0.24, -1.0), (0.31, -1.0), (0.31, 1.0), (0.24, 1.0), (0.24, -1.0)];
            let pipe = Sculpt::lathe(&ring, 24, 30.0, paint::CONCRETE);
            let turn = Quat::from_rotation_y(std::f32::consts::FRAC_PI_2);
            for (y, z) in [(-0.32, 0.31), (0.32, 0.31), (0.0, 0.865)] {
                s.add(pipe.clone().placed(Affine3A::from_rotation_translation(turn, v(0.0, y, z))));
            }
        }
        1 => {
            let rust = paint::fixed(Surface::Metal, [0.20, 0.10, 0.06]);
            for x in [-0.9, 0.9] {
                s.add(block(v(x - 0.05, -0.3, 0.0), v(x + 0.05, 0.3, 0.08), PLANK));
            }
            for i in 0..16 {
                let (y, z) = (-0.24 + 0.06 * (i % 8) as f32, 0.093 + 0.026 * (i / 8) as f32);
                s.add(rod(v(-1.6, y, z), v(1.6, y, z), 0.013, rust));
            }
        }
        _ => {
            let paper = paint::fixed(Surface::Cloth, [0.50, 0.46, 0.38]);
            s.add(block(v(-0.55, -0.45, 0.0), v(0.55, 0.45, 0.12), PLANK));
            for layer in 0..4 {
                for (i, j) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                    let centre = v(-0.26 + 0.52 * i as f32, -0.21 + 0.42 * j as f32, 0.18 + 0.125 * layer as f32);
                    let at = |t: f32, fat: f32| (centre + Vec3::X * (0.26 * t), Vec2::new(0.20, 0.065) * fat);
                    let path = [at(-0.98, 0.7), at(-0.8, 1.0), at(0.8, 1.0), at(0.98, 0.7)];
                    s.add(Sculpt::sweep(&path, Vec3::Y, 10, 3.0, true, paper));
                }
            }
        }
    }
    s
}
