//! Leaves and bark.

use endless_scene::{Material, Mesh, Surface};
use endless_world::{ClassTag, Stream, math};
use glam::{Vec2, Vec3};
use std::f32::consts::TAU;

pub(crate) const fn bark(color: [f32; 3]) -> Material {
    Material::new(Surface::Bark, color, ClassTag::Vegetation)
}

/// Shades of one green, so that a crown is not of one colour.
pub(crate) fn shades(color: [f32; 3]) -> [Material; 5] {
    [0.62, 0.8, 1.0, 1.18, 1.38].map(|k: f32| {
        // Young leaves are yellower.
        let young = (k - 1.0).max(0.0);
        let c = [color[0] * (k + 0.5 * young), color[1] * k, color[2] * (k - 0.4 * young)];
        Material::new(Surface::Foliage, c, ClassTag::Vegetation)
    })
}

/// A random unit vector.
pub(crate) fn direction(s: &mut Stream) -> Vec3 {
    let z = s.range_f32(-1.0, 1.0);
    let (sin, cos) = math::sin_cos(s.range_f32(0.0, TAU));
    let r = (1.0 - z * z).max(0.0).sqrt();
    Vec3::new(r * cos, r * sin, z)
}

/// Leaves collected into one mesh.
#[derive(Debug, Default)]
pub(crate) struct Leaves {
    mesh: Mesh,
}

/// Leaves around a point, metres.
pub(crate) struct Clump {
    pub(crate) centre: Vec3,
    pub(crate) radius: f32,
    pub(crate) count: usize,
    /// Length of a leaf.
    pub(crate) size: f32,
    /// Away from the crown's middle.
    pub(crate) out: Vec3,
}

impl Leaves {
    /// A kite-shaped leaf of two triangles from its stalk along `along`, its face near `face`. `shading` is the normal
    /// it is lit with: that of the crown rather than its own.
    pub(crate) fn leaf(&mut self, stalk: Vec3, along: Vec3, face: Vec3, size: Vec2, shading: Vec3, material: Material) {
        let side = along.cross(face).normalize_or(along.any_orthonormal_vector());
        let face = side.cross(along).normalize_or(Vec3::Z);
        let middle = stalk + along * size.x * 0.45;
        // A little folded along the midrib.
        let wing = |k: f32| middle + side * k * size.y * 0.5 + face * size.y * 0.12;
        let mut corners = [stalk, wing(-1.0), stalk + along * size.x, wing(1.0)];
        let normal = shading.normalize_or(Vec3::Z);
        if (corners[2] - corners[0]).cross(corners[3] - corners[1]).dot(normal) < 0.0 {
            corners.swap(1, 3);
        }
        let base = self.mesh.positions.len() as u32;
        for (p, uv) in corners.into_iter().zip([Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y]) {
            self.mesh.positions.push(p);
            self.mesh.normals.push(normal);
            self.mesh.uvs.push(uv);
        }
        let m = self.mesh.material_index(material);
        for t in [[0, 1, 2], [0, 2, 3]] {
            let [a, b, c] = t.map(|i: u32| self.mesh.positions[(base + i) as usize]);
            // The fold may turn one half away from the shading normal.
            let flips = (b - a).cross(c - a).dot(normal) < 0.0;
            let t = if flips { [t[0], t[2], t[1]] } else { t };
            self.mesh.triangles.push(t.map(|i| base + i));
            self.mesh.triangle_materials.push(m);
        }
    }

    /// A loose clump of leaves.
    pub(crate) fn clump(&mut self, clump: &Clump, shades: &[Material; 5], s: &mut Stream) {
        let Clump { centre, radius, count, size, out } = *clump;
        let tone = s.below(3);
        for _ in 0..count {
            let d = direction(s);
            let r = radius * math::pow(s.f32(), 0.45);
            let stalk = centre + d * Vec3::new(1.0, 1.0, 0.72) * r;
            let along = (direction(s) + 0.7 * d + Vec3::NEG_Z * 0.35).normalize_or(Vec3::X);
            let face = (direction(s) * 0.7 + Vec3::Z * 0.8 + out * 0.5).normalize_or(Vec3::Z);
            let length = size * s.range_f32(0.75, 1.3);
            // Leaves deep in a clump are older and darker.
            let depth = usize::from(r > 0.55 * radius) + usize::from(d.z > 0.2);
            let material = shades[(tone + depth).min(4)];
            let shading = out * 0.75 + d * 0.55 + Vec3::Z * 0.25;
            self.leaf(stalk, along, face, Vec2::new(length, length * 0.62), shading, material);
        }
    }

    pub(crate) fn finish(self) -> Mesh {
        self.mesh
    }
}
