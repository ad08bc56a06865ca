//! Conifers: whorls of drooping branches, and the flame of a cypress.

use super::leaf::{Leaves, bark, direction, shades};
use crate::shape::Sculpt;
use endless_scene::{Material, Mesh};
use endless_world::math::UnfusedQuat;
use endless_world::{Stream, math};
use glam::{Affine3A, Quat, Vec2, Vec3};
use std::f32::consts::TAU;

/// How many conifers there are.
pub(crate) const CONIFER_VARIANTS: u32 = 3;

/// A bent branch of four sides from one place to another that tapers from the first radius to the second; `sag` lifts
/// its middle. Metres.
fn branch([from, to]: [Vec3; 2], [r0, r1]: [f32; 2], sag: f32, material: Material, s: &mut Stream) -> Sculpt {
    let (n, sides) = (4, 4);
    let wobble = direction(s) * (to - from).length() * 0.05;
    let path: Vec<(Vec3, f32)> = (0..=n)
        .map(|i| {
            let t = i as f32 / n as f32;
            let p = from.lerp(to, t) + (wobble + Vec3::Z * sag) * (4.0 * t * (1.0 - t));
            (p, math::lerp(r0, r1, t))
        })
        .collect();
    Sculpt::tube(&path, sides, material)
}

/// A spruce or pine-like conifer: whorls of drooping branches with needle sprays.
pub(crate) fn conifer(variant: u32) -> Mesh {
    let mut s = Stream::named(u64::from(variant), "conifer", &[]);
    let h = [11.0, 9.0, 13.2][variant as usize % 3];
    let spread = [0.21, 0.25, 0.17][variant as usize % 3] * h;
    let shades = shades([[0.030, 0.070, 0.028], [0.038, 0.082, 0.050], [0.026, 0.062, 0.024]][variant as usize % 3]);
    let wood = bark([0.13, 0.095, 0.07]);
    let mut trunk = Sculpt::tube(
        &[
            (Vec3::new(0.0, 0.0, -0.05), 0.24),
            (Vec3::Z * 0.3, 0.17),
            (Vec3::Z * 0.6 * h, 0.09),
            (Vec3::Z * (h - 0.1), 0.012),
        ],
        9,
        wood,
    );
    let mut leaves = Leaves::default();
    let whorls = 32;
    for i in 0..whorls {
        let t = i as f32 / (whorls - 1) as f32;
        let z = math::lerp(0.12, 0.975, t) * h;
        let reach = spread * math::pow(1.0 - t, 0.8) + 0.12;
        let n = 7 - (t * 3.0) as usize;
        let phase = s.range_f32(0.0, TAU);
        for k in 0..n {
            let (sin, cos) = math::sin_cos(phase + TAU * k as f32 / n as f32 + s.range_f32(-0.2, 0.2));
            let out = Vec3::new(cos, sin, 0.0);
            let z = z + s.range_f32(-0.024, 0.012) * h;
            let reach = reach * s.range_f32(0.78, 1.08);
            let droop = math::lerp(-0.28, 0.25, t) * reach;
            let tip = Vec3::new(0.0, 0.0, z + droop) + out * reach;
            trunk.add(branch([Vec3::Z * z, tip], [0.012 + 0.018 * (1.0 - t), 0.006], 0.06 * reach, wood, &mut s));
            let sprays = 5 + (reach * 22.0) as usize;
            for j in 0..sprays {
                let f = math::lerp(0.18, 1.0, (j as f32 + s.f32()) / sprays as f32);
                let p = (Vec3::Z * z).lerp(tip, f) + Vec3::Z * 0.06 * reach * 4.0 * f * (1.0 - f);
                let side = Quat::from_rotation_z(s.range_f32(-1.15, 1.15)).rotate_unfused(out);
                let along = (side + Vec3::NEG_Z * s.range_f32(-0.1, 0.5)).normalize_or(out);
                let size = s.range_f32(0.19, 0.34) * (1.15 - 0.45 * f);
                let shade = shades[((f * 3.0) as usize + s.below(2)).min(4)];
                let face = (Vec3::Z + direction(&mut s) * 0.6).normalize_or(Vec3::Z);
                leaves.leaf(p, along, face, Vec2::new(size * 1.5, size * 0.42), out * 0.8 + Vec3::Z * 0.6, shade);
                leaves.leaf(
                    p,
                    (along + direction(&mut s) * 0.5).normalize_or(along),
                    side,
                    Vec2::new(size, size * 0.35),
                    out + Vec3::Z * 0.3,
                    shade,
                );
            }
        }
    }
    let mut mesh = trunk.into_mesh();
    mesh.append(&leaves.finish(), Affine3A::IDENTITY);
    mesh
}

/// A cypress: a dense, narrow flame of upright sprays from the ground to the tip.
pub(crate) fn cypress(variant: u32) -> Mesh {
    let mut s = Stream::named(u64::from(variant), "cypress", &[]);
    let (h, widest) = [(9.5, 0.85), (7.5, 0.95), (11.0, 0.8)][variant as usize % 3];
    let shades = shades([[0.026, 0.058, 0.024], [0.034, 0.066, 0.026], [0.024, 0.052, 0.026]][variant as usize % 3]);
    let wood = bark([0.15, 0.11, 0.08]);
    let mut trunk = Sculpt::tube(
        &[(Vec3::Z * -0.05, 0.20), (Vec3::Z * 0.4, 0.15), (Vec3::Z * 0.6 * h, 0.07), (Vec3::Z * (h - 0.3), 0.01)],
        8,
        wood,
    );
    let outline = |t: f32| widest * math::pow(t + 0.03, 0.22) * math::pow((1.0 - t).max(0.0), 0.55);
    let mut leaves = Leaves::default();
    for i in 0..420 {
        let t = (i as f32 + s.f32()) / 420.0;
        let (sin, cos) = math::sin_cos(2.4 * i as f32 + s.range_f32(-0.3, 0.3));
        let out = Vec3::new(cos, sin, 0.0);
        let z = 0.35 + t * (h - 0.45);
        let tip = Vec3::Z * z + out * outline(t) * s.range_f32(0.72, 1.04);
        if i % 4 == 0 {
            trunk.add(Sculpt::tube(&[(Vec3::Z * (z - 0.5).max(0.2), 0.014), (tip, 0.005)], 4, wood));
        }
        let tone = s.below(2);
        for k in 0..34 {
            let inner = 1.0 - 0.5 * s.f32() * s.f32();
            let at = Vec3::new(tip.x * inner, tip.y * inner, tip.z) + direction(&mut s) * Vec3::new(0.16, 0.16, 0.26);
            let along = (Vec3::Z * 1.3 + out * 0.35 + direction(&mut s) * 0.5).normalize_or(Vec3::Z);
            let shade = shades[(tone + usize::from(inner > 0.8) + k % 2).min(4)];
            let size = s.range_f32(0.14, 0.24);
            leaves.leaf(
                at.max(Vec3::new(-9.0, -9.0, 0.1)),
                along,
                out,
                Vec2::new(size, 0.055),
                out + Vec3::Z * 0.25,
                shade,
            );
        }
    }
    let mut mesh = trunk.into_mesh();
    mesh.append(&leaves.finish(), Affine3A::IDENTITY);
    mesh
}
