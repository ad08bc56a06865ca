//! A town made up for measuring: ground, houses with windows, leafy trees, round vehicles; a street camera.

use std::f32::consts::{PI, TAU};
use std::sync::Arc;

use endless_render::{Accel, Blas, Ray};
use endless_world::{Stream, math};
use glam::{Affine3A, Quat, Vec3, Vec3A, vec3};

/// Eight rays and the mask of those to trace.
pub(crate) type Packet = ([Ray; 8], u8);

/// Plain triangles of one mesh.
#[derive(Default)]
pub(crate) struct Mesh {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl Mesh {
    fn quad(&mut self, corner: Vec3, u: Vec3, v: Vec3) {
        let a = self.positions.len() as u32;
        self.positions.extend([corner, corner + u, corner + v, corner + u + v]);
        self.triangles.extend([[a, a + 1, a + 2], [a + 1, a + 3, a + 2]]);
    }

    fn cuboid(&mut self, low: Vec3, size: Vec3) {
        let (x, y, z) = (Vec3::X * size.x, Vec3::Y * size.y, Vec3::Z * size.z);
        for (corner, u, v) in [(low, x, y), (low + z, x, y), (low, x, z), (low + y, x, z), (low, y, z), (low + x, y, z)]
        {
            self.quad(corner, u, v);
        }
    }
}

/// Meshes, placed; and the structure over them.
pub(crate) struct Town {
    pub(crate) meshes: Vec<Mesh>,
    pub(crate) instances: Vec<(usize, Affine3A)>,
    pub(crate) accel: Accel,
    pub(crate) blas: Vec<Arc<Blas>>,
    /// Where a camera hangs, and where it looks.
    pub(crate) eye: Vec3A,
    pub(crate) forward: Vec3A,
}

/// Half the side of the town, metres.
const HALF: f32 = 240.0;
const BLOCK: f32 = 40.0;
pub(crate) const WIDTH: usize = 1280;
pub(crate) const HEIGHT: usize = 720;

impl Town {
    pub(crate) fn new() -> Self {
        let mut stream = Stream::named(3, "town", &[]);
        let mut meshes = vec![ground()];
        let mut instances = vec![];
        let blocks = (2.0 * HALF / BLOCK) as i32;
        for strip in 0..blocks {
            meshes.push(houses(strip as f32 * BLOCK - HALF, blocks, &mut stream));
        }
        instances.extend((0..meshes.len()).map(|m| (m, Affine3A::IDENTITY)));
        for kind in 0..3 {
            meshes.push(tree(&mut Stream::named(kind, "tree", &[])));
        }
        meshes.push(sphere(70));
        let first_tree = meshes.len() - 4;
        for _ in 0..2500 {
            let along = stream.range_f32(-HALF, HALF);
            let street =
                (stream.range_f32(-HALF, HALF) / BLOCK).round() * BLOCK + if stream.chance(0.5) { 5.5 } else { -5.5 };
            let place = if stream.chance(0.5) { vec3(along, street, 0.0) } else { vec3(street, along, 0.0) };
            let turn = Quat::from_rotation_z(stream.range_f32(0.0, TAU));
            let scale = Vec3::splat(stream.range_f32(0.7, 1.3));
            let tree = first_tree + stream.below(3);
            instances.push((tree, Affine3A::from_scale_rotation_translation(scale, turn, place)));
        }
        for _ in 0..80 {
            let along = stream.range_f32(-HALF, HALF);
            let street = (stream.range_f32(-90.0, 90.0) / BLOCK).round() * BLOCK + 2.0;
            let turn = Quat::from_rotation_z(stream.range_f32(0.0, TAU));
            let place = vec3(along, street, 0.8);
            instances
                .push((meshes.len() - 1, Affine3A::from_scale_rotation_translation(vec3(2.2, 0.9, 0.7), turn, place)));
        }
        let blas: Vec<_> = meshes.iter().map(|m| Arc::new(Blas::build(&m.positions, &m.triangles))).collect();
        let accel = Accel::build(placed(&blas, &instances));
        let (eye, forward) = (Vec3A::new(-120.0, 1.0, 8.0), Vec3A::new(1.0, 0.12, -0.28).normalize());
        Town { meshes, instances, accel, blas, eye, forward }
    }

    /// The surface's normal on the ray's side.
    fn normal(&self, hit: &endless_render::Hit, direction: Vec3A) -> Vec3A {
        let (mesh, place) = &self.instances[hit.instance as usize];
        let mesh = &self.meshes[*mesh];
        let corners = mesh.triangles[hit.triangle as usize]
            .map(|i| place.transform_point3a(Vec3A::from(mesh.positions[i as usize])));
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or(Vec3A::Z);
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
        let right = self.forward.cross(Vec3A::Z).normalize();
        let up = right.cross(self.forward);
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

/// The list an `Accel` is built from.
pub(crate) fn placed(blas: &[Arc<Blas>], instances: &[(usize, Affine3A)]) -> Vec<(Arc<Blas>, Affine3A)> {
    instances.iter().map(|&(m, place)| (Arc::clone(&blas[m]), place)).collect()
}

fn ground() -> Mesh {
    let (mut mesh, n) = (Mesh::default(), 240);
    let step = 2.0 * HALF / n as f32;
    let height = |x: i32, y: i32| 0.05 * math::sin(x as f32 * 0.7) * math::cos(y as f32 * 0.9);
    for y in 0..=n {
        mesh.positions.extend((0..=n).map(|x| vec3(x as f32 * step - HALF, y as f32 * step - HALF, height(x, y))));
    }
    let row = n as u32 + 1;
    for i in 0..(n * n) as u32 {
        let a = i / n as u32 * row + i % n as u32;
        mesh.triangles.extend([[a, a + 1, a + row], [a + 1, a + row + 1, a + row]]);
    }
    mesh
}

/// One row of blocks of houses; each window a frame and a pane set back.
fn houses(x: f32, blocks: i32, stream: &mut Stream) -> Mesh {
    let mut mesh = Mesh::default();
    for block in 0..blocks {
        for quarter in 0..4 {
            let low = vec3(
                x + 8.0 + 13.0 * (quarter % 2) as f32,
                block as f32 * BLOCK - HALF + 8.0 + 13.0 * (quarter / 2) as f32,
                0.0,
            );
            let floors = 2 + stream.below(9);
            let size = vec3(11.0, 11.0, floors as f32 * 3.2);
            mesh.cuboid(low, size);
            for floor in 0..floors {
                for window in 0..5 {
                    let (a, z) = (1.0 + 2.0 * window as f32, floor as f32 * 3.2 + 1.0);
                    for side in [-0.08, size.y] {
                        mesh.cuboid(low + vec3(a, side, z), vec3(1.2, 0.08, 1.5));
                        mesh.quad(low + vec3(a + 0.1, side - 0.02, z + 0.1), Vec3::X, Vec3::Z * 1.3);
                    }
                    for side in [-0.08, size.x] {
                        mesh.cuboid(low + vec3(side, a, z), vec3(0.08, 1.2, 1.5));
                        mesh.quad(low + vec3(side - 0.02, a + 0.1, z + 0.1), Vec3::Y, Vec3::Z * 1.3);
                    }
                }
            }
        }
    }
    mesh
}

/// A trunk and 20,000 leaves of two triangles.
fn tree(stream: &mut Stream) -> Mesh {
    let mut mesh = Mesh::default();
    mesh.cuboid(vec3(-0.15, -0.15, 0.0), vec3(0.3, 0.3, 3.0));
    let mut vector = || vec3(stream.range_f32(-1.0, 1.0), stream.range_f32(-1.0, 1.0), stream.range_f32(-1.0, 1.0));
    for _ in 0..20_000 {
        let mut at = vector();
        while at.length_squared() > 1.0 || at.length_squared() < 0.1 {
            at = vector();
        }
        mesh.quad(vec3(0.0, 0.0, 4.5) + at * vec3(2.2, 2.2, 2.6), vector() * 0.06, vector() * 0.06);
    }
    mesh
}

fn sphere(n: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for i in 0..=n {
        for j in 0..n {
            let (theta, phi) = (PI * i as f32 / n as f32, TAU * j as f32 / n as f32);
            let ring = math::sin(theta);
            mesh.positions.push(vec3(ring * math::cos(phi), ring * math::sin(phi), math::cos(theta)));
        }
    }
    for i in 0..n {
        for j in 0..n {
            let (a, b) = (i * n + j, i * n + (j + 1) % n);
            mesh.triangles.extend([[a, b, a + n], [b, b + n, a + n]]);
        }
    }
    mesh
}
