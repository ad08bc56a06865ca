//! A town from above, as a plan: surfaces shaded by a light from the north-west, trees as discs, lanes, sidewalks,
//! signals, lamps and the cameras' footprints as lines and dots.

use crate::{PlacedObject, Town};
use endless_asset::{Catalogue, Prop};
use endless_scene::Mesh;
use endless_world::math;
use glam::{Affine3A, Vec2, Vec3};

const LANE: [u8; 3] = [90, 200, 255];
const CONNECTOR: [u8; 3] = [230, 160, 40];
const WALK: [u8; 3] = [120, 255, 120];
const CROSSING: [u8; 3] = [255, 255, 255];
const SIGNAL: [u8; 3] = [255, 40, 40];
const LAMP: [u8; 3] = [255, 240, 120];
const CAMERA: [u8; 3] = [255, 0, 255];
/// How far a camera's footprint is drawn, metres.
const SIGHT_M: f32 = 50.0;

/// The whole town on `pixels` by `pixels`, row by row from the north-west.
pub fn top_view(town: &Town, catalogue: &Catalogue, pixels: u32) -> Vec<[u8; 3]> {
    let (middle, metres) = whole_town(town);
    top_view_of(town, catalogue, pixels, middle, metres)
}

/// Middle and side of the square, metres, that [`top_view`] shows.
pub fn whole_town(town: &Town) -> (Vec2, f32) {
    let points = town.network.lanes.iter().flat_map(|l| l.centerline.points()).map(|p| p.as_vec3().truncate());
    let (low, high) = points.fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)));
    let (low, high) = if low.x <= high.x { (low, high) } else { (Vec2::ZERO, Vec2::ZERO) };
    ((low + high) / 2.0, (high - low).max_element() + 80.0)
}

/// The square of `metres` around a place.
pub fn top_view_of(town: &Town, catalogue: &Catalogue, pixels: u32, middle: Vec2, metres: f32) -> Vec<[u8; 3]> {
    let width = pixels as usize;
    let n = width * width;
    let scale = pixels as f32 / metres;
    let mut canvas = TopViewCanvas { width, scale, middle, pixels: vec![[24, 26, 30]; n], heights: vec![f32::MIN; n] };
    canvas.surfaces(town, catalogue);
    canvas.lines(town);
    canvas.dots(town);
    canvas.pixels
}

struct TopViewCanvas {
    width: usize,
    scale: f32,
    middle: Vec2,
    pixels: Vec<[u8; 3]>,
    heights: Vec<f32>,
}

impl TopViewCanvas {
    fn pixel(&self, p: Vec2) -> Vec2 {
        let half = self.width as f32 / 2.0;
        let q = p - self.middle;
        Vec2::new(half + q.x * self.scale, half - q.y * self.scale)
    }

    fn set(&mut self, x: f32, y: f32, color: [u8; 3]) {
        if x >= 0.0 && y >= 0.0 && (x as usize) < self.width && (y as usize) < self.width {
            self.pixels[y as usize * self.width + x as usize] = color;
        }
    }

    fn line(&mut self, a: Vec2, b: Vec2, color: [u8; 3]) {
        let (a, b) = (self.pixel(a), self.pixel(b));
        let steps = (b - a).length().ceil().max(1.0) as usize;
        for i in 0..=steps {
            let p = a.lerp(b, i as f32 / steps as f32);
            self.set(p.x, p.y, color);
        }
    }

    fn disc(&mut self, centre: Vec2, radius: f32, color: [u8; 3]) {
        let c = self.pixel(centre);
        let r = (radius * self.scale).max(1.0);
        let reach = r.ceil() as i32;
        for dy in -reach..=reach {
            for dx in -reach..=reach {
                if ((dx * dx + dy * dy) as f32) <= r * r {
                    self.set(c.x + dx as f32, c.y + dy as f32, color);
                }
            }
        }
    }

    /// Rasterises a mesh; the highest face of each pixel stays.
    fn mesh(&mut self, mesh: &Mesh, world_from_mesh: Affine3A) {
        for (t, &m) in mesh.triangles.iter().zip(&mesh.triangle_materials) {
            let corners = t.map(|i| world_from_mesh.transform_point3(mesh.positions[i as usize]));
            let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or_zero();
            if normal.z <= 0.0 {
                continue;
            }
            let light = 0.35 + 0.65 * normal.dot(Vec3::new(-0.4, 0.4, 0.82)).max(0.0);
            let color = mesh.materials[usize::from(m)].base_color;
            let color = color.map(|v| (math::pow((v * light).clamp(0.0, 1.0), 1.0 / 2.2) * 255.0) as u8);
            self.triangle(corners, color);
        }
    }

    fn triangle(&mut self, corners: [Vec3; 3], color: [u8; 3]) {
        let [p, q, r] = corners.map(|c| self.pixel(c.truncate()));
        let area = (q - p).perp_dot(r - p);
        let limit = Vec2::splat(self.width as f32 - 1.0);
        let (low, high) = (p.min(q).min(r).floor().max(Vec2::ZERO), p.max(q).max(r).ceil().min(limit));
        if area.abs() < 1e-9 || high.x < low.x || high.y < low.y {
            return;
        }
        for y in low.y as usize..=high.y as usize {
            for x in low.x as usize..=high.x as usize {
                let at = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                let (u, v) = ((q - at).perp_dot(r - at) / area, (r - at).perp_dot(p - at) / area);
                let w = 1.0 - u - v;
                let z = corners[0].z * u + corners[1].z * v + corners[2].z * w;
                let i = y * self.width + x;
                if u >= 0.0 && v >= 0.0 && w >= 0.0 && z > self.heights[i] {
                    self.heights[i] = z;
                    self.pixels[i] = color;
                }
            }
        }
    }

    fn surfaces(&mut self, town: &Town, catalogue: &Catalogue) {
        for placement in &town.placements {
            if let PlacedObject::TownMesh(i) = placement.object {
                self.mesh(&town.meshes[i as usize], placement.world_from_object);
            }
        }
        for parked in &town.parked {
            if let Some(model) = catalogue.vehicle(parked.vehicle.model) {
                self.mesh(model.body(), parked.pose.world_from_object());
            }
        }
        for placement in &town.placements {
            let (radius, color) = match placement.object {
                PlacedObject::Prop(Prop::BroadleafTree, _) => (2.2, [44, 74, 34]),
                PlacedObject::Prop(Prop::Conifer, _) => (1.7, [28, 56, 38]),
                PlacedObject::Prop(Prop::Palm, _) => (1.8, [70, 100, 44]),
                PlacedObject::Prop(Prop::Bush | Prop::Hedge, _) => (0.6, [52, 90, 40]),
                _ => continue,
            };
            self.disc(placement.world_from_object.translation.truncate(), radius, color);
        }
    }

    fn lines(&mut self, town: &Town) {
        for lane in &town.network.lanes {
            let color = if lane.junction.is_some() { CONNECTOR } else { LANE };
            for pair in lane.centerline.points().windows(2) {
                self.line(pair[0].as_vec3().truncate(), pair[1].as_vec3().truncate(), color);
            }
        }
        for edge in &town.network.walk.edges {
            let [a, b] = edge.nodes.map(|n| town.network.walk.nodes[n.index()].as_vec3().truncate());
            self.line(a, b, WALK);
        }
        for crossing in &town.network.crossings {
            let [a, b] = crossing.ends.map(|e| e.as_vec3().truncate());
            self.line(a, b, CROSSING);
        }
    }

    fn dots(&mut self, town: &Town) {
        for lamp in &town.lamps {
            self.disc(lamp.position.truncate(), 0.6, LAMP);
        }
        for placement in town.placements.iter().filter(|p| p.signal.is_some()) {
            let m = placement.world_from_object;
            let at = m.translation.truncate();
            self.disc(at, 0.5, SIGNAL);
            self.line(at, at + m.transform_vector3(Vec3::X).truncate() * 1.6, SIGNAL);
        }
        for camera in &town.cameras {
            let at = Vec3::from_array(camera.position).truncate();
            self.disc(at, 1.2, CAMERA);
            let corner = |side: f32| {
                let (sin, cos) = math::sin_cos(camera.yaw_rad + side * camera.horizontal_fov_rad);
                at + Vec2::new(cos, sin) * SIGHT_M
            };
            self.line(at, corner(-0.5), CAMERA);
            self.line(at, corner(0.5), CAMERA);
            self.line(corner(-0.5), corner(0.5), CAMERA);
        }
    }
}
