//! The normals of eight hits on a triangle each: the same bits as those of
//! [`SurfaceInteraction`](super::SurfaceInteraction)s, of which nothing else is needed where rays end between surfaces.

use super::triangle_normals::normalize_or;
use super::{Instance, Normals8};
use crate::accel::Hit;
use crate::vec3x8::{Vec3x8, side_by_side};
use glam::Vec3A;
use wide::f32x8;

/// Of eight hits by rays of these unit directions.
pub(crate) fn normals_of_hits(instances: &[Instance], hits: &[Hit; 8], directions: &Vec3x8) -> Normals8 {
    let mut vectors = [[Vec3A::ZERO; 8]; 9];
    for (lane, hit) in hits.iter().enumerate() {
        let instance = &instances[hit.instance as usize];
        let vertices = instance.geometry.mesh.triangles[hit.triangle as usize].map(|i| i as usize);
        let posed = &instance.geometry.posed;
        let positions = posed.positions();
        let m = &instance.normal_matrix;
        let [a, b, c] = vertices.map(|i| Vec3A::from(positions[i]));
        let [na, nb, nc] = vertices.map(|i| posed.normal(i));
        for (all, own) in vectors.iter_mut().zip([a, b, c, na, nb, nc, m.x_axis, m.y_axis, m.z_axis]) {
            all[lane] = own;
        }
    }
    let [a, b, c, na, nb, nc, mx, my, mz] = vectors.map(side_by_side);
    let to_world = |v: &Vec3x8| -> Vec3x8 { std::array::from_fn(|k| mx[k] * v[0] + my[k] * v[1] + mz[k] * v[2]) };
    let flat = to_world(&cross(&minus(&b, &a), &minus(&c, &a)));
    let (u, v) = (f32x8::new(hits.map(|hit| hit.u)), f32x8::new(hits.map(|hit| hit.v)));
    let w = f32x8::ONE - u - v;
    let smooth = std::array::from_fn(|k| na[k] * w + nb[k] * u + nc[k] * v);
    let up = [f32x8::ZERO, f32x8::ZERO, f32x8::ONE];
    Normals8::towards_viewer(&normalize_or(flat, &up), to_world(&smooth), directions)
}

fn minus(a: &Vec3x8, b: &Vec3x8) -> Vec3x8 {
    std::array::from_fn(|k| a[k] - b[k])
}

fn cross([ax, ay, az]: &Vec3x8, [bx, by, bz]: &Vec3x8) -> Vec3x8 {
    [*ay * *bz - *az * *by, *az * *bx - *ax * *bz, *ax * *by - *ay * *bx]
}

#[cfg(test)]
mod tests {
    use super::super::{Geometry, SurfaceInteraction};
    use super::*;
    use crate::accel::Ray;
    use crate::sampling::{hammersley, sphere_direction};
    use crate::vec3x8::lane_of;
    use endless_scene::{Material, MeshBuilder, Surface};
    use endless_world::ClassTag;
    use glam::{Affine3A, Quat, Vec3};

    #[test]
    fn eight_are_those_of_one_after_another() {
        let mut builder = MeshBuilder::new();
        let material = Material::new(Surface::Concrete, [0.4; 3], ClassTag::Static);
        builder.cuboid(Vec3::new(-1.0, -1.2, 0.95), Vec3::new(1.0, 1.0, 1.0), material);
        let mut mesh = builder.finish();
        // Smooth over the edges, and as long as interpolation leaves them; one triangle is none.
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
        let instances = places.map(|place| Instance::new(&geometry, place));
        let count = 8_000;
        let hit = |i: u32| {
            let u = (i % 64) as f32 / 64.0;
            Hit { t: 1.0, instance: i % 3, triangle: i / 3 % triangles, u, v: (1.0 - u) * 0.3 * (i % 4) as f32 }
        };
        for first in (0..count).step_by(8) {
            let hits = std::array::from_fn(|lane| hit(first + lane as u32));
            let directions = std::array::from_fn(|lane| sphere_direction(hammersley(first + lane as u32, count)));
            let eight = normals_of_hits(&instances, &hits, &side_by_side(directions));
            for (lane, (hit, direction)) in hits.iter().zip(directions).enumerate() {
                let ray = Ray { origin: Vec3A::ZERO, direction, tmax: f32::MAX };
                let one = SurfaceInteraction::new(&instances, &ray, hit);
                let bits = |v: Vec3A| v.to_array().map(f32::to_bits);
                assert_eq!(bits(lane_of(&eight.geometric, lane)), bits(one.geometric_normal));
                assert_eq!(bits(lane_of(&eight.shading, lane)), bits(one.normal));
            }
        }
    }
}
