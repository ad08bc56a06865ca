//! Waste, and things on their way: wheeled bins, bottle banks, skips, bags, pallets.

use super::paint;
use crate::shape::Sculpt;
use endless_scene::{Material, Surface};
use endless_world::Stream;
use glam::{Affine3A, Quat, Vec2, Vec3};

fn block(low: (f32, f32, f32), high: (f32, f32, f32), bevel: f32, material: Material) -> Sculpt {
    Sculpt::cuboid(Vec3::from(low), Vec3::from(high), bevel, material)
}

/// One bin of 240 litres (EN 840-1: 1.07 m high, 0.58 by 0.73), its handle towards −x.
fn wheelie(color: [f32; 3]) -> Sculpt {
    let body = paint::fixed(Surface::Plastic, [0.04, 0.045, 0.045]);
    let lid = paint::fixed(Surface::Plastic, color);
    let sections = [(0.04, 0.20, 0.19), (0.10, 0.215, 0.205), (0.98, 0.31, 0.27), (1.0, 0.32, 0.285)];
    let rings: Vec<(Vec3, Vec2)> =
        sections.iter().map(|&(z, x, y)| (Vec3::new(0.02 * z, 0.0, z), Vec2::new(x, y))).collect();
    let mut s = Sculpt::sweep(&rings, Vec3::X, 20, 6.0, true, body);
    let top = [(-0.36, 1.0), (0.36, 0.985), (0.37, 1.02), (0.15, 1.065), (-0.36, 1.07)].map(Vec2::from);
    s.add(Sculpt::slab(&top, -0.29, 0.29, 25.0, lid));
    s.add(Sculpt::tube(&[(Vec3::new(-0.39, -0.2, 1.02), 0.016), (Vec3::new(-0.39, 0.2, 1.02), 0.016)], 8, body));
    for y in [-0.24, 0.24] {
        s.add(block((-0.40, y - 0.02, 0.97), (-0.30, y + 0.02, 1.04), 0.0, body));
        s.add(Sculpt::tube(
            &[(Vec3::new(-0.24, y - 0.025, 0.10), 0.10), (Vec3::new(-0.24, y + 0.025, 0.10), 0.10)],
            14,
            paint::DARK,
        ));
    }
    s
}

/// Three wheeled bins in a row along y, facing +x.
pub(crate) fn wheelie_bins(variant: u32) -> Sculpt {
    let colors = [[0.05, 0.05, 0.05], [0.60, 0.45, 0.02], [0.03, 0.14, 0.34], [0.04, 0.20, 0.07], [0.22, 0.11, 0.05]];
    let mut s = Sculpt::new();
    for i in 0..3usize {
        let turn = Quat::from_rotation_z([0.06, -0.1, 0.03][(i + variant as usize) % 3]);
        let place = Affine3A::from_rotation_translation(turn, Vec3::Y * (0.66 * (i as f32 - 1.0)));
        s.add(wheelie(colors[(i + 2 * variant as usize) % 5]).placed(place));
    }
    s
}

/// A container for glass with round openings.
pub(crate) fn bottle_bank(variant: u32) -> Sculpt {
    let color = paint::fixed(Surface::Plastic, [[0.03, 0.17, 0.08], [0.55, 0.55, 0.52]][variant as usize % 2]);
    let rings = [(0.0, 0.62), (0.06, 0.68), (0.9, 0.72), (1.25, 0.62), (1.5, 0.36), (1.58, 0.12)];
    let sections: Vec<(Vec3, Vec2)> = rings.iter().map(|&(z, r)| (Vec3::Z * z, Vec2::splat(r))).collect();
    let mut s = Sculpt::sweep(&sections, Vec3::X, 24, 3.2, true, color);
    for k in 0..2 {
        let turn = Affine3A::from_rotation_z(std::f32::consts::PI * k as f32);
        let mut hole =
            Sculpt::tube(&[(Vec3::new(0.55, 0.0, 1.08), 0.13), (Vec3::new(0.74, 0.0, 1.04), 0.13)], 16, paint::DARK);
        hole.add(Sculpt::tube(&[(Vec3::new(0.60, 0.0, 1.07), 0.16), (Vec3::new(0.72, 0.0, 1.045), 0.155)], 16, color));
        hole.add(block((0.70, -0.25, 0.45), (0.735, 0.25, 0.75), 0.0, paint::fixed(Surface::Plate, [0.70; 3])));
        s.add(hole.placed(turn));
    }
    s.add(Sculpt::tube(
        &[(Vec3::new(-0.14, 0.0, 1.55), 0.02), (Vec3::new(0.0, 0.0, 1.72), 0.02), (Vec3::new(0.14, 0.0, 1.55), 0.02)],
        8,
        paint::STEEL,
    ));
    s
}

/// A builder's skip along x with rubble in it (6 cubic yards: 3.4 by 1.75 m).
pub(crate) fn skip(variant: u32) -> Sculpt {
    let mut stream = Stream::named(u64::from(variant), "skip", &[]);
    let color = paint::fixed(Surface::Painted, [[0.62, 0.36, 0.02], [0.05, 0.12, 0.26]][variant as usize % 2]);
    let ring = |z: f32, x: f32, y: f32| -> Vec<Vec3> {
        [(-x, -y), (x, -y), (x, y), (-x, y)].map(|(a, b)| Vec3::new(a, b, z)).to_vec()
    };
    let mut s = Sculpt::new();
    let rows = [ring(0.05, 0.95, 0.72), ring(0.42, 1.3, 0.80), ring(1.2, 1.72, 0.86)];
    s.grid(&rows, true, color);
    s.polygon(&rows[0].iter().rev().copied().collect::<Vec<_>>(), color);
    let inner = [ring(0.95, 1.55, 0.80), ring(1.2, 1.66, 0.81)];
    s.grid(&[inner[1].clone(), inner[0].clone()], true, color);
    s.grid(&[rows[2].clone(), inner[1].clone()], true, color);
    s.polygon(&inner[0], paint::fixed(Surface::Gravel, [0.26, 0.22, 0.18]));
    for x in [-0.6, 0.6] {
        s.add(block((x - 0.06, -0.90, 0.35), (x + 0.06, -0.82, 1.15), 0.0, color));
        s.add(block((x - 0.06, 0.82, 0.35), (x + 0.06, 0.90, 1.15), 0.0, color));
        s.add(Sculpt::tube(&[(Vec3::new(x, -0.98, 0.75), 0.05), (Vec3::new(x, -0.85, 0.75), 0.05)], 10, color));
        s.add(Sculpt::tube(&[(Vec3::new(x, 0.85, 0.75), 0.05), (Vec3::new(x, 0.98, 0.75), 0.05)], 10, color));
    }
    let rubble = [[0.34, 0.15, 0.10], [0.42, 0.40, 0.37], [0.30, 0.22, 0.14], [0.50, 0.47, 0.42]];
    for _ in 0..26 {
        let at = Vec3::new(stream.range_f32(-1.3, 1.3), stream.range_f32(-0.6, 0.6), stream.range_f32(0.95, 1.12));
        let size = Vec3::new(stream.range_f32(0.08, 0.3), stream.range_f32(0.06, 0.16), stream.range_f32(0.05, 0.1));
        let m = paint::fixed(Surface::Concrete, *stream.pick(&rubble));
        let turn = Quat::from_euler(
            glam::EulerRot::ZYX,
            stream.range_f32(0.0, 6.2),
            stream.range_f32(-0.6, 0.6),
            stream.range_f32(-0.6, 0.6),
        );
        s.add(Sculpt::cuboid(-size, size, 0.0, m).placed(Affine3A::from_rotation_translation(turn, at)));
    }
    s
}

/// A heap of knotted bags and a box.
pub(crate) fn rubbish_bags(variant: u32) -> Sculpt {
    let mut stream = Stream::named(u64::from(variant), "rubbish bags", &[]);
    let mut s = Sculpt::new();
    for i in 0..5 {
        let r = stream.range_f32(0.22, 0.32);
        let h = stream.range_f32(0.26, 0.34);
        let black = stream.chance(0.75);
        let m = paint::fixed(Surface::Leather, if black { [0.018; 3] } else { [0.45, 0.46, 0.50] });
        let profile = [
            (0.0, 0.0),
            (0.75 * r, 0.0),
            (r, 0.25 * h),
            (0.95 * r, 0.8 * h),
            (0.5 * r, 1.35 * h),
            (0.12 * r, 1.6 * h),
            (0.18 * r, 1.85 * h),
            (0.0, 1.9 * h),
        ];
        let bag = Sculpt::lathe(&profile, 14, 50.0, m);
        let at = Vec3::new(0.30 * (i % 3) as f32 - 0.3, 0.42 * (i / 3) as f32 - 0.2, 0.0);
        let at = at + Vec3::new(stream.range_f32(-0.07, 0.07), stream.range_f32(-0.07, 0.07), 0.0);
        let squash = Vec3::new(stream.range_f32(0.85, 1.15), stream.range_f32(0.85, 1.1), 1.0);
        s.add(bag.placed(Affine3A::from_scale_rotation_translation(
            squash,
            Quat::from_rotation_z(stream.range_f32(0.0, 6.0)),
            at,
        )));
    }
    let card = paint::fixed(Surface::Wood, [0.34, 0.23, 0.13]);
    s.add(
        block((-0.2, -0.16, 0.0), (0.2, 0.16, 0.3), 0.0, card)
            .placed(Affine3A::from_rotation_translation(Quat::from_rotation_z(0.5), Vec3::new(0.42, 0.25, 0.0))),
    );
    s
}

/// A stack of pallets (EUR: 1.2 by 0.8 by 0.144 m).
pub(crate) fn pallets(variant: u32) -> Sculpt {
    let mut stream = Stream::named(u64::from(variant), "pallets", &[]);
    let mut s = Sculpt::new();
    for level in 0..4 + 2 * (variant % 2) {
        let z = 0.144 * level as f32;
        let tone = stream.range_f32(0.75, 1.1);
        let wood = paint::fixed(Surface::Wood, [0.36 * tone, 0.26 * tone, 0.16 * tone]);
        let mut one = Sculpt::new();
        for y in [-0.35, 0.0, 0.35] {
            one.add(block((-0.6, y - 0.05, 0.0), (0.6, y + 0.05, 0.022), 0.0, wood));
            for x in [-0.525, 0.0, 0.525] {
                one.add(block((x - 0.07, y - 0.05, 0.022), (x + 0.07, y + 0.05, 0.1), 0.0, wood));
            }
        }
        for k in 0..5 {
            let y = -0.33 + 0.165 * k as f32;
            one.add(block((-0.6, y - 0.06, 0.1), (0.6, y + 0.06, 0.144), 0.0, wood));
        }
        let turn = Quat::from_rotation_z(stream.range_f32(-0.05, 0.05));
        s.add(one.placed(Affine3A::from_rotation_translation(turn, Vec3::new(stream.range_f32(-0.03, 0.03), 0.0, z))));
    }
    s
}

/// A round cover of cast iron (EN 124: 0.6 m opening), level with the road.
pub(crate) fn manhole() -> Sculpt {
    let iron = Material { tag: endless_world::ClassTag::Roads, ..paint::fixed(Surface::Metal, [0.11, 0.105, 0.10]) };
    let worn = Material { base_color: [0.20, 0.195, 0.19], ..iron };
    let mut s = Sculpt::lathe(&[(0.40, -0.05), (0.40, 0.004), (0.335, 0.004), (0.330, -0.004)], 32, 25.0, iron);
    s.add(Sculpt::lathe(&[(0.325, -0.004), (0.325, 0.004), (0.0, 0.004)], 32, 25.0, iron));
    // Lugs in rings.
    for (r, n) in [(0.07f32, 6), (0.14, 12), (0.21, 18), (0.28, 24)] {
        for k in 0..n {
            let (sin, cos) = endless_world::math::sin_cos(std::f32::consts::TAU * k as f32 / n as f32);
            let at = Vec3::new(r * cos, r * sin, 0.0);
            s.add(block((-0.022, -0.012, 0.0), (0.022, 0.012, 0.009), 0.0, worn).placed(
                Affine3A::from_rotation_translation(
                    Quat::from_rotation_z(std::f32::consts::TAU * k as f32 / n as f32),
                    at,
                ),
            ));
        }
    }
    s
}

/// A gully grate, 0.5 m square, level with the road.
pub(crate) fn drain() -> Sculpt {
    let iron = Material { tag: endless_world::ClassTag::Roads, ..paint::fixed(Surface::Metal, [0.12, 0.115, 0.11]) };
    let pit = Material { base_color: [0.008; 3], ..iron };
    let mut s = Sculpt::new();
    for (low, high) in [
        ((-0.25, -0.25), (0.25, -0.21)),
        ((-0.25, 0.21), (0.25, 0.25)),
        ((-0.25, -0.21), (-0.21, 0.21)),
        ((0.21, -0.21), (0.25, 0.21)),
    ] {
        s.add(block((low.0, low.1, -0.05), (high.0, high.1, 0.006), 0.0, iron));
    }
    s.quad([(-0.21, -0.21), (0.21, -0.21), (0.21, 0.21), (-0.21, 0.21)].map(|(x, y)| Vec3::new(x, y, 0.001)), pit);
    for k in 0..7 {
        let x = -0.18 + 0.06 * k as f32;
        s.add(block((x - 0.012, -0.21, 0.0), (x + 0.012, 0.21, 0.006), 0.0, iron));
    }
    s.add(block((-0.21, -0.012, 0.0), (0.21, 0.012, 0.0065), 0.0, iron));
    s
}
