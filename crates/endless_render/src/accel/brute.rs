//! The definition of a hit by brute force: every triangle of every instance, without a tree.

use endless_world::math::UnfusedMatrix;
use std::sync::Arc;

use glam::{Affine3A, Vec3};

use super::ray::{Hit, LocalRay, Ray, RayTransform};
use super::triangle::intersect_triangle;
use super::{Blas, Tlas};

/// A scene both as plain triangles and as an `Tlas`.
#[derive(Debug)]
pub(super) struct BruteForceScene {
    pub(super) meshes: Vec<(Vec<Vec3>, Vec<[u32; 3]>)>,
    pub(super) instances: Vec<(usize, Affine3A)>,
    pub(super) accel: Tlas,
}

impl BruteForceScene {
    pub(super) fn new(meshes: Vec<(Vec<Vec3>, Vec<[u32; 3]>)>, instances: Vec<(usize, Affine3A)>) -> Self {
        let blas: Vec<_> = meshes.iter().map(|(p, t)| Arc::new(Blas::build(p, t))).collect();
        let accel = Tlas::build(instances.iter().map(|&(m, place)| (Arc::clone(&blas[m]), place)).collect());
        BruteForceScene { meshes, instances, accel }
    }

    /// All hits of a ray. With `boxes` a hit must also enter the boxes of its instance and triangle, as the
    /// structure requires; without, the triangle test alone decides.
    fn hits(&self, ray: &Ray, boxes: bool) -> Vec<Hit> {
        let mut hits = Vec::new();
        let world = LocalRay::new(ray.origin, ray.direction);
        for (instance, (mesh, place)) in self.instances.iter().enumerate() {
            let identity = *place == Affine3A::IDENTITY;
            let inverse = place.inverse_unfused();
            let transform = RayTransform { linear: inverse.matrix3, translation: inverse.translation };
            let local = if identity {
                world
            } else {
                LocalRay::new(transform.point(ray.origin), transform.vector(ray.direction))
            };
            let (min, max) = self.accel.instance_bounds(instance);
            let Some(tmin) = world.enter(min.to_array(), max.to_array()).or((!boxes).then_some(0.0)) else { continue };
            let (positions, triangles) = &self.meshes[*mesh];
            for (index, triangle) in triangles.iter().enumerate() {
                let corners = triangle.map(|i| positions[i as usize]);
                let Some((t, u, v)) = intersect_triangle(&local, corners) else { continue };
                let (min, max) =
                    (corners[0].min(corners[1]).min(corners[2]), corners[0].max(corners[1]).max(corners[2]));
                let Some(tbox) = local.enter(min.to_array(), max.to_array()).or((!boxes).then_some(0.0)) else {
                    continue;
                };
                let t = if boxes { t.max(tbox).max(tmin) } else { t };
                if t <= ray.tmax {
                    hits.push(Hit { t, instance: instance as u32, triangle: index as u32, u, v });
                }
            }
        }
        hits
    }

    /// The closest hit as the structure must find it.
    pub(super) fn closest(&self, ray: &Ray) -> Option<Hit> {
        nearest(self.hits(ray, true))
    }

    /// Where a ray meets the triangle of a hit.
    pub(super) fn hit_on(&self, ray: &Ray, hit: &Hit) -> Option<Hit> {
        let (positions, triangles) = &self.meshes[self.instances[hit.instance as usize].0];
        let corners = triangles[hit.triangle as usize].map(|i| positions[i as usize]);
        self.accel.hit_on(ray, hit.instance, hit.triangle, corners)
    }

    /// The closest hit by the triangle test alone.
    pub(super) fn closest_without_boxes(&self, ray: &Ray) -> Option<Hit> {
        nearest(self.hits(ray, false))
    }
}

fn nearest(hits: Vec<Hit>) -> Option<Hit> {
    hits.into_iter().min_by(|a, b| (a.t.total_cmp(&b.t)).then((a.instance, a.triangle).cmp(&(b.instance, b.triangle))))
}
