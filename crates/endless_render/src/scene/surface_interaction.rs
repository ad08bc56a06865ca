//! The hit of a ray on a surface.

use super::Instance;
use crate::accel::{Hit, Ray};
use crate::vec3x8::Vec3x8;
use endless_scene::{Material, Surface};
use endless_world::ClassTag;
use endless_world::math::UnfusedVec3A;
use glam::{Vec2, Vec3A};
use wide::f32x8;

/// A point to be lit.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ShadingPoint {
    /// World frame.
    pub(crate) position: Vec3A,
    /// Unit, on the side that the ray came from.
    pub(crate) geometric_normal: Vec3A,
    /// Unit direction of the ray that met it.
    pub(crate) direction: Vec3A,
    /// Distance from the ray's origin, metres.
    pub(crate) distance: f32,
}

/// How far from a surface rays start that leave it: at least, by distance seen from, and by the largest coordinate.
const AWAY: [f32; 3] = [1.5e-3, 2.0e-5, 4.0e-7];

impl ShadingPoint {
    /// The point of a ray at `distance` metres.
    pub(crate) fn along(ray: &Ray, distance: f32, geometric_normal: Vec3A) -> Self {
        Self { position: ray.origin + ray.direction * distance, geometric_normal, direction: ray.direction, distance }
    }

    /// Origin for rays that leave the surface, offset so that they do not hit it again.
    pub(crate) fn ray_origin(&self) -> Vec3A {
        let [least, by_distance, by_position] = AWAY;
        let away = least + by_distance * self.distance + by_position * self.position.abs().max_element();
        self.position + self.geometric_normal * away
    }
}

/// [`ShadingPoint::ray_origin`] of eight points.
pub(crate) fn ray_origins8(positions: &Vec3x8, normals: &Vec3x8, distances: f32x8) -> Vec3x8 {
    let [least, by_distance, by_position] = AWAY.map(f32x8::splat);
    let [x, y, z] = positions.map(f32x8::abs);
    let away = least + by_distance * distances + by_position * x.fast_max(y).fast_max(z);
    std::array::from_fn(|k| positions[k] + normals[k] * away)
}

/// Everything that shading needs to know of a hit.
#[derive(Debug, Clone)]
pub(crate) struct SurfaceInteraction<'a> {
    pub(crate) instance: &'a Instance,
    /// Of the instance's mesh.
    pub(crate) triangle: u32,
    pub(crate) material: &'a Material,
    /// World frame.
    pub(crate) position: Vec3A,
    /// Unit, on the side that the ray came from.
    pub(crate) geometric_normal: Vec3A,
    /// Unit, interpolated, on the side that the ray came from.
    pub(crate) normal: Vec3A,
    /// Object frame.
    pub(crate) object_position: Vec3A,
    pub(crate) uv: Vec2,
    /// Distance from the ray's origin, metres.
    pub(crate) distance: f32,
    /// Unit direction of the ray that met it.
    pub(crate) direction: Vec3A,
    /// Share of the surroundings seen past its own body, 0 to 1.
    pub(crate) ambient_occlusion: f32,
    /// Whether the ray met the inner side.
    pub(crate) from_behind: bool,
}

impl<'a> SurfaceInteraction<'a> {
    /// The point of a hit; the ray's direction must be of unit length.
    pub(crate) fn new(instances: &'a [Instance], ray: &Ray, hit: &Hit) -> Self {
        let instance = &instances[hit.instance as usize];
        let triangle = hit.triangle as usize;
        let mesh = &*instance.geometry.mesh;
        let [a, b, c] = mesh.triangles[triangle].map(|i| i as usize);
        let posed = &instance.geometry.posed;
        let positions = posed.positions();
        let corner = |i: usize| Vec3A::from(positions[i]);
        let (pa, pb, pc) = (corner(a), corner(b), corner(c));
        let w = 1.0 - hit.u - hit.v;
        let object_position = pa * w + pb * hit.u + pc * hit.v;
        let smooth = posed.normal(a) * w + posed.normal(b) * hit.u + posed.normal(c) * hit.v;
        let flat = (pb - pa).cross_unfused(pc - pa);
        let mut geometric_normal = (instance.normal_matrix * flat).normalize_or(Vec3A::Z);
        let mut normal = (instance.normal_matrix * smooth).normalize_or(geometric_normal);
        // Mirrored instances turn the winding round: let the vertex normals decide which side is out.
        if geometric_normal.dot(normal) < 0.0 {
            geometric_normal = -geometric_normal;
        }
        let from_behind = geometric_normal.dot(ray.direction) > 0.0;
        if from_behind {
            geometric_normal = -geometric_normal;
            normal = -normal;
        }
        // An interpolated normal may lean away from the viewer at silhouettes: bend it back.
        let facing = normal.dot(ray.direction);
        if facing > -0.02 {
            normal = (normal - ray.direction * (facing + 0.02)).normalize_or(geometric_normal);
        }
        let uv = mesh.uvs[a] * w + mesh.uvs[b] * hit.u + mesh.uvs[c] * hit.v;
        let ambient_occlusion = match &instance.geometry.ambient_occlusion {
            None => 1.0,
            Some(open) => open.at(a) * w + open.at(b) * hit.u + open.at(c) * hit.v,
        };
        Self {
            instance,
            triangle: hit.triangle,
            material: instance.material_of(hit.triangle).1,
            position: ray.origin + ray.direction * hit.t,
            geometric_normal,
            normal,
            object_position,
            uv,
            distance: hit.t,
            direction: ray.direction,
            ambient_occlusion,
            from_behind,
        }
    }

    /// Origin of the ray.
    pub(crate) fn seen_from(&self) -> Vec3A {
        self.position - self.direction * self.distance
    }

    /// The part that lights need.
    pub(crate) fn facet(&self) -> ShadingPoint {
        let Self { position, geometric_normal, direction, distance, .. } = *self;
        ShadingPoint { position, geometric_normal, direction, distance }
    }

    /// The class of the pixel.
    pub(crate) fn tag(&self) -> ClassTag {
        self.instance.class.unwrap_or(self.material.tag)
    }

    /// Whether it lies on a lens of a traffic light.
    pub(crate) fn is_signal_lens(&self) -> bool {
        matches!(self.material.surface, Surface::SignalLens(_)) && self.instance.signal.is_some()
    }

    /// Origin for rays that leave the surface, offset so that they do not hit it again.
    pub(crate) fn ray_origin(&self) -> Vec3A {
        self.facet().ray_origin()
    }
}
