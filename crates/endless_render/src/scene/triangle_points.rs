//! Hits of up to eight rays on one triangle: the same bits as those of [`SurfaceInteraction::new`] one after the other.

use super::{Instance, Normals8, SurfaceInteraction, TriangleNormals};
use crate::vec3x8::{Vec3x8, lane_of};
use glam::{Vec2, Vec3A};
use wide::f32x8;

/// Rays from one point that met one triangle.
pub(crate) struct TriangleHits {
    /// Of the instance's mesh.
    pub(crate) triangle: u32,
    /// Where all rays began.
    pub(crate) origin: Vec3A,
    /// Unit directions.
    pub(crate) directions: Vec3x8,
    pub(crate) distances: f32x8,
    /// Weights of the triangle's second and third vertex.
    pub(crate) weights: [f32x8; 2],
}

impl TriangleHits {
    /// Gives each of some lanes its point.
    pub(crate) fn points<'a>(
        &self,
        instance: &'a Instance,
        some: impl Iterator<Item = usize>,
        mut give: impl FnMut(usize, SurfaceInteraction<'a>),
    ) {
        let Self { triangle, origin, directions, distances, weights: [u, v] } = self;
        let Normals8 { geometric, shading, from_behind } =
            TriangleNormals::new(instance, *triangle).at(directions, [*u, *v]);
        let from_behind = from_behind.to_bitmask();
        let (_, material) = instance.material_of(*triangle);
        let geometry = &instance.geometry;
        let mesh = &*geometry.mesh;
        let vertices = mesh.triangles[*triangle as usize].map(|i| i as usize);
        let w = f32x8::ONE - *u - *v;
        let mixed = |[a, b, c]: [f32; 3]| f32x8::splat(a) * w + f32x8::splat(b) * *u + f32x8::splat(c) * *v;
        let positions = geometry.posed.positions();
        let object: Vec3x8 = [0, 1, 2].map(|k| mixed(vertices.map(|i| positions[i][k])));
        let uv = [0, 1].map(|k| mixed(vertices.map(|i| mesh.uvs[i][k])));
        let open = geometry.ambient_occlusion.as_ref().map_or(f32x8::ONE, |open| mixed(vertices.map(|i| open.at(i))));
        let places: Vec3x8 = std::array::from_fn(|k| f32x8::splat(origin[k]) + directions[k] * *distances);
        for lane in some {
            let point = SurfaceInteraction {
                instance,
                triangle: *triangle,
                material,
                position: lane_of(&places, lane),
                geometric_normal: lane_of(&geometric, lane),
                normal: lane_of(&shading, lane),
                object_position: lane_of(&object, lane),
                uv: Vec2::new(uv[0].as_array()[lane], uv[1].as_array()[lane]),
                distance: distances.as_array()[lane],
                direction: lane_of(directions, lane),
                ambient_occlusion: open.as_array()[lane],
                from_behind: from_behind >> lane & 1 == 1,
            };
            give(lane, point);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Geometry;
    use super::*;
    use crate::accel::{Hit, Ray};
    use crate::sampling::{hammersley, sphere_direction};
    use crate::vec3x8::side_by_side;
    use endless_scene::{Material, MeshBuilder, Surface};
    use endless_world::ClassTag;
    use glam::{Affine3A, Quat, Vec3};

    fn bits(point: &SurfaceInteraction<'_>) -> Vec<u32> {
        let vectors = [point.position, point.geometric_normal, point.normal, point.object_position, point.direction];
        let numbers = [point.uv.x, point.uv.y, point.distance, point.ambient_occlusion];
        vectors.iter().flat_map(Vec3A::to_array).chain(numbers).map(f32::to_bits).collect()
    }

    #[test]
    fn eight_are_those_of_one_after_another() {
        let mut builder = MeshBuilder::new();
        builder.cuboid(Vec3::splat(-1.0), Vec3::ONE, Material::new(Surface::Concrete, [0.4; 3], ClassTag::Static));
        let mut mesh = builder.finish();
        for (i, uv) in mesh.uvs.iter_mut().enumerate() {
            *uv = Vec2::new(i as f32 * 0.7, 3.0 - i as f32 * 0.21);
        }
        let triangles = mesh.triangles.len() as u32;
        let place = Affine3A::from_rotation_translation(Quat::from_rotation_x(0.7), Vec3::new(13.0, -4.0, 5.0));
        let instances = [
            Instance::new(&Geometry::rigid(mesh.clone()), place),
            Instance::new(&Geometry::rigid(mesh).with_ambient_occlusion(Vec3::splat(-1.0), Vec3::ONE), place),
        ];
        let origin = Vec3A::new(10.0, 2.0, 4.0);
        for (instance, triangle) in (0..2).flat_map(|i| (0..triangles).map(move |t| (i, t))) {
            let directions: [Vec3A; 8] = std::array::from_fn(|i| sphere_direction(hammersley(i as u32, 8)));
            let hits: [Hit; 8] = std::array::from_fn(|i| {
                let (u, t) = (i as f32 / 8.0, 3.0 + 0.37 * i as f32);
                Hit { t, instance, triangle, u, v: (1.0 - u) * 0.3 * (i % 3) as f32 }
            });
            let eight = TriangleHits {
                triangle,
                origin,
                directions: side_by_side(directions),
                distances: f32x8::new(hits.map(|hit| hit.t)),
                weights: [hits.map(|hit| hit.u), hits.map(|hit| hit.v)].map(f32x8::new),
            };
            let mut given = 0;
            eight.points(&instances[instance as usize], [0, 2, 3, 5, 7].into_iter(), |lane, point| {
                let ray = Ray { origin, direction: directions[lane], tmax: f32::MAX };
                let one = SurfaceInteraction::new(&instances, &ray, &hits[lane]);
                assert_eq!(bits(&point), bits(&one));
                assert_eq!((point.from_behind, point.triangle), (one.from_behind, one.triangle));
                assert!(std::ptr::eq(point.material, one.material) && std::ptr::eq(point.instance, one.instance));
                given += 1;
            });
            assert_eq!(given, 5);
        }
    }
}
