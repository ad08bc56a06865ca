//! Bushes, hedges and planters.

use super::leaf::{Clump, Leaves, bark, direction, shades};
use crate::shape::Sculpt;
use endless_scene::{Material, Mesh, Surface};
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
        let out = ((p - middle) / Vec3::new(r, r, 0.5 * h)).normalize_or(Vec3::Z);
        leaves.clump(&Clump { centre: p, radius: 0.22, count: 55, size: 0.075, out }, &shades, &mut s);
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
        leaves.clump(&Clump { centre: p, radius: 0.13, count: 34, size: 0.075, out: Vec3::Z }, &green, &mut s);
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

/// A tuft of grass half a metre across.
pub(crate) fn grass(variant: u32) -> Mesh {
    let mut s = Stream::named(u64::from(variant), "grass tuft", &[]);
    let greens = shades([[0.085, 0.150, 0.035], [0.125, 0.150, 0.050], [0.190, 0.170, 0.085]][variant as usize % 3]);
    let mut leaves = Leaves::default();
    for _ in 0..420 {
        let (sin, cos) = endless_world::math::sin_cos(s.range_f32(0.0, std::f32::consts::TAU));
        let out = Vec3::new(cos, sin, 0.0);
        let r = s.f32() * 0.22;
        let height = s.range_f32(0.14, 0.38) * (1.15 - 1.8 * r);
        let rise = (Vec3::Z + out * s.range_f32(0.05, 0.5)).normalize_or(Vec3::Z);
        let shade = greens[s.below(5)];
        let foot = out * r;
        leaves.leaf(foot, rise, out, Vec2::new(height, 0.012), Vec3::Z + out * 0.5, shade);
        let bent = (rise + out * 0.7).normalize_or(rise);
        leaves.leaf(foot + rise * height * 0.8, bent, out, Vec2::new(0.5 * height, 0.009), Vec3::Z + out * 0.5, shade);
    }
    leaves.finish()
}

/// A square block of ripe or green wheat of 2 m, 0.9 m high.
pub(crate) fn wheat(variant: u32) -> Mesh {
    let mut s = Stream::named(u64::from(variant), "wheat", &[]);
    let ripe = !variant.is_multiple_of(2);
    let straw = shades(if ripe { [0.40, 0.29, 0.11] } else { [0.11, 0.17, 0.05] });
    let ears = shades(if ripe { [0.48, 0.33, 0.12] } else { [0.17, 0.20, 0.07] });
    let mut leaves = Leaves::default();
    for i in 0..1500 {
        let row = i % 14;
        let at = Vec3::new(s.range_f32(-1.0, 1.0), -0.93 + 0.143 * row as f32 + s.range_f32(-0.03, 0.03), 0.0);
        let (sin, cos) = endless_world::math::sin_cos(s.range_f32(0.0, std::f32::consts::TAU));
        let side = Vec3::new(cos, sin, 0.0);
        let height = s.range_f32(0.72, 0.88);
        let rise = (Vec3::Z + side * 0.08).normalize_or(Vec3::Z);
        leaves.leaf(at, rise, side, Vec2::new(height, 0.012), Vec3::Z + side * 0.4, straw[1 + s.below(3)]);
        let nod = (Vec3::Z * 0.8 + side * 0.6).normalize_or(Vec3::Z);
        let top = at + rise * height * 0.96;
        for turn in [side, side.cross(Vec3::Z)] {
            leaves.leaf(top, nod, turn, Vec2::new(0.10, 0.026), Vec3::Z + side * 0.5, ears[1 + s.below(4)]);
        }
        if i % 2 == 0 {
            let blade = (side + Vec3::Z * 0.7).normalize_or(side);
            leaves.leaf(
                at + rise * height * 0.45,
                blade,
                Vec3::Z,
                Vec2::new(0.24, 0.014),
                Vec3::Z + side,
                straw[s.below(4)],
            );
        }
    }
    leaves.finish()
}

/// A bed of flowers 2 m by 1 m in an edging of stones.
pub(crate) fn flower_bed(variant: u32) -> Mesh {
    let mut s = Stream::named(u64::from(variant), "flower bed", &[]);
    let soil = Material::new(Surface::Soil, [0.06, 0.045, 0.03], ClassTag::Terrain);
    let stone = Material::new(Surface::Concrete, [0.40, 0.38, 0.35], ClassTag::Terrain);
    let mut bed = Sculpt::cuboid(Vec3::new(-0.96, -0.46, 0.0), Vec3::new(0.96, 0.46, 0.07), 0.0, soil);
    for side in [-1.0f32, 1.0] {
        for k in 0..8 {
            let x = -1.0 + 0.25 * k as f32;
            let y = 0.5 * side;
            bed.add(Sculpt::cuboid(
                Vec3::new(x + 0.01, y - 0.05, 0.0),
                Vec3::new(x + 0.24, y + 0.05, 0.10),
                0.015,
                stone,
            ));
        }
        for k in 0..4 {
            let y = -0.45 + 0.225 * k as f32;
            let x = 1.0 * side;
            bed.add(Sculpt::cuboid(
                Vec3::new(x - 0.05, y + 0.01, 0.0),
                Vec3::new(x + 0.05, y + 0.215, 0.10),
                0.015,
                stone,
            ));
        }
    }
    let green = shades([0.060, 0.115, 0.030]);
    let petals = [[0.62, 0.05, 0.06], [0.72, 0.46, 0.03], [0.50, 0.10, 0.46], [0.74, 0.72, 0.68], [0.70, 0.22, 0.04]];
    let mut leaves = Leaves::default();
    for row in 0..5 {
        let color = petals[(row + variant as usize) % 5];
        let petal = Material::new(Surface::Foliage, color, ClassTag::Vegetation);
        for k in 0..11 {
            let x = -0.86 + 0.172 * k as f32 + s.range_f32(-0.04, 0.04);
            let p = Vec3::new(x, -0.36 + 0.18 * row as f32 + s.range_f32(-0.03, 0.03), 0.17);
            leaves.clump(&Clump { centre: p, radius: 0.10, count: 22, size: 0.075, out: Vec3::Z }, &green, &mut s);
            for _ in 0..2 {
                let head = p + Vec3::new(s.range_f32(-0.06, 0.06), s.range_f32(-0.06, 0.06), s.range_f32(0.08, 0.16));
                for i in 0..6 {
                    let (sin, cos) = endless_world::math::sin_cos(std::f32::consts::FRAC_PI_3 * i as f32);
                    let way = Vec3::new(cos, sin, 0.3).normalize_or(Vec3::X);
                    leaves.leaf(head, way, Vec3::Z, Vec2::new(0.045, 0.034), Vec3::Z, petal);
                }
            }
        }
    }
    let mut mesh = bed.into_mesh();
    mesh.append(&leaves.finish(), Affine3A::IDENTITY);
    mesh
}

/// A boulder, weathered along layers, half sunk into the ground.
pub(crate) fn rock(variant: u32) -> Mesh {
    let mut s = Stream::named(u64::from(variant), "rock", &[]);
    let tones = [[0.30, 0.29, 0.27], [0.36, 0.32, 0.26], [0.24, 0.24, 0.25]];
    let grey = Material::new(Surface::Concrete, tones[variant as usize % 3], ClassTag::Terrain);
    let radii = Vec3::new(s.range_f32(0.55, 0.95), s.range_f32(0.45, 0.7), s.range_f32(0.4, 0.65));
    let mut mesh = Sculpt::ellipsoid(Vec3::ZERO, radii, 26, grey).into_mesh_without_seams();
    // Planes that struck pieces off.
    let cuts: Vec<(Vec3, f32)> = (0..13).map(|_| (direction(&mut s), s.range_f32(0.62, 0.92))).collect();
    for p in &mut mesh.positions {
        for &(way, limit) in &cuts {
            let reach = (way * radii).length() * limit;
            let beyond = p.dot(way) - reach;
            if beyond > 0.0 {
                *p -= way * beyond * 0.92;
            }
        }
        p.z = p.z.max(-0.25 * radii.z) + 0.24 * radii.z;
    }
    faceted(&mesh)
}

/// The same with a normal a face.
fn faceted(mesh: &Mesh) -> Mesh {
    let mut s = Sculpt::new();
    for (t, &m) in mesh.triangles.iter().zip(&mesh.triangle_materials) {
        s.triangle(t.map(|i| mesh.positions[i as usize]), mesh.materials[usize::from(m)]);
    }
    s.smooth(24.0).into_mesh()
}
