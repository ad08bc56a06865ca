//! Draws what a camera site sees, flat-shaded: `cargo run -p endless_town --release --example siteview -- Town03 0 out.png`;
//! `all` in place of the number draws every site on one sheet. Lists the sites if no number is given.

mod open;

use endless_asset::{Catalogue, Prop};
use endless_scene::{Mesh, Surface};
use endless_town::{PlacedObject, Placement, Town};
use endless_world::{CameraSite, ImageSize, PinholeCamera, math};
use glam::{Affine3A, Vec2, Vec3};
use std::{collections::BTreeMap, error::Error, fs::File, io::BufWriter, io::Write};

const LARGE: ImageSize = ImageSize { width: 960, height: 540 };
const SMALL: ImageSize = ImageSize { width: 480, height: 270 };
/// Pictures side by side on a sheet.
const COLUMNS: usize = 3;
const NEAR_M: f32 = 0.1;

struct Film {
    size: ImageSize,
    camera: PinholeCamera,
    pixels: Vec<[u8; 3]>,
    /// Inverse depth.
    near: Vec<f32>,
}

impl Film {
    fn mesh(&mut self, mesh: &Mesh, world_from_mesh: Affine3A, tint: Vec3) {
        for (t, &m) in mesh.triangles.iter().zip(&mesh.triangle_materials) {
            let corners = t.map(|i| world_from_mesh.transform_point3(mesh.positions[i as usize]));
            if corners.iter().all(|&p| self.camera.camera_from_world(p).z < NEAR_M) {
                continue;
            }
            let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or_zero();
            let light = 0.3 + 0.55 * normal.dot(Vec3::new(-0.5, 0.35, 0.79)).max(0.0) + 0.15 * normal.z.max(0.0);
            let back = normal.dot(corners[0] - self.camera.position) > 0.0;
            let base = Vec3::from_array(mesh.materials[usize::from(m)].base_color) * tint * light;
            // Faces seen from behind would be holes in a solid: show them in magenta.
            let leaf = mesh.materials[usize::from(m)].surface == Surface::Foliage;
            let base = if back && !leaf { Vec3::new(base.x.max(0.3), 0.0, base.z.max(0.3)) } else { base };
            let color = base.to_array().map(|v| (math::pow(v.clamp(0.0, 1.0), 1.0 / 2.2) * 255.0) as u8);
            self.clipped(corners.map(|p| self.camera.camera_from_world(p)), color);
        }
    }

    /// Cuts a triangle off at the near plane.
    fn clipped(&mut self, corners: [Vec3; 3], color: [u8; 3]) {
        let mut polygon: Vec<Vec3> = Vec::with_capacity(4);
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            if a.z > NEAR_M {
                polygon.push(a);
            }
            if (a.z > NEAR_M) != (b.z > NEAR_M) {
                polygon.push(a.lerp(b, (NEAR_M - a.z) / (b.z - a.z)));
            }
        }
        for k in 1..polygon.len().saturating_sub(1) {
            self.triangle([polygon[0], polygon[k], polygon[k + 1]], color);
        }
    }

    fn triangle(&mut self, corners: [Vec3; 3], color: [u8; 3]) {
        let k = self.camera.intrinsics;
        let [p, q, r] = corners.map(|c| Vec2::new(k.fx * c.x / c.z + k.cx, k.fy * c.y / c.z + k.cy));
        let area = (q - p).perp_dot(r - p);
        let limit = Vec2::new(self.size.width as f32 - 1.0, self.size.height as f32 - 1.0);
        let (low, high) = (p.min(q).min(r).floor().max(Vec2::ZERO), p.max(q).max(r).ceil().min(limit));
        if area.abs() < 1e-9 || high.x < low.x || high.y < low.y {
            return;
        }
        let inverse = corners.map(|c| 1.0 / c.z);
        for y in low.y as usize..=high.y as usize {
            for x in low.x as usize..=high.x as usize {
                let at = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                let w0 = (q - at).perp_dot(r - at) / area;
                let w1 = (r - at).perp_dot(p - at) / area;
                let w2 = 1.0 - w0 - w1;
                if w0 < 0.0 || w1 < 0.0 || w2 < 0.0 {
                    continue;
                }
                let near = inverse[0] * w0 + inverse[1] * w1 + inverse[2] * w2;
                let i = y * self.size.width as usize + x;
                if near > self.near[i] {
                    self.near[i] = near;
                    self.pixels[i] = color;
                }
            }
        }
    }
}

fn draw(town: &Town, catalogue: &Catalogue, made: &mut Made, film: &mut Film) {
    // Far woods are as good as hills here.
    let eye = film.camera.position;
    let near = |p: &&Placement| {
        matches!(p.object, PlacedObject::TownMesh(_))
            || Vec3::from(p.world_from_object.translation).distance(eye) < 110.0
    };
    for placement in town.placements.iter().filter(near) {
        match placement.object {
            PlacedObject::TownMesh(i) => film.mesh(&town.meshes[i as usize], placement.world_from_object, Vec3::ONE),
            PlacedObject::Prop(prop, variant) => {
                let mesh = made.entry((prop, variant)).or_insert_with(|| catalogue.prop(prop, variant));
                film.mesh(mesh, placement.world_from_object, Vec3::ONE);
            }
        }
    }
    for parked in &town.parked {
        let model = &catalogue.vehicles()[parked.vehicle.model.index()];
        let tint = model.tint(parked.vehicle.variant);
        film.mesh(model.body(), parked.pose.world_from_object(), Vec3::from_array(tint));
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let catalogue = Catalogue::builtin();
    let town = open::open(args.first().map_or("Town01", String::as_str), &catalogue)?;
    let Some(number) = args.get(1) else {
        for (i, site) in town.cameras.iter().enumerate() {
            writeln!(std::io::stdout(), "{i} {site:?}")?;
        }
        return Ok(());
    };
    let path = args.get(2).map_or("siteview.png", String::as_str);
    if number == "all" {
        return sheet(&town, &catalogue, path);
    }
    let site = town.cameras.get(number.parse::<usize>()?).ok_or("no such site")?;
    write(path, LARGE, &picture(&town, &catalogue, &mut Made::new(), site, LARGE))
}

/// Props that were made already.
type Made = BTreeMap<(Prop, u32), Mesh>;

fn picture(town: &Town, catalogue: &Catalogue, made: &mut Made, site: &CameraSite, size: ImageSize) -> Vec<[u8; 3]> {
    let camera = PinholeCamera::new(site, size);
    let mut film = Film { size, camera, pixels: vec![[168, 196, 226]; size.pixels()], near: vec![0.0; size.pixels()] };
    draw(town, catalogue, made, &mut film);
    film.pixels
}

/// All sites, row by row.
fn sheet(town: &Town, catalogue: &Catalogue, path: &str) -> Result<(), Box<dyn Error>> {
    let (w, h) = (SMALL.width as usize, SMALL.height as usize);
    let rows = town.cameras.len().div_ceil(COLUMNS);
    let size = ImageSize { width: SMALL.width * COLUMNS as u32, height: SMALL.height * rows as u32 };
    let mut pixels = vec![[0; 3]; size.pixels()];
    let mut made = Made::new();
    for (i, site) in town.cameras.iter().enumerate() {
        let small = picture(town, catalogue, &mut made, site, SMALL);
        let corner = (i / COLUMNS) * h * size.width as usize + (i % COLUMNS) * w;
        for y in 0..h {
            let to = corner + y * size.width as usize;
            pixels[to..to + w].copy_from_slice(&small[y * w..(y + 1) * w]);
        }
    }
    write(path, size, &pixels)
}

fn write(path: &str, size: ImageSize, pixels: &[[u8; 3]]) -> Result<(), Box<dyn Error>> {
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), size.width, size.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(&pixels.concat())?;
    Ok(())
}
