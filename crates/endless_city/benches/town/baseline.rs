//! The same town in the traversals that `obvhs` brings, to compare with.

use endless_world::math::UnfusedMatrix;
use std::time::Duration;

use endless_render::Ray;
use glam::{Affine3A, Vec3A};
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::{build_bvh2, build_bvh2_from_tris};
use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::builder::{build_cwbvh, build_cwbvh_from_tris};
use obvhs::ray::{Ray as ORay, RayHit};
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle;

use super::BenchTown;

/// What both kinds of `obvhs` tree can do; a leaf callback returns the distance or infinity.
pub(crate) trait Walk: Sync + Sized {
    fn of_triangles(triangles: &[Triangle]) -> Self;
    fn of_boxes(boxes: &[Aabb]) -> Self;
    fn order(&self) -> &[u32];
    fn closest(&self, ray: ORay, hit: &mut RayHit, leaf: impl FnMut(&ORay, usize) -> f32);
    fn misses(&self, ray: ORay, leaf: impl FnMut(&ORay, usize) -> f32) -> bool;
}

macro_rules! walk {
    ($tree:ty, $triangles:ident, $boxes:ident) => {
        impl Walk for $tree {
            fn of_triangles(triangles: &[Triangle]) -> Self {
                $triangles(triangles, BvhBuildParams::medium_build(), &mut Duration::default())
            }
            fn of_boxes(boxes: &[Aabb]) -> Self {
                let params = BvhBuildParams { max_prims_per_leaf: 1, ..BvhBuildParams::medium_build() };
                $boxes(boxes, params, &mut Duration::default())
            }
            fn order(&self) -> &[u32] {
                &self.primitive_indices
            }
            #[inline(always)]
            fn closest(&self, ray: ORay, hit: &mut RayHit, leaf: impl FnMut(&ORay, usize) -> f32) {
                self.ray_traverse(ray, hit, leaf);
            }
            #[inline(always)]
            fn misses(&self, ray: ORay, leaf: impl FnMut(&ORay, usize) -> f32) -> bool {
                self.ray_traverse_miss(ray, leaf)
            }
        }
    };
}
walk!(CwBvh, build_cwbvh_from_tris, build_cwbvh);
walk!(Bvh2, build_bvh2_from_tris, build_bvh2);

pub(crate) struct Baseline<T> {
    meshes: Vec<(T, Vec<RtTriangle>)>,
    top: T,
    /// Mesh and `object_from_world`.
    instances: Vec<(usize, Option<Affine3A>)>,
}

impl<T: Walk> Baseline<T> {
    pub(crate) fn new(town: &BenchTown) -> Self {
        let meshes = town.meshes.iter().map(|mesh| {
            let corner = |i: u32| Vec3A::from(mesh.positions[i as usize]);
            let triangles: Vec<_> = mesh
                .triangles
                .iter()
                .map(|t| Triangle { v0: corner(t[0]), v1: corner(t[1]), v2: corner(t[2]) })
                .collect();
            let tree = T::of_triangles(&triangles);
            let sorted = tree.order().iter().map(|&i| RtTriangle::from(&triangles[i as usize])).collect();
            (tree, sorted)
        });
        let boxes: Vec<_> = (0..town.instances.len())
            .map(|i| town.accel.instance_bounds(i))
            .map(|(min, max)| Aabb::new(min, max))
            .collect();
        let instances = town
            .instances
            .iter()
            .map(|&(mesh, place)| (mesh, (place != Affine3A::IDENTITY).then(|| place.inverse_unfused())))
            .collect();
        Baseline { meshes: meshes.collect(), top: T::of_boxes(&boxes), instances }
    }

    #[inline(always)]
    fn enter(&self, k: usize, ray: &ORay) -> (&(T, Vec<RtTriangle>), ORay) {
        let (mesh, object_from_world) = &self.instances[self.top.order()[k] as usize];
        let local = match object_from_world {
            None => *ray,
            Some(m) => {
                ORay::new(m.transform_point3a(ray.origin), m.transform_vector3a(ray.direction), ray.tmin, ray.tmax)
            }
        };
        (&self.meshes[*mesh], local)
    }

    /// Distance to the first hit.
    pub(crate) fn closest(&self, ray: &Ray) -> Option<f32> {
        let mut hit = RayHit::none();
        self.top.closest(ORay::new(ray.origin, ray.direction, 0.0, ray.tmax), &mut hit, |ray, k| {
            let ((tree, triangles), local) = self.enter(k, ray);
            let mut hit = RayHit::none();
            tree.closest(local, &mut hit, |ray, i| triangles[i].intersect(ray));
            if hit.t < ray.tmax { hit.t } else { f32::INFINITY }
        });
        hit.t.is_finite().then_some(hit.t).filter(|&t| t < 1e29)
    }

    pub(crate) fn occluded(&self, ray: &Ray) -> bool {
        !self.top.misses(ORay::new(ray.origin, ray.direction, 0.0, ray.tmax), |ray, k| {
            let ((tree, triangles), local) = self.enter(k, ray);
            if tree.misses(local, |ray, i| triangles[i].intersect(ray)) { f32::INFINITY } else { 0.0 }
        })
    }
}
