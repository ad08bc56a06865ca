//! Draws a town from above: `cargo run -p endless_town --release --example topview -- Town03 out.png [pixels a metre]`.

mod open;

use endless_asset::{Catalogue, Mesh};
use endless_town::{Town, What};
use endless_world::math;
use glam::{Affine3A, Vec2, Vec3};
use std::{error::Error, fs::File, io::BufWriter};

struct Canvas {
    width: usize,
    scale: f32,
    centre: Vec2,
    pixels: Vec<[u8; 3]>,
    depth: Vec<f32>,
}

impl Canvas {
    fn new(metres: f32, scale: f32, centre: Vec2) -> Self {
        let width = (metres * scale) as usize;
        let n = width * width;
        Self { width, scale, centre, pixels: vec![[24, 26, 30]; n], depth: vec![f32::MIN; n] }
    }

    fn pixel(&self, p: Vec2) -> Vec2 {
        let half = self.width as f32 / 2.0;
        let q = p - self.centre;
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

    /// Rasterises a mesh from above with a depth buffer; light falls in from the north-west.
    fn mesh(&mut self, mesh: &Mesh, world_from_mesh: Affine3A) {
        for (t, &m) in mesh.triangles.iter().zip(&mesh.triangle_materials) {
            let [a, b, c] = t.map(|i| world_from_mesh.transform_point3(mesh.positions[i as usize]));
            let normal = (b - a).cross(c - a).normalize_or_zero();
            if normal.z < 0.0 {
                continue;
            }
            let light = 0.35 + 0.65 * normal.dot(Vec3::new(-0.5, 0.4, 0.77)).max(0.0);
            let base = mesh.materials[usize::from(m)].base_color;
            let color = base.map(|v| (math::pow((v * light).clamp(0.0, 1.0), 1.0 / 2.2) * 255.0) as u8);
            self.triangle([a, b, c], color);
        }
    }

    fn triangle(&mut self, corners: [Vec3; 3], color: [u8; 3]) {
        let [p, q, r] = corners.map(|v| self.pixel(v.truncate()));
        let area = (q - p).perp_dot(r - p);
        if area.abs() < 1e-9 {
            return;
        }
        let low = p.min(q).min(r).floor().max(Vec2::ZERO);
        let high = p.max(q).max(r).ceil().min(Vec2::splat(self.width as f32 - 1.0));
        for y in low.y as usize..=high.y.max(0.0) as usize {
            for x in low.x as usize..=high.x.max(0.0) as usize {
                let at = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                let w0 = (q - at).perp_dot(r - at) / area;
                let w1 = (r - at).perp_dot(p - at) / area;
                let w2 = 1.0 - w0 - w1;
                let i = y * self.width + x;
                if w0 < 0.0 || w1 < 0.0 || w2 < 0.0 || i >= self.pixels.len() {
                    continue;
                }
                let z = corners[0].z * w0 + corners[1].z * w1 + corners[2].z * w2;
                if z > self.depth[i] {
                    self.depth[i] = z;
                    self.pixels[i] = color;
                }
            }
        }
    }

    fn save(&self, path: &str) -> Result<(), Box<dyn Error>> {
        let side = u32::try_from(self.width)?;
        let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), side, side);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.write_header()?.write_image_data(&self.pixels.concat())?;
        Ok(())
    }
}

fn draw(town: &Town, catalogue: &Catalogue, canvas: &mut Canvas, overlay: bool) {
    for placement in &town.placements {
        match placement.what {
            What::Own(i) => canvas.mesh(&town.meshes[i as usize], placement.world_from_object),
            What::Prop(prop, variant) => canvas.mesh(&catalogue.prop(prop, variant), placement.world_from_object),
        }
    }
    for parked in &town.parked {
        let model = &catalogue.vehicles()[usize::from(parked.asset.model)];
        canvas.mesh(&model.body, parked.pose.world_from_object());
    }
    if !overlay {
        return;
    }
    for lane in &town.network.lanes {
        let color = if lane.junction.is_some() { [230, 160, 40] } else { [90, 200, 255] };
        for pair in lane.centerline.points().windows(2) {
            canvas.line(pair[0].as_vec3().truncate(), pair[1].as_vec3().truncate(), color);
        }
    }
    for edge in &town.network.walk.edges {
        let [a, b] = edge.nodes.map(|n| town.network.walk.nodes[n.0 as usize].as_vec3().truncate());
        canvas.line(a, b, [120, 255, 120]);
    }
    for crossing in &town.network.crossings {
        let [a, b] = crossing.ends.map(|e| e.as_vec3().truncate());
        canvas.line(a, b, [255, 255, 255]);
    }
    for placement in &town.placements {
        if let What::Prop(..) = placement.what {
            let m = placement.world_from_object;
            let at = m.translation.truncate();
            let color = if placement.signal.is_some() { [255, 40, 40] } else { [40, 160, 60] };
            canvas.disc(at, 0.3, color);
            canvas.line(at, at + m.transform_vector3(Vec3::X).truncate() * 1.2, color);
        }
    }
    for lamp in &town.lamps {
        canvas.disc(lamp.position.truncate(), 0.6, [255, 240, 120]);
    }
    for camera in &town.cameras {
        let at = Vec3::from_array(camera.position).truncate();
        canvas.disc(at, 1.0, [255, 0, 255]);
        for side in [-0.5, 0.5] {
            let (sin, cos) = math::sin_cos(camera.yaw_rad + side * camera.horizontal_fov_rad);
            canvas.line(at, at + Vec2::new(cos, sin) * 50.0, [255, 0, 255]);
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let name = args.first().map_or("Town01", String::as_str);
    let path = args.get(1).map_or("topview.png", String::as_str);
    let number = |i: usize, default: f32| args.get(i).and_then(|a| a.parse().ok()).unwrap_or(default);
    let overlay = args.get(6).is_none_or(|a| a != "plain");
    let catalogue = Catalogue::builtin();
    let town = open::open(name, &catalogue)?;
    let points = town.network.lanes.iter().flat_map(|l| l.centerline.points()).map(|p| p.as_vec3().truncate());
    let (low, high) = points.fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)));
    let (middle, size) = ((low + high) / 2.0, (high - low).max_element() + 80.0);
    let (scale, metres) = (number(2, 1200.0 / size), number(3, size));
    let mut canvas = Canvas::new(metres, scale, Vec2::new(number(4, middle.x), number(5, middle.y)));
    draw(&town, &catalogue, &mut canvas, overlay);
    canvas.save(path)
}
