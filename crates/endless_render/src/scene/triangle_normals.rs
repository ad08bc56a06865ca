//! The normals of hits on one triangle, eight at a time: the same bits as those of a
//! [`SurfaceInteraction`](super::SurfaceInteraction), of which nothing else is needed where the first rays end.

use super::Instance;
use crate::vec3x8::{Vec3x8, dot, normalize_or, splat};
use endless_world::math::UnfusedVec3A;
use glam::Vec3A;
use wide::f32x8;

/// A triangle of an instance, as far as normals depend on it.
pub(crate) struct TriangleNormals {
    /// Unit normal of the triangle, on either side.
    flat: Vec3A,
    /// Normals of its corners, object frame.
    corners: [Vec3A; 3],
    /// Columns of the matrix that turns them into the world's frame.
    to_world: [Vec3A; 3],
}

/// Of eight hits, world frame.
pub(crate) struct Normals8 {
    /// Of the triangle, on the sides that the rays came from.
    pub(crate) geometric: Vec3x8,
    /// Interpolated.
    pub(crate) shading: Vec3x8,
    /// All bits where the ray met the inner side.
    pub(super) from_behind: f32x8,
}

impl TriangleNormals {
    /// Of a triangle of an instance.
    pub(crate) fn new(instance: &Instance, triangle: u32) -> Self {
        let vertices = instance.geometry.mesh.triangles[triangle as usize].map(|i| i as usize);
        let posed = &instance.geometry.posed;
        let positions = posed.positions();
        let [a, b, c] = vertices.map(|i| Vec3A::from(positions[i]));
        let m = &instance.normal_matrix;
        let flat = (*m * (b - a).cross_unfused(c - a)).normalize_or(Vec3A::Z);
        Self { flat, corners: vertices.map(|i| posed.normal(i)), to_world: [m.x_axis, m.y_axis, m.z_axis] }
    }

    /// Where rays of these unit directions met it, at weights of its second and third vertex.
    pub(crate) fn at(&self, directions: &Vec3x8, [u, v]: [f32x8; 2]) -> Normals8 {
        let flat = splat(self.flat);
        let [a, b, c] = self.corners.map(splat);
        let w = f32x8::ONE - u - v;
        let smooth: Vec3x8 = std::array::from_fn(|k| a[k] * w + b[k] * u + c[k] * v);
        let [mx, my, mz] = self.to_world.map(splat);
        let turned = std::array::from_fn(|k| mx[k] * smooth[0] + my[k] * smooth[1] + mz[k] * smooth[2]);
        Normals8::towards_viewer(&flat, turned, directions)
    }
}

impl Normals8 {
    /// From those of triangles, on either side, and interpolated ones of any length, where rays of these unit directions met
    /// them.
    pub(super) fn towards_viewer(flat: &Vec3x8, smooth: Vec3x8, directions: &Vec3x8) -> Self {
        let shading = normalize_or(smooth, flat);
        // As in `SurfaceInteraction::new`, which says why.
        let geometric = flipped(flat, dot(flat, &shading).simd_lt(f32x8::ZERO));
        let from_behind = dot(&geometric, directions).simd_gt(f32x8::ZERO);
        let (geometric, shading) = (flipped(&geometric, from_behind), flipped(&shading, from_behind));
        let facing = dot(&shading, directions);
        let leans = facing.simd_gt(f32x8::splat(-0.02));
        if !leans.any() {
            return Normals8 { geometric, shading, from_behind };
        }
        let back = facing + f32x8::splat(0.02);
        let bent = normalize_or(std::array::from_fn(|k| shading[k] - directions[k] * back), &geometric);
        let shading = std::array::from_fn(|k| leans.select(bent[k], shading[k]));
        Normals8 { geometric, shading, from_behind }
    }
}

/// The other way round in these lanes.
fn flipped(v: &Vec3x8, lanes: f32x8) -> Vec3x8 {
    let sign = lanes & f32x8::splat(-0.0);
    v.map(|axis| axis ^ sign)
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::{Geometry, Instance, SurfaceInteraction};
    use super::*;
    use crate::accel::{Hit, Ray};
    use crate::sampling::{hammersley, sphere_direction};
    use crate::vec3x8::{lane_of, side_by_side};
    use endless_scene::{Material, MeshBuilder, Surface};
    use endless_world::ClassTag;
    use glam::{Affine3A, Quat, Vec3};

    /// A slab in three places, one of them mirrored: smooth over its edges, one of its triangles none. And how many triangles it
    /// has.
    pub(in super::super) fn slabs() -> ([Instance; 3], u32) {
        let mut builder = MeshBuilder::new();
        let material = Material::new(Surface::Concrete, [0.4; 3], ClassTag::Static);
        builder.cuboid(Vec3::new(-1.0, -1.2, 0.95), Vec3::new(1.0, 1.0, 1.0), material);
        let mut mesh = builder.finish();
        // As long as interpolation leaves them.
        for (normal, position) in mesh.normals.iter_mut().zip(&mesh.positions) {
            *normal = (*normal + *position * 0.4).normalize();
        }
        mesh.triangles[0][2] = mesh.triangles[0][1];
        let triangles = mesh.triangles.len() as u32;
        let turn = Quat::from_rotation_x(0.3) * Quat::from_rotation_z(1.1);
        let places = [
            Affine3A::IDENTITY,
            Affine3A::from_scale_rotation_translation(Vec3::new(1.0, 2.0, 0.5), turn, Vec3::new(3.0, -4.0, 5.0)),
            Affine3A::from_scale_rotation_translation(Vec3::new(-1.0, 1.0, 1.0), turn, Vec3::ZERO),
        ];
        let geometry = Geometry::rigid(mesh);
        (places.map(|place| Instance::new(&geometry, place)), triangles)
    }

    /// Checks normals of eight hits by rays of these directions against those found one after the other.
    pub(in super::super) fn check(eight: &Normals8, instances: &[Instance], hits: &[Hit; 8], directions: &[Vec3A; 8]) {
        for (lane, (hit, &direction)) in hits.iter().zip(directions).enumerate() {
            let ray = Ray { origin: Vec3A::ZERO, direction, tmax: f32::MAX };
            let one = SurfaceInteraction::new(instances, &ray, hit);
            let bits = |v: Vec3A| v.to_array().map(f32::to_bits);
            assert_eq!(bits(lane_of(&eight.geometric, lane)), bits(one.geometric_normal));
            assert_eq!(bits(lane_of(&eight.shading, lane)), bits(one.normal));
        }
    }

    #[test]
    fn eight_are_those_of_one_after_another() {
        let (instances, triangles) = slabs();
        let count = 64;
        for (instance, triangle) in (0..3).flat_map(|i| (0..triangles).map(move |t| (i, t))) {
            for first in (0..count).step_by(8) {
                let directions: [Vec3A; 8] =
                    std::array::from_fn(|i| sphere_direction(hammersley(first + i as u32, count)));
                let hits = [0, 1, 2, 3, 4, 5, 6, 7].map(|i| {
                    let u = (first + i) as f32 / count as f32;
                    Hit { t: 1.0, instance, triangle, u, v: (1.0 - u) * 0.3 * (i % 4) as f32 }
                });
                let weights = [hits.map(|hit| hit.u), hits.map(|hit| hit.v)].map(f32x8::new);
                let normals = TriangleNormals::new(&instances[instance as usize], triangle);
                check(&normals.at(&side_by_side(directions), weights), &instances, &hits, &directions);
            }
        }
    }
}
