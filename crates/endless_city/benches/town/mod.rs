//! A built-in town, as one of its cameras sees it.

use endless_world::math::UnfusedVec3A;
use std::collections::BTreeMap;
use std::f32::consts::TAU;
use std::sync::Arc;

use endless_asset::Catalogue;
use endless_render::{Blas, Ray, Tlas};
use endless_scene::Mesh;
use endless_town::PlacedObject;
use endless_world::{Stream, math};
use glam::{Affine3A, Vec3A};

/// Eight rays and the mask of those to trace.
pub(crate) type Packet = ([Ray; 8], u8);

/// Meshes, placed; and the structure over them.
pub(crate) struct BenchTown {
    pub(crate) meshes: Vec<Arc<Mesh>>,
    pub(crate) instances: Vec<(usize, Affine3A)>,
    pub(crate) accel: Tlas,
    pub(crate) blas: Vec<Arc<Blas>>,
    /// Where a camera hangs, and where it looks.
    pub(crate) eye: Vec3A,
    pub(crate) forward: Vec3A,
}

pub(crate) const WIDTH: usize = 1280;
pub(crate) const HEIGHT: usize = 720;

impl BenchTown {
    /// Buildings, ground, plants and furniture of a town; its first camera looks.
    ///
    /// # Panics
    /// If there is no such town.
    pub(crate) fn new(name: &str) -> Self {
        let catalogue = Catalogue::builtin();
        let town = endless_town::load(name, &catalogue).expect("a town's name");
        let mut meshes = town.meshes;
        let mut props = BTreeMap::new();
        let mut instances = Vec::new();
        for placement in &town.placements {
            let mesh = match placement.object {
                PlacedObject::TownMesh(i) => i as usize,
                PlacedObject::Prop(prop, variant) => *props.entry(placement.object).or_insert_with(|| {
                    meshes.push(catalogue.prop(prop, variant).into());
                    meshes.len() - 1
                }),
            };
            if !meshes[mesh].triangles.is_empty() {
                instances.push((mesh, placement.world_from_object));
            }
        }
        let blas: Vec<_> = meshes.iter().map(|m| Arc::new(Blas::build(&m.positions, &m.triangles))).collect();
        let accel = Tlas::build(placed(&blas, &instances));
        let site = &town.cameras[0];
        let camera = endless_world::PinholeCamera::new(
            site,
            endless_world::ImageSize { width: WIDTH as u32, height: HEIGHT as u32 },
        );
        let eye = Vec3A::from_array(site.position);
        BenchTown { meshes, instances, accel, blas, eye, forward: Vec3A::from(camera.world_from_camera.z_axis) }
    }

    /// The surface's normal on the ray's side.
    fn normal(&self, hit: &endless_render::Hit, direction: Vec3A) -> Vec3A {
        let (mesh, place) = &self.instances[hit.instance as usize];
        let mesh = &self.meshes[*mesh];
        let corners = mesh.triangles[hit.triangle as usize]
            .map(|i| place.transform_point3a(Vec3A::from(mesh.positions[i as usize])));
        let normal = (corners[1] - corners[0]).cross_unfused(corners[2] - corners[0]).normalize_or(Vec3A::Z);
        if normal.dot(direction) > 0.0 { -normal } else { normal }
    }

    /// Rays of a frame, eight at a time with the active ones' mask: primary and sun by 4 by 2 pixels; diffuse as a bake
    /// sends them, the same pattern from every fourth pixel of a row; and scattered, from 4 by 2 pixels, each its own way.
    pub(crate) fn rays(&self) -> [Vec<Packet>; 4] {
        let mut stream = Stream::named(5, "rays", &[]);
        let sun = Vec3A::new(0.45, 0.3, 0.6).normalize();
        let none = Ray { origin: self.eye, direction: self.forward, tmax: 0.0 };
        let seen: Vec<Option<Seen>> = (0..WIDTH * HEIGHT).map(|i| self.seen(i % WIDTH, i / WIDTH)).collect();
        let packet = |pixels: [usize; 8], ray: &mut dyn FnMut(usize, &Seen) -> Option<Ray>| {
            let mut active = 0u8;
            let rays = std::array::from_fn(|lane| {
                let found = seen[pixels[lane]].as_ref().and_then(|seen| ray(pixels[lane], seen));
                active |= u8::from(found.is_some()) << lane;
                found.unwrap_or(none)
            });
            (rays, active)
        };
        let mut sets = [vec![], vec![], vec![], vec![]];
        for tile in 0..WIDTH / 8 * (HEIGHT / 8) {
            for part in 0..8 {
                let (left, top) = (tile % (WIDTH / 8) * 8 + part % 2 * 4, tile / (WIDTH / 8) * 8 + part / 2 * 2);
                let pixels: [usize; 8] = std::array::from_fn(|lane| (top + lane / 4) * WIDTH + left + lane % 4);
                sets[0].push((pixels.map(|i| self.primary(i % WIDTH, i / WIDTH)), 255));
                sets[1].push(packet(pixels, &mut |_, seen| {
                    let direction = around(sun, (0.005 * stream.f32().sqrt(), 1.0), stream.f32());
                    (seen.normal.dot(sun) > 0.0).then_some(seen.ray(direction))
                }));
                sets[3].push(packet(pixels, &mut |_, seen| Some(seen.scatter(stream.f32(), stream.f32()))));
            }
        }
        for first in (0..WIDTH * HEIGHT).filter(|i| i % WIDTH % 32 < 4) {
            let pixels = std::array::from_fn(|lane| first + 4 * lane);
            let pattern = (first / WIDTH % 4 * 4 + first % 4) as u32;
            let (u, v) = (pattern as f32 / 16.0, pattern.reverse_bits() as f32 / u32::MAX as f32);
            sets[2].push(packet(pixels, &mut |_, seen| Some(seen.scatter(u, v))));
        }
        sets
    }

    fn primary(&self, x: usize, y: usize) -> Ray {
        let right = self.forward.cross_unfused(Vec3A::Z).normalize();
        let up = right.cross_unfused(self.forward);
        let (x, y, w, h) = (x as f32 + 0.5, y as f32 + 0.5, WIDTH as f32, HEIGHT as f32);
        let direction = self.forward + right * (1.4 * (x / w - 0.5)) - up * (1.4 * (y - h * 0.5) / w);
        Ray { origin: self.eye, direction: direction.normalize(), tmax: f32::INFINITY }
    }

    fn seen(&self, x: usize, y: usize) -> Option<Seen> {
        let ray = self.primary(x, y);
        let hit = self.accel.closest(&ray)?;
        let normal = self.normal(&hit, ray.direction);
        Some(Seen { origin: ray.origin + ray.direction * hit.t + normal * 2e-3, normal })
    }
}

/// What a pixel sees.
struct Seen {
    /// Just above the surface.
    origin: Vec3A,
    normal: Vec3A,
}

impl Seen {
    fn ray(&self, direction: Vec3A) -> Ray {
        Ray { origin: self.origin, direction, tmax: f32::INFINITY }
    }

    /// A ray of the cosine lobe.
    fn scatter(&self, u: f32, v: f32) -> Ray {
        self.ray(around(self.normal, (u.sqrt(), (1.0 - u).sqrt()), v))
    }
}

/// So far aside from an axis and along it, at a share of a turn.
fn around(axis: Vec3A, (aside, along): (f32, f32), turn: f32) -> Vec3A {
    let (a, b) = axis.any_orthonormal_pair();
    let (sin, cos) = math::sin_cos(turn * TAU);
    axis * along + a * (aside * cos) + b * (aside * sin)
}

/// The list an `Tlas` is built from.
pub(crate) fn placed(blas: &[Arc<Blas>], instances: &[(usize, Affine3A)]) -> Vec<(Arc<Blas>, Affine3A)> {
    instances.iter().map(|&(m, place)| (Arc::clone(&blas[m]), place)).collect()
}
