//! Palms.

use super::leaf::{Leaves, bark, shades};
use crate::shape::Sculpt;
use endless_scene::Mesh;
use endless_world::{Stream, math};
use glam::{Affine3A, Vec2, Vec3};

/// A fan of arching feather leaves on a slender, ringed trunk.
pub(crate) fn palm(variant: u32) -> Mesh {
    let mut s = Stream::named(u64::from(variant), "palm", &[]);
    let h = [7.2, 8.6, 6.2][variant as usize % 3];
    let trunk_top = h - 1.3;
    let wood = bark([0.24, 0.20, 0.155]);
    let lean = Vec3::new(s.range_f32(-0.35, 0.35), s.range_f32(-0.35, 0.35), 0.0);
    let rings = 26;
    let path: Vec<(Vec3, f32)> = (0..=rings)
        .map(|i| {
            let t = i as f32 / rings as f32;
            let notch = if i % 2 == 0 { 1.0 } else { 0.93 };
            let r = (0.155 + 0.09 * math::pow(1.0 - t, 6.0)) * notch;
            (Vec3::Z * (-0.05 + t * (trunk_top + 0.05)) + lean * t * t, r)
        })
        .collect();
    let mut trunk = Sculpt::tube(&path, 10, wood);
    let heart = Vec3::Z * trunk_top + lean;
    trunk.add(Sculpt::ellipsoid(heart, Vec3::new(0.22, 0.22, 0.34), 10, bark([0.17, 0.15, 0.08])));
    let greens = shades([0.055, 0.105, 0.030]);
    let mut leaves = Leaves::default();
    let fronds = 30;
    for i in 0..fronds {
        let t = i as f32 / fronds as f32;
        let (sin, cos) = math::sin_cos(2.4 * i as f32 + s.range_f32(-0.15, 0.15));
        let out = Vec3::new(cos, sin, 0.0);
        // The youngest stand upright, the oldest hang.
        let rise = math::lerp(1.25, -0.35, t) + s.range_f32(-0.1, 0.1);
        let length = s.range_f32(2.1, 2.6) * (0.75 + 0.25 * (1.0 - (2.0 * t - 1.0).abs()));
        let at = |u: f32| {
            let (sin, cos) = math::sin_cos(rise);
            heart + out * (cos * u * length) + Vec3::Z * (0.15 + sin * u * length - 0.42 * length * u * u)
        };
        let rib: Vec<(Vec3, f32)> = (0..=6).map(|k| (at(k as f32 / 6.0), 0.022 - 0.003 * k as f32)).collect();
        trunk.add(Sculpt::tube(&rib, 4, bark([0.16, 0.17, 0.06])));
        let side = out.cross(Vec3::Z);
        let n = 34;
        for k in 2..n {
            let u = k as f32 / n as f32;
            let p = at(u);
            let forward = (at((u + 0.03).min(1.0)) - at(u - 0.03)).normalize_or(out);
            let size = 0.62 * math::sin(std::f32::consts::PI * (0.12 + 0.80 * u)).max(0.1);
            for sign in [-1.0, 1.0] {
                let along = (side * sign + forward * 0.75 - Vec3::Z * s.range_f32(0.15, 0.5)).normalize_or(side);
                let shade = greens[1 + s.below(3).min(if t > 0.8 { 1 } else { 3 })];
                leaves.leaf(p, along, Vec3::Z, Vec2::new(size, 0.055), Vec3::Z * 0.8 + out * 0.5, shade);
            }
        }
    }
    let mut mesh = trunk.into_mesh();
    mesh.append(&leaves.finish(), Affine3A::IDENTITY);
    mesh
}
