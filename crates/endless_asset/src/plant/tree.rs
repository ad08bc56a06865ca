//! Broadleaf trees and conifers.

use super::leaf::{Leaves, bark, direction, shades};
use crate::shape::Sculpt;
use crate::{Material, Mesh};
use endless_world::{Stream, math};
use glam::{Affine3A, Quat, Vec2, Vec3};
use std::f32::consts::TAU;

/// A kind of broadleaf tree.
struct Kind {
    height: f32,
    /// Height where the crown begins, over the height.
    fork: f32,
    /// Semi-axes of the crown over the height: across, and up.
    crown: [f32; 2],
    /// Trunk radius at breast height.
    trunk: f32,
    leaf: f32,
    green: [f32; 3],
    bark: [f32; 3],
    /// Share of clumps: airy 0.6 to dense 1.2.
    density: f32,
}

const KINDS: [Kind; 8] = [
    // Plane, lime, maple, robinia, ash, flowering cherry, hornbeam, ficus.
    Kind {
        height: 10.5,
        fork: 0.30,
        crown: [0.36, 0.36],
        trunk: 0.20,
        leaf: 0.19,
        green: [0.075, 0.135, 0.028],
        bark: [0.27, 0.25, 0.19],
        density: 0.95,
    },
    Kind {
        height: 9.6,
        fork: 0.27,
        crown: [0.28, 0.39],
        trunk: 0.16,
        leaf: 0.15,
        green: [0.060, 0.125, 0.030],
        bark: [0.14, 0.12, 0.10],
        density: 1.1,
    },
    Kind {
        height: 8.4,
        fork: 0.28,
        crown: [0.36, 0.36],
        trunk: 0.15,
        leaf: 0.16,
        green: [0.080, 0.120, 0.024],
        bark: [0.17, 0.14, 0.11],
        density: 1.0,
    },
    Kind {
        height: 9.0,
        fork: 0.34,
        crown: [0.33, 0.31],
        trunk: 0.15,
        leaf: 0.13,
        green: [0.095, 0.155, 0.040],
        bark: [0.12, 0.10, 0.08],
        density: 0.75,
    },
    Kind {
        height: 11.0,
        fork: 0.32,
        crown: [0.30, 0.34],
        trunk: 0.18,
        leaf: 0.15,
        green: [0.055, 0.105, 0.028],
        bark: [0.20, 0.18, 0.15],
        density: 0.85,
    },
    Kind {
        height: 7.2,
        fork: 0.26,
        crown: [0.38, 0.33],
        trunk: 0.13,
        leaf: 0.14,
        green: [0.085, 0.100, 0.030],
        bark: [0.10, 0.06, 0.05],
        density: 0.9,
    },
    Kind {
        height: 8.8,
        fork: 0.22,
        crown: [0.20, 0.41],
        trunk: 0.13,
        leaf: 0.13,
        green: [0.048, 0.110, 0.026],
        bark: [0.16, 0.15, 0.13],
        density: 1.15,
    },
    Kind {
        height: 7.6,
        fork: 0.30,
        crown: [0.42, 0.32],
        trunk: 0.19,
        leaf: 0.15,
        green: [0.038, 0.090, 0.022],
        bark: [0.22, 0.20, 0.17],
        density: 1.1,
    },
];

/// How many broadleaf trees there are.
pub(crate) const BROADLEAF_VARIANTS: u32 = KINDS.len() as u32;
/// How many conifers there are.
pub(crate) const CONIFER_VARIANTS: u32 = 3;

/// A bent, tapered branch.
fn branch(
    from: Vec3,
    to: Vec3,
    r0: f32,
    r1: f32,
    sag: f32,
    sides: usize,
    material: Material,
    s: &mut Stream,
) -> Sculpt {
    let n = 4;
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

/// A broadleaf street tree.
pub(crate) fn broadleaf(variant: u32) -> Mesh {
    let kind = &KINDS[variant as usize % KINDS.len()];
    let mut s = Stream::named(u64::from(variant), "broadleaf", &[]);
    let wood = bark(kind.bark);
    let shades = shades(kind.green);
    let h = kind.height;
    let [across, up] = kind.crown.map(|k| k * h);
    let middle = Vec3::new(0.0, 0.0, h - up);
    let fork = Vec3::new(s.range_f32(-0.12, 0.12), s.range_f32(-0.12, 0.12), kind.fork * h);
    let mut trunk = Sculpt::tube(
        &[
            (Vec3::new(0.0, 0.0, -0.05), kind.trunk * 1.55),
            (Vec3::new(0.0, 0.0, 0.12), kind.trunk * 1.2),
            (Vec3::new(0.02, -0.01, 0.5), kind.trunk),
            (0.5 * fork + Vec3::new(0.03, 0.02, 0.0), kind.trunk * 0.92),
            (fork, kind.trunk * 0.85),
        ],
        10,
        wood,
    );
    // The leader goes on to near the top.
    let top = Vec3::new(fork.x, fork.y, h - 0.35 * up);
    trunk.add(branch(fork - Vec3::Z * 0.1, top, kind.trunk * 0.75, 0.03, 0.0, 7, wood, &mut s));
    let mut leaves = Leaves::default();
    let limbs = 9;
    let phase = s.range_f32(0.0, TAU);
    for i in 0..limbs {
        let t = i as f32 / limbs as f32;
        // Golden angle around the trunk.
        let (sin, cos) = math::sin_cos(phase + 2.4 * i as f32 + s.range_f32(-0.3, 0.3));
        let from = fork.lerp(top, 0.75 * t);
        let rise = -0.45 + 1.15 * t + s.range_f32(-0.12, 0.12);
        let reach = s.range_f32(0.62, 0.88);
        let flat = (1.0 - (rise * 0.85) * (rise * 0.85)).max(0.1).sqrt();
        let to = middle + Vec3::new(cos * flat * across, sin * flat * across, rise * up) * reach;
        let r = kind.trunk * (0.46 - 0.2 * t);
        trunk.add(branch(from, to, r, r * 0.3, 0.10 * (to - from).length(), 6, wood, &mut s));
        for _ in 0..3 {
            let k = s.range_f32(0.4, 0.9);
            let twig = from.lerp(to, k);
            let d = (to - from).normalize_or(Vec3::Z) + direction(&mut s) * 0.9;
            let end = twig + d.normalize_or(Vec3::Z) * across * s.range_f32(0.25, 0.45);
            trunk.add(branch(twig, end, r * 0.32, 0.012, 0.03, 5, wood, &mut s));
        }
    }
    // Clumps fill a shell of the crown unevenly: gaps let the sky through.
    let clumps = (190.0 * kind.density) as usize;
    let lobes: Vec<(Vec3, f32)> = (0..9).map(|_| (direction(&mut s), s.range_f32(0.86, 1.12))).collect();
    for _ in 0..clumps {
        let d = direction(&mut s);
        let (_, bulge) =
            lobes.iter().fold((-2.0, 1.0), |best, &(l, k)| if l.dot(d) > best.0 { (l.dot(d), k) } else { best });
        let r = math::pow(s.range_f32(0.06, 1.0), 0.45) * bulge;
        let mut p = middle + Vec3::new(d.x * across, d.y * across, d.z * up) * r * 0.9;
        // The underside is flatter.
        if d.z < 0.0 {
            p.z = middle.z + 0.82 * (p.z - middle.z);
        }
        let out = ((p - middle) / Vec3::new(across, across, up)).normalize_or(Vec3::Z);
        let radius = s.range_f32(0.075, 0.135) * h * 0.62;
        leaves.clump(p, radius, 76, kind.leaf * 1.22, out, &shades, &mut s);
    }
    let mut mesh = trunk.into_mesh();
    mesh.append(&leaves.finish(), Affine3A::IDENTITY);
    mesh
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
            trunk.add(branch(Vec3::Z * z, tip, 0.012 + 0.018 * (1.0 - t), 0.006, 0.06 * reach, 4, wood, &mut s));
            let sprays = 5 + (reach * 22.0) as usize;
            for j in 0..sprays {
                let f = math::lerp(0.18, 1.0, (j as f32 + s.f32()) / sprays as f32);
                let p = (Vec3::Z * z).lerp(tip, f) + Vec3::Z * 0.06 * reach * 4.0 * f * (1.0 - f);
                let side = Quat::from_rotation_z(s.range_f32(-1.15, 1.15)) * out;
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
