//! Contact sheets of the catalogue, to look at: `cargo run --example preview -- vehicles OUT.png [filter]`, or `people`,
//! `far`, `gait`, `riders`, `plants`, `furniture`; of people and `far` the filter is the weather: `fair`, `rain`, `hot`, `cold`. A small z-buffer rasteriser with sun, sky and mirrored sky.

#![expect(clippy::print_stdout, reason = "it says what it drew")]

use endless_asset::{Catalogue, Prop, VehicleModel};
use endless_scene::{Material, Mesh, Surface};
use endless_world::{Gait, Outfit, PersonRef, VehicleModelId, VehicleRef, WalkerMotion};
use glam::{Affine3A, Quat, Vec3};
use std::io::BufWriter;

const TILE: usize = 420;
const SAMPLES: usize = 2;

type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// A mesh and the paint of its tinted surfaces.
type Tinted = (Mesh, [f32; 3]);

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [what, path, rest @ ..] = arguments.as_slice() else {
        return Err("usage: preview WHAT OUT.png [FILTER]".into());
    };
    let filter = rest.first().map_or("", String::as_str);
    let catalogue = Catalogue::builtin();
    let tiles = match what.as_str() {
        "vehicles" => vehicles(&catalogue, filter),
        "people" => people(&catalogue, outfit(filter)?),
        "far" => return sheet_of(&far(&catalogue, outfit(filter)?), path),
        "gait" => gait(&catalogue),
        "riders" => riders(&catalogue, filter),
        "plants" => props(
            &catalogue,
            filter,
            &[
                Prop::BroadleafTree,
                Prop::Conifer,
                Prop::Palm,
                Prop::Cypress,
                Prop::BareTree,
                Prop::Bush,
                Prop::Hedge,
                Prop::Planter,
                Prop::FlowerBed,
                Prop::GrassTuft,
                Prop::Wheat,
                Prop::Rock,
            ],
        ),
        "furniture" => props(&catalogue, filter, FURNITURE),
        _ => return Err("vehicles, people, far, gait, riders, plants or furniture".into()),
    };
    sheet(&tiles, path)
}

const FURNITURE: &[Prop] = &[
    Prop::StreetLamp,
    Prop::UtilityPole,
    Prop::CameraPole,
    Prop::SignalPole,
    Prop::SignalMast,
    Prop::SignalCurvedMast,
    Prop::WalkSignal,
    Prop::StopSign,
    Prop::YieldSign,
    Prop::SpeedSign,
    Prop::CrossingSign,
    Prop::Bench,
    Prop::Bin,
    Prop::Hydrant,
    Prop::PostBox,
    Prop::Bollard,
    Prop::BusShelter,
    Prop::Billboard,
    Prop::Planter,
    Prop::Cone,
    Prop::Kiosk,
    Prop::Railing,
    Prop::FencePanel,
    Prop::BikeRack,
    Prop::CafeTable,
    Prop::Cabinet,
    Prop::Dumpster,
    Prop::MarketStall,
    Prop::FoodCart,
    Prop::HandCart,
    Prop::VendorBlanket,
    Prop::CrateStack,
    Prop::SandHeap,
    Prop::BrickPallet,
    Prop::BuildingStock,
    Prop::ScaffoldBay,
    Prop::LaundryLine,
    Prop::KerbRail,
    Prop::SatelliteDish,
];

fn with_wheels(catalogue: &Catalogue, vehicle: VehicleRef, rider: bool) -> Tinted {
    let model = &catalogue.vehicles()[vehicle.model.index()];
    let mut mesh = model.whole();
    if let (true, Some(rider)) = (rider, model.rider(vehicle.variant)) {
        mesh.append(&rider, Affine3A::IDENTITY);
    }
    (mesh, model.tint(vehicle.variant))
}

/// Seen from the front left and the rear right, from a camera's height.
fn vehicles(catalogue: &Catalogue, filter: &str) -> Vec<Tile> {
    let mut tiles = Vec::new();
    let mut last = "";
    for (i, v) in catalogue.vehicles().iter().enumerate().filter(|(_, v)| v.spec.name.contains(filter)) {
        if filter.is_empty() && last == v.spec.name {
            continue;
        }
        last = v.spec.name;
        for (angle, elevation) in [(50.0, 22.0), (-140.0, 22.0), (90.0, 3.0)] {
            let vehicle = VehicleRef { model: VehicleModelId::from_index(i), variant: 3 + i as u64 };
            let (mesh, tint) = with_wheels(catalogue, vehicle, angle > 0.0);
            tiles.push(Tile { mesh, tint, angle, elevation });
        }
        println!(
            "{:24} {:6} triangles {:.2} x {:.2} x {:.2} m",
            v.spec.name,
            v.body().triangles.len(),
            v.spec.length_m,
            v.spec.width_m,
            v.spec.height_m
        );
    }
    tiles
}

fn outfit(word: &str) -> Result<Outfit> {
    match word {
        "" | "fair" => Ok(Outfit::Fair),
        "rain" => Ok(Outfit::Rain),
        "hot" => Ok(Outfit::Hot),
        "cold" => Ok(Outfit::Cold),
        _ => Err("fair, rain, hot or cold".into()),
    }
}

/// People as few pixels high as those far from a camera, each row of one height; every pixel is drawn as a square.
fn far(catalogue: &Catalogue, outfit: Outfit) -> Vec<Vec<u8>> {
    let heights = [12, 16, 20, 25, 50];
    let mut pictures = Vec::new();
    for pixels in heights {
        for i in 0..8u64 {
            let person = catalogue.dressed_person(PersonRef { outfit, seed: i });
            let mesh = posed(&person, if i % 4 == 3 { Gait::Stand } else { Gait::Walk }, 0.37 * i as f32);
            let high = mesh.bounds().1.z;
            let tile = Tile { mesh, tint: [1.0; 3], angle: 35.0 + 47.0 * i as f32, elevation: 18.0 };
            pictures.push(coarse(&draw(&tile), tile.height_px(high) / pixels as f32));
        }
    }
    pictures
}

/// A picture of so many times fewer pixels, shown as large as before.
fn coarse(picture: &[u8], factor: f32) -> Vec<u8> {
    let cell = |at: usize| ((at as f32 / factor) as usize, factor);
    let span = |k: usize| ((k as f32 * factor) as usize)..(((k + 1) as f32 * factor) as usize).min(TILE);
    let linear = |v: u8| endless_world::math::pow(f32::from(v) / 255.0, 2.2);
    let n = (TILE as f32 / factor) as usize + 1;
    let mut small = vec![[0u8; 3]; n * n];
    for (k, pixel) in small.iter_mut().enumerate() {
        let (ys, xs) = (span(k / n), span(k % n));
        let count = (ys.len() * xs.len()).max(1) as f32;
        let mut sum = [0.0f32; 3];
        for y in ys {
            for x in xs.clone() {
                (0..3).for_each(|c| sum[c] += linear(picture[(y * TILE + x) * 3 + c]));
            }
        }
        *pixel = sum.map(|v| (endless_world::math::pow(v / count, 1.0 / 2.2) * 255.0) as u8);
    }
    let at = |k: usize| cell(k).0.min(n - 1);
    (0..TILE * TILE).flat_map(|k| small[at(k / TILE) * n + at(k % TILE)]).collect()
}

fn people(catalogue: &Catalogue, outfit: Outfit) -> Vec<Tile> {
    (0..48)
        .map(|i| {
            let person = catalogue.dressed_person(PersonRef { outfit, seed: i });
            let gait = if i % 4 == 0 { Gait::Stand } else { Gait::Walk };
            let mesh = posed(&person, gait, 0.37 * i as f32);
            Tile { mesh, tint: [1.0; 3], angle: 35.0 + 47.0 * i as f32, elevation: 15.0 }
        })
        .collect()
}

fn posed(person: &endless_asset::PersonModel, gait: Gait, walked_m: f32) -> Mesh {
    let speed_mps = match gait {
        Gait::Walk => person.walk_mps,
        Gait::Run => 3.0,
        _ => 0.0,
    };
    let pose = person.pose(&WalkerMotion { speed_mps, gait, walked_m, time_s: walked_m, footing: None, risen: 0.0 });
    Mesh { positions: pose.positions, normals: pose.normals, ..(*person.rest).clone() }
}

fn gait(catalogue: &Catalogue) -> Vec<Tile> {
    let mut tiles = Vec::new();
    for (variant, gait) in [(1, Gait::Walk), (2, Gait::Run), (5, Gait::Walk)] {
        for k in 0..8 {
            let mesh = posed(&catalogue.person(variant), gait, 0.2 * k as f32);
            tiles.push(Tile { mesh, tint: [1.0; 3], angle: 90.0, elevation: 2.0 });
        }
    }
    tiles
}

fn riders(catalogue: &Catalogue, filter: &str) -> Vec<Tile> {
    let mut tiles = Vec::new();
    let ridden = |v: &VehicleModel| v.spec.ridden && v.spec.name.contains(filter);
    for (i, _) in catalogue.vehicles().iter().enumerate().filter(|(_, v)| ridden(v)) {
        for (k, angle) in [90.0, 40.0, -130.0, 180.0].into_iter().enumerate() {
            let vehicle = VehicleRef { model: VehicleModelId::from_index(i), variant: k as u64 };
            let (mesh, tint) = with_wheels(catalogue, vehicle, true);
            tiles.push(Tile { mesh, tint, angle, elevation: 12.0 });
        }
    }
    tiles
}

fn props(catalogue: &Catalogue, filter: &str, list: &[Prop]) -> Vec<Tile> {
    let mut tiles = Vec::new();
    for &prop in list.iter().filter(|p| filter.split(',').any(|word| format!("{p:?}").contains(word))) {
        for variant in 0..catalogue.prop_variants(prop).min(8) {
            let mesh = catalogue.prop(prop, variant);
            println!("{prop:?} {variant}: {} triangles", mesh.triangles.len());
            tiles.push(Tile { mesh, tint: [1.0; 3], angle: 35.0, elevation: 15.0 });
        }
    }
    tiles
}

/// One picture: the object seen from an azimuth (0 = from ahead, 90 = from its left) and elevation, degrees.
struct Tile {
    mesh: Mesh,
    tint: [f32; 3],
    angle: f32,
    elevation: f32,
}

impl Tile {
    /// How many pixels high something upright of this height is drawn.
    fn height_px(&self, height_m: f32) -> f32 {
        let (low, high) = self.mesh.bounds();
        let (low, high) = (low.min(Vec3::new(-0.3, -0.3, 0.0)), high.max(Vec3::new(0.3, 0.3, 0.5)));
        let radius = 0.5 * (high - low).length();
        height_m * endless_world::math::cos(self.elevation.to_radians()) * TILE as f32 * 2.0 / (4.2 * radius)
    }
}

fn sheet(tiles: &[Tile], path: &str) -> Result<()> {
    sheet_of(&tiles.iter().map(draw).collect::<Vec<_>>(), path)
}

/// Pictures of one size, beside and below each other.
fn sheet_of(tiles: &[Vec<u8>], path: &str) -> Result<()> {
    let columns = if tiles.len().is_multiple_of(3) && tiles.len() < 12 {
        3
    } else if tiles.len().is_multiple_of(8) {
        8
    } else {
        6
    };
    let columns = columns.min(tiles.len().max(1));
    let rows = tiles.len().div_ceil(columns);
    let (width, height) = (columns * TILE, rows * TILE);
    let mut pixels = vec![0u8; width * height * 3];
    for (i, picture) in tiles.iter().enumerate() {
        let (x0, y0) = (i % columns * TILE, i / columns * TILE);
        for y in 0..TILE {
            let to = ((y0 + y) * width + x0) * 3;
            pixels[to..to + TILE * 3].copy_from_slice(&picture[y * TILE * 3..(y + 1) * TILE * 3]);
        }
    }
    let mut encoder = png::Encoder::new(BufWriter::new(std::fs::File::create(path)?), width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(&pixels)?;
    Ok(())
}

fn draw(tile: &Tile) -> Vec<u8> {
    let n = TILE * SAMPLES;
    let (low, high) = tile.mesh.bounds();
    let (low, high) = (low.min(Vec3::new(-0.3, -0.3, 0.0)), high.max(Vec3::new(0.3, 0.3, 0.5)));
    let centre = 0.5 * (low + high);
    let radius = 0.5 * (high - low).length();
    let direction =
        Quat::from_rotation_z(tile.angle.to_radians()) * Quat::from_rotation_y(-tile.elevation.to_radians()) * Vec3::X;
    let eye = centre + direction * radius * 4.2;
    let forward = -direction;
    let right = forward.cross(Vec3::Z).normalize_or(Vec3::Y);
    let up = right.cross(forward);
    let scale = n as f32 * 0.5 * 4.0 / radius * 1.0;
    let project = |p: Vec3| {
        let v = p - eye;
        let depth = v.dot(forward);
        Vec3::new(
            0.5 * n as f32 + scale * radius * v.dot(right) / depth,
            0.5 * n as f32 - scale * radius * v.dot(up) / depth,
            depth,
        )
    };
    let mut color = vec![Vec3::new(0.42, 0.48, 0.55); n * n];
    let mut depth = vec![f32::INFINITY; n * n];
    let mut ground = Mesh::default();
    let grey = Material::new(Surface::Asphalt, [0.16, 0.16, 0.165], endless_world::ClassTag::Roads);
    let mut builder = endless_scene::MeshBuilder::new();
    let g = radius * 3.0;
    builder.quad(
        [Vec3::new(-g, -g, 0.0), Vec3::new(g, -g, 0.0), Vec3::new(g, g, 0.0), Vec3::new(-g, g, 0.0)],
        [glam::Vec2::ZERO; 4],
        grey,
    );
    ground.append(&builder.finish(), Affine3A::IDENTITY);
    let sun = Vec3::new(0.45, 0.35, 0.82).normalize_or(Vec3::Z);
    for mesh in [&ground, &tile.mesh] {
        for (t, &m) in mesh.triangles.iter().zip(&mesh.triangle_materials) {
            let material = mesh.materials[usize::from(m)];
            let world = t.map(|i| mesh.positions[i as usize]);
            let normals = t.map(|i| mesh.normals[i as usize]);
            let p = world.map(project);
            if p.iter().any(|q| q.z < 0.01) {
                continue;
            }
            let area = (p[1] - p[0]).truncate().perp_dot((p[2] - p[0]).truncate());
            // The screen's y points down: faces seen from outside have negative area.
            let foliage = material.surface == Surface::Foliage;
            if area >= 0.0 && !foliage || area == 0.0 {
                continue;
            }
            let (x0, x1) =
                (p.iter().map(|q| q.x).fold(f32::MAX, f32::min), p.iter().map(|q| q.x).fold(f32::MIN, f32::max));
            let (y0, y1) =
                (p.iter().map(|q| q.y).fold(f32::MAX, f32::min), p.iter().map(|q| q.y).fold(f32::MIN, f32::max));
            for y in y0.max(0.0) as usize..=(y1.max(0.0) as usize).min(n - 1) {
                for x in x0.max(0.0) as usize..=(x1.max(0.0) as usize).min(n - 1) {
                    let s = glam::Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                    let w = [0, 1, 2].map(|i| {
                        let (a, b) = (p[(i + 1) % 3].truncate(), p[(i + 2) % 3].truncate());
                        (b - a).perp_dot(s - a) / area
                    });
                    if w.iter().any(|&v| v < 0.0) {
                        continue;
                    }
                    let z = 1.0 / (w[0] / p[0].z + w[1] / p[1].z + w[2] / p[2].z);
                    let at = y * n + x;
                    if z >= depth[at] {
                        continue;
                    }
                    depth[at] = z;
                    let normal = (normals[0] * w[0] + normals[1] * w[1] + normals[2] * w[2]).normalize_or(Vec3::Z);
                    color[at] = shade(material, tile.tint, normal, forward, sun);
                }
            }
        }
    }
    let mut out = Vec::with_capacity(TILE * TILE * 3);
    for y in 0..TILE {
        for x in 0..TILE {
            let mut sum = Vec3::ZERO;
            for dy in 0..SAMPLES {
                for dx in 0..SAMPLES {
                    sum += color[(y * SAMPLES + dy) * n + x * SAMPLES + dx].min(Vec3::ONE);
                }
            }
            let c = sum / (SAMPLES * SAMPLES) as f32;
            out.extend(c.to_array().map(|v| (endless_world::math::pow(v.clamp(0.0, 1.0), 1.0 / 2.2) * 255.0) as u8));
        }
    }
    out
}

fn sky(direction: Vec3) -> Vec3 {
    let t = endless_world::math::smoothstep(-0.15, 0.6, direction.z);
    Vec3::new(0.16, 0.155, 0.15).lerp(Vec3::new(0.75, 0.85, 1.0), t)
}

fn shade(material: Material, tint: [f32; 3], normal: Vec3, view: Vec3, sun: Vec3) -> Vec3 {
    let mut albedo = Vec3::from(material.base_color);
    if material.surface == Surface::CarPaint {
        albedo *= Vec3::from(tint);
    }
    let diffuse = albedo * (0.95 * normal.dot(sun).max(0.0) + 0.42 * (0.6 + 0.4 * normal.z));
    let mirror = view - 2.0 * normal * view.dot(normal);
    let grazing = endless_world::math::pow((1.0 + view.dot(normal)).clamp(0.0, 1.0), 5.0);
    let (f0, gloss) = match material.surface {
        Surface::CarPaint | Surface::CarGlass | Surface::VehicleLight(_) => (0.05, 1.0),
        Surface::Chrome => return Vec3::from(material.base_color) * (0.2 + sky(mirror)),
        Surface::Plastic | Surface::Leather | Surface::Painted => (0.03, 0.4),
        _ => (0.0, 0.0),
    };
    let fresnel = (f0 + (1.0 - f0) * grazing) * gloss;
    let glint = endless_world::math::pow(mirror.dot(sun).max(0.0), 300.0) * 3.0 * gloss;
    diffuse * (1.0 - fresnel) + sky(mirror) * fresnel + Vec3::splat(glint)
}
