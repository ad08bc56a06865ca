//! What the first pass of a bake for one instant knows of single rays: [`super::sparse_primary`].

use super::packed_hit::PackedHit;
use super::primary_hits::PackedNormals;
use super::sun_rays::sun_origin;
use crate::accel::Ray;
use crate::light::{SUN_SAMPLES, Sun};
use crate::octahedron;
use crate::scene::{StaticScene, SurfaceInteraction};
use endless_scene::Surface;
use glam::Vec3A;

/// Rows of pixels whose centres are traced together, eight columns at a time.
pub(super) const ROWS: usize = 4;
/// The part of the sun's disc that is asked everywhere: half-way between its middle and its rim.
pub(super) const FIRST: usize = 1;
/// The parts of it that each sample asks near the edge of a shadow: eight directions a pixel.
pub(super) const PARTS: [usize; 2] = [FIRST, 3];
/// All parts of it.
pub(super) const WHOLE: u8 = (1 << SUN_SAMPLES) - 1;

/// What the ray through a pixel's centre met.
#[derive(Clone, Copy)]
pub(super) struct Centre {
    pub(super) distance: f32,
    pub(super) hit: PackedHit,
    pub(super) normals: PackedNormals,
    /// The triangle's, as its mesh numbers it.
    pub(super) material: u16,
    /// On a lens of a traffic light.
    pub(super) is_lens: bool,
    pub(super) sun: SunSeen,
}

/// What a sample's ray to the first part of the sun's disc says.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum SunSeen {
    /// The sun cannot light it, or there is none.
    Never,
    Lit,
    Shaded,
}

impl Centre {
    pub(super) const SKY: Self = Self {
        distance: f32::MAX,
        hit: PackedHit::NONE,
        normals: PackedNormals::NONE,
        material: 0,
        is_lens: false,
        sun: SunSeen::Never,
    };

    pub(super) fn is_sky(&self) -> bool {
        self.distance == f32::MAX
    }

    /// Whether a neighbour's centre lies on the same surface, or sees the sky, too; where that takes no look at places and
    /// normals.
    pub(super) fn evidently_continues(&self, other: &Self) -> Option<bool> {
        if self.is_sky() || other.is_sky() {
            return Some(self.is_sky() && other.is_sky());
        }
        let flat = self.hit.is_on_triangle_of(&other.hit) && self.normals.shading == other.normals.shading;
        if flat || self.is_lens {
            return Some(!self.is_lens);
        }
        let may_continue = self.hit.is_on_instance_of(&other.hit) && self.material == other.material;
        (!may_continue).then_some(false)
    }
}

/// The surface around a sample, as far as it tells whether others lie on it.
#[derive(Clone, Copy)]
pub(super) struct Piece {
    instance: u32,
    material: u16,
    /// Lenses of traffic lights are pixels of their own.
    lens: bool,
    position: Vec3A,
    geometric: Vec3A,
    shading: Vec3A,
}

impl Piece {
    pub(super) fn continues(&self, other: &Self) -> bool {
        self.instance == other.instance
            && self.material == other.material
            && !self.lens
            && self.shading.dot(other.shading) > 0.995
            && (other.position - self.position).dot(self.geometric).abs() < 0.02
    }
}

/// The ray of a point to a part of the sun's disc, as a sample of a pixel asks it.
pub(super) fn to_part(sun: &Sun, point: &SurfaceInteraction<'_>, sample: usize, part: usize) -> Ray {
    Ray { origin: sun_origin(&point.facet(), sun.direction), direction: sun.disc[sample][part], tmax: f32::MAX }
}

pub(super) fn piece(
    still: &StaticScene,
    ray: &Ray,
    distance: f32,
    hit: PackedHit,
    normals: &PackedNormals,
) -> Option<Piece> {
    let hit = hit.at(distance)?;
    let mesh = &*still.instances[hit.instance as usize].geometry.mesh;
    let material = mesh.triangle_materials[hit.triangle as usize];
    Some(Piece {
        instance: hit.instance,
        material,
        lens: matches!(mesh.materials[usize::from(material)].surface, Surface::SignalLens(_)),
        position: ray.origin + ray.direction * distance,
        geometric: octahedron::unpack(normals.geometric),
        shading: octahedron::unpack(normals.shading),
    })
}
