//! Joins the parts of a model to one mesh and bakes its textures: each triangle gets one colour, and triangles are
//! subdivided where a texture changes.

use super::model::SourcePart;
use super::source_material::{SourceMaterial, TextureMapping};
use endless_scene::{Material, Mesh, Surface};
use endless_world::ClassTag;
use glam::{Vec2, Vec3, Vec4};
use std::collections::BTreeMap;

/// Edges are cut until they are this short where colours change, metres.
const FINEST_M: f32 = 0.035;
/// Colours that differ by less than this (square root of linear light) are one.
const SAME: f32 = 0.07;
/// Levels of a colour channel.
const LEVELS: f32 = 40.0;
/// Triangles that cutting may make of a model.
const MOST_CUT: usize = 300_000;

/// A corner of a triangle while it is cut.
#[derive(Debug, Clone, Copy)]
struct Corner {
    position: Vec3,
    normal: Vec3,
    uv: Vec2,
    color: Vec3,
}

impl Corner {
    fn between(self, other: Self) -> Self {
        Self {
            position: 0.5 * (self.position + other.position),
            normal: (self.normal + other.normal).normalize_or(self.normal),
            uv: 0.5 * (self.uv + other.uv),
            color: 0.5 * (self.color + other.color),
        }
    }
}

/// Bakes textured parts, in their final place, into one mesh.
pub(super) struct TextureBaker<'a> {
    source: &'a [SourceMaterial],
    /// Class of materials that name none.
    tag: ClassTag,
    /// Whether the file's own classes count: not for vehicles, which are of one class.
    own_tags: bool,
    mesh: Mesh,
    materials: BTreeMap<(usize, [u32; 3]), u16>,
    cut: usize,
}

impl<'a> TextureBaker<'a> {
    pub(super) fn new(source: &'a [SourceMaterial], tag: ClassTag, own_tags: bool) -> Self {
        Self { source, tag, own_tags, mesh: Mesh::default(), materials: BTreeMap::new(), cut: 0 }
    }

    pub(super) fn finish(self) -> Mesh {
        self.mesh
    }

    /// Adds a part, moved.
    pub(super) fn add(&mut self, part: &SourcePart, by: Vec3) {
        let material = &self.source[part.material_index];
        let plain = part.colors.iter().all(|&c| c == Vec3::ONE);
        let base = self.mesh.positions.len() as u32;
        let textured = material.texture.as_ref().filter(|_| !matches!(material.surface, Surface::CarGlass));
        if textured.is_none() {
            self.mesh.positions.extend(part.positions.iter().map(|&p| p + by));
            self.mesh.normals.extend_from_slice(&part.normals);
            self.mesh.uvs.extend_from_slice(&part.uvs);
            for t in &part.triangles {
                let shade = t.iter().map(|&i| part.colors[i as usize]).sum::<Vec3>() / 3.0;
                let color = self.source[part.material_index].color.truncate() * if plain { Vec3::ONE } else { shade };
                let material = self.material(part.material_index, color, plain);
                self.mesh.triangles.push(t.map(|i| i + base));
                self.mesh.triangle_materials.push(material);
            }
            return;
        }
        let corner = |i: u32| {
            let i = i as usize;
            Corner { position: part.positions[i] + by, normal: part.normals[i], uv: part.uvs[i], color: part.colors[i] }
        };
        if let Some(texture) = textured {
            for t in &part.triangles {
                self.cut(part.material_index, texture, t.map(corner));
            }
        }
    }

    fn cut(&mut self, material_index: usize, texture: &TextureMapping, corners: [Corner; 3]) {
        let [a, b, c] = corners;
        let sample = TextureSample::of(texture, corners);
        let long = [(a, b), (b, c), (c, a)].iter().map(|(p, q)| p.position.distance(q.position)).fold(0.0, f32::max);
        if sample.spread > SAME && long > FINEST_M && self.cut < MOST_CUT {
            self.cut += 3;
            let [ab, bc, ca] = [a.between(b), b.between(c), c.between(a)];
            for small in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
                self.cut(material_index, texture, small);
            }
            return;
        }
        let own = &self.source[material_index];
        if own.cutoff.is_some_and(|least| sample.mean.w * own.color.w < least) {
            return;
        }
        let shade = (a.color + b.color + c.color) / 3.0;
        let material = self.material(material_index, own.color.truncate() * sample.mean.truncate() * shade, false);
        let base = self.mesh.positions.len() as u32;
        for corner in corners {
            self.mesh.positions.push(corner.position);
            self.mesh.normals.push(corner.normal);
            self.mesh.uvs.push(corner.uv);
        }
        self.mesh.triangles.push([base, base + 1, base + 2]);
        self.mesh.triangle_materials.push(material);
    }

    /// The mesh's material for a source material in a colour. Colours of textures are rounded, so that there are not too many.
    fn material(&mut self, material_index: usize, color: Vec3, exact: bool) -> u16 {
        let own = &self.source[material_index];
        let rounded = color.map(|c| {
            let level = (c.clamp(0.0, 1.0).sqrt() * LEVELS).round() / LEVELS;
            level * level
        });
        let color = if exact { color } else { rounded };
        let tag = own.tag.filter(|_| self.own_tags).unwrap_or(self.tag);
        let known = &mut self.materials;
        let materials = &mut self.mesh.materials;
        *known.entry((material_index, color.to_array().map(f32::to_bits))).or_insert_with(|| {
            // Full tables take the nearest that is there: the last.
            if materials.len() < usize::from(u16::MAX) {
                materials.push(Material::new(own.surface, color.to_array(), tag));
            }
            (materials.len() - 1) as u16
        })
    }
}

/// The colours of a texture over one triangle.
struct TextureSample {
    mean: Vec4,
    /// Largest difference of a sample from the mean, as the eye has it.
    spread: f32,
}

impl TextureSample {
    /// Looks at fifteen places.
    fn of(texture: &TextureMapping, corners: [Corner; 3]) -> Self {
        let [a, b, c] = corners.map(|c| c.uv);
        let mut samples = [Vec4::ZERO; 15];
        let mut k = 0;
        for i in 0..5u8 {
            for j in 0..5 - i {
                let (u, v) = ((f32::from(i) + 0.33) / 5.0, (f32::from(j) + 0.33) / 5.0);
                samples[k] = texture.at(a + (b - a) * u + (c - a) * v);
                k += 1;
            }
        }
        let mean = samples.iter().sum::<Vec4>() / 15.0;
        let eye = |v: Vec4| v.max(Vec4::ZERO).map(f32::sqrt);
        let spread = samples.iter().map(|&s| (eye(s) - eye(mean)).abs().max_element()).fold(0.0, f32::max);
        Self { mean, spread }
    }
}
