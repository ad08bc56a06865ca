//! The normals of eight hits on a triangle each: the same bits as those of
//! [`SurfaceInteraction`](super::SurfaceInteraction)s, of which nothing else is needed where rays end between surfaces.

use super::{Instance, Normals8};
use crate::accel::Hit;
use crate::vec3x8::{Vec3x8, normalize_or, side_by_side};
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
    use super::super::triangle_normals::tests::{check, slabs};
    use super::*;
    use crate::sampling::{hammersley, sphere_direction};

    #[test]
    fn eight_are_those_of_one_after_another() {
        let (instances, triangles) = slabs();
        let count = 8_000;
        let hit = |i: u32| {
            let u = (i % 64) as f32 / 64.0;
            Hit { t: 1.0, instance: i % 3, triangle: i / 3 % triangles, u, v: (1.0 - u) * 0.3 * (i % 4) as f32 }
        };
        for first in (0..count).step_by(8) {
            let hits = std::array::from_fn(|lane| hit(first + lane as u32));
            let directions = std::array::from_fn(|lane| sphere_direction(hammersley(first + lane as u32, count)));
            check(&normals_of_hits(&instances, &hits, &side_by_side(directions)), &instances, &hits, &directions);
        }
    }
}
