//! Bushes, hedges and planters.

use super::leaf::{Leaves, bark, direction, shades};
use crate::shape::Sculpt;
use crate::{Material, Mesh, Surface};
use endless_world::{ClassTag, Stream};
use glam::{Affine3A, Vec2, Vec3};

/// A bush of about a metre.
pub(crate) fn bush(variant: u32) -> Mesh {
    let mut s = Stream::named(u64::from(variant), "bush", &[]);
    let greens = [[0.050, 0.105, 0.028], [0.075, 0.120, 0.030], [0.038, 0.080, 0.030], [0.090, 0.125, 0.045]];
    let shades = shades(greens[variant as usize % 4]);
    let wood = bark([0.12, 0.09, 0.07]);
    let (r, h) = (s.range_f32(0.48, 0.62), s.range_f32(0.85, 1.15));
    let mut twigs = Sculpt::new();
    let mut leaves = Leaves::default();
    let middle = Vec3::Z * 0.45 * h;
    for _ in 0..30 {
        let d = direction(&mut s);
        let p = middle + Vec3::new(d.x * r, d.y * r, d.z.max(-0.75) * 0.5 * h) * s.range_f32(0.55, 0.95);
        twigs.add(Sculpt::tube(&[(Vec3::new(d.x * 0.06, d.y * 0.06, -0.03), 0.010), (p, 0.004)], 4, wood));
        leaves.clump(
            p,
            0.22,
            55,
            0.075,
            ((p - middle) / Vec3::new(r, r, 0.5 * h)).normalize_or(Vec3::Z),
            &shades,
            &mut s,
        );
    }
    let mut mesh = twigs.into_mesh();
    mesh.append(&leaves.finish(), Affine3A::IDENTITY);
    mesh
}

/// A clipped metre of hedge: leaves along its faces over a dark core of twigs.
pub(crate) fn hedge(variant: u32) -> Mesh {
    let mut s = Stream::named(u64::from(variant), "hedge", &[]);
    let shades = shades([[0.040, 0.092, 0.026], [0.055, 0.105, 0.030]][variant as usize % 2]);
    let core = Material { base_color: [0.014, 0.026, 0.010], ..shades[0] };
    let mut mesh = Sculpt::cuboid(Vec3::new(-0.5, -0.22, 0.0), Vec3::new(0.5, 0.22, 0.90), 0.0, core).into_mesh();
    let mut leaves = Leaves::default();
    let half = Vec3::new(0.5, 0.27, 0.48);
    let middle = Vec3::Z * 0.49;
    // Each face in proportion to its area, top thickest.
    let faces = [(Vec3::Z, 1000), (Vec3::Y, 1500), (Vec3::NEG_Y, 1500), (Vec3::X, 420), (Vec3::NEG_X, 420)];
    for (out, count) in faces {
        for _ in 0..count {
            let spread = Vec3::new(s.range_f32(-1.0, 1.0), s.range_f32(-1.0, 1.0), s.range_f32(-1.0, 1.0));
            let depth = s.range_f32(-0.07, 0.025);
            let p = middle + spread * half * (Vec3::ONE - out.abs()) + out * (out.abs().dot(half) + depth);
            let along = (direction(&mut s) + out * 0.4).normalize_or(out);
            let face = (out + direction(&mut s) * 0.7).normalize_or(out);
            let shade = shades[(1 + usize::from(depth > -0.03) + s.below(2) + usize::from(out.z > 0.5)).min(4)];
            let size = s.range_f32(0.055, 0.10);
            let stalk = Vec3::new((p.x).clamp(-0.5, 0.5), p.y, p.z.max(0.01));
            leaves.leaf(stalk, along, face, Vec2::new(size, size * 0.6), out + direction(&mut s) * 0.45, shade);
        }
    }
    mesh.append(&leaves.finish(), Affine3A::IDENTITY);
    mesh
}

/// A concrete planter box with flowers.
pub(crate) fn planter(variant: u32) -> Mesh {
    let mut s = Stream::named(u64::from(variant), "planter", &[]);
    let concrete = Material::new(Surface::Concrete, [0.42, 0.41, 0.39], ClassTag::Static);
    let soil = Material::new(Surface::Soil, [0.06, 0.045, 0.03], ClassTag::Terrain);
    let mut tub = Sculpt::cuboid(Vec3::new(-0.6, -0.3, 0.0), Vec3::new(0.6, 0.3, 0.48), 0.03, concrete);
    tub.add(Sculpt::cuboid(Vec3::new(-0.53, -0.23, 0.44), Vec3::new(0.53, 0.23, 0.485), 0.0, soil));
    let green = shades([0.060, 0.115, 0.030]);
    let petals = [[0.62, 0.05, 0.06], [0.68, 0.42, 0.03], [0.55, 0.10, 0.42], [0.72, 0.70, 0.66]];
    let petal = |i: usize| Material::new(Surface::Foliage, petals[(variant as usize + i) % 4], ClassTag::Vegetation);
    let mut leaves = Leaves::default();
    for i in 0..26 {
        let p = Vec3::new(s.range_f32(-0.5, 0.5), s.range_f32(-0.2, 0.2), s.range_f32(0.53, 0.66));
        leaves.clump(p, 0.13, 34, 0.075, Vec3::Z, &green, &mut s);
        for _ in 0..3 {
            let head = p + Vec3::new(s.range_f32(-0.08, 0.08), s.range_f32(-0.08, 0.08), s.range_f32(0.06, 0.14));
            for k in 0..5 {
                let (sin, cos) = endless_world::math::sin_cos(1.2566 * k as f32);
                leaves.leaf(
                    head,
                    Vec3::new(cos, sin, 0.25).normalize_or(Vec3::X),
                    Vec3::Z,
                    Vec2::new(0.04, 0.032),
                    Vec3::Z,
                    petal(i % 2),
                );
            }
        }
    }
    let mut mesh = tub.into_mesh();
    mesh.append(&leaves.finish(), Affine3A::IDENTITY);
    mesh
}
