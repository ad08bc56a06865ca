//! Contact sheets of what stands still, each piece on a square of its own in daylight:
//! `cargo run --release -p endless_city --example set -- furniture|plants|buildings OUT.jpg [NAME ...]`.

mod staged;

use endless_asset::{Catalogue, Prop};
use endless_render::{
    CameraBake, FrameDescription, FrameScene, Gathering, Geometry, Instance, RenderSettings, StaticScene,
};
use endless_scene::{Material, Mesh, MeshBuilder, Surface};
use endless_world::{CameraSite, ClassTag, ImageSize, LensModel, Mount, TimeOfDay, Weather, math};
use glam::{Affine3A, Vec2, Vec3};
use staged::sheet;
use std::error::Error;

/// Sizes of one picture.
const SMALL: ImageSize = ImageSize { width: 190, height: 170 };
const LARGE: ImageSize = ImageSize { width: 318, height: 240 };
const FIELD_OF_VIEW_RAD: f32 = 0.5;
const QUALITY: u8 = 84;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [what, out, only @ ..] = arguments.as_slice() else {
        return Err("usage: set furniture|plants|buildings OUT.jpg [NAME ...]".into());
    };
    let catalogue = Catalogue::builtin();
    let mut pieces = match what.as_str() {
        "furniture" => props(&catalogue, false),
        "plants" => props(&catalogue, true),
        "buildings" => buildings(),
        _ => return Err(format!("no sheet of {what}").into()),
    };
    // Fronts of buildings look towards −y.
    let (tile, columns, azimuth) = match what.as_str() {
        "buildings" => (LARGE, 6, -1.05),
        "plants" => (LARGE, 6, -0.62),
        _ => (SMALL, 10, -0.62),
    };
    pieces.retain(|p| only.is_empty() || only.contains(&p.0));
    let tiles: Vec<Vec<[u8; 3]>> = pieces.iter().map(|(_, mesh)| picture(mesh, tile, azimuth)).collect();
    eprintln!("{}", pieces.iter().map(|p| p.0.as_str()).collect::<Vec<_>>().join(" "));
    let rows: Vec<Vec<Vec<[u8; 3]>>> = tiles.chunks(columns).map(<[_]>::to_vec).collect();
    sheet::save(out, &rows, tile, QUALITY)
}

/// One variant of every prop; of signs one more of each kind of face.
fn props(catalogue: &Catalogue, plants: bool) -> Vec<(String, Mesh)> {
    let mut all = Vec::new();
    for &prop in Prop::ALL.iter().filter(|p| p.is_plant() == plants) {
        let variants = catalogue.prop_variants(prop);
        let shown = match prop {
            Prop::TrafficSign => 6,
            _ if plants => variants.min(4),
            _ => 1,
        };
        for k in 0..shown {
            all.push((prop.name().to_owned(), catalogue.prop(prop, k * variants / shown)));
        }
    }
    all
}

/// One building of every style.
fn buildings() -> Vec<(String, Mesh)> {
    let names = endless_town::building_styles();
    names.into_iter().filter_map(|n| Some((n.to_owned(), endless_town::sample_building(n, 3)?))).collect()
}

/// A square with a thing in its middle.
fn stage(thing: &Mesh) -> StaticScene {
    let ground = Material::new(Surface::Concrete, [0.23, 0.23, 0.225], ClassTag::Ground);
    let mut square = MeshBuilder::new();
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec3::new(x, y, 0.0) * 400.0);
    square.quad(corners, corners.map(|c| Vec2::new(c.x, c.y)), ground);
    let place = |mesh: Mesh| Instance::new(&Geometry::new(mesh), Affine3A::IDENTITY);
    StaticScene::new(vec![place(square.finish()), place(thing.clone())], &[])
}

/// A camera that a box of these corners fills, as far up as one on a pole 12 m away, ahead and to the right of it.
fn site(low: Vec3, high: Vec3, tile: ImageSize, azimuth: f32) -> CameraSite {
    let tilt = 0.24f32;
    let middle = 0.5 * (low + high);
    let half = 0.5 * (high - low);
    let (sin, cos) = math::sin_cos(azimuth);
    let across = half.x * sin.abs() + half.y * cos.abs();
    let deep = half.x * cos.abs() + half.y * sin.abs();
    let (tilt_sin, tilt_cos) = math::sin_cos(tilt);
    let upward = half.z * tilt_cos + deep * tilt_sin;
    let tangent = math::tan(0.5 * FIELD_OF_VIEW_RAD);
    let aspect = tile.width as f32 / tile.height as f32;
    let distance = (0.98 * (across / tangent).max(upward * aspect / tangent) + 0.75 * deep).max(2.0);
    let position = middle + distance * Vec3::new(cos * tilt_cos, sin * tilt_cos, tilt_sin);
    CameraSite {
        name: "view".to_owned(),
        position: position.to_array(),
        yaw_rad: azimuth + std::f32::consts::PI,
        down_tilt_rad: tilt,
        horizontal_fov_rad: FIELD_OF_VIEW_RAD,
        lens: LensModel::Pinhole,
        mount: Mount::Pole,
        roll_rad: 0.0,
    }
}

fn picture(mesh: &Mesh, tile: ImageSize, azimuth: f32) -> Vec<[u8; 3]> {
    let still = stage(mesh);
    let settings = RenderSettings {
        gathering: Gathering::Interpolated { rays: 4 },
        ..RenderSettings::new(Weather::ClearSky, TimeOfDay::Afternoon, 1, sheet::large(tile))
    };
    let (mut low, high) = mesh.bounds();
    // Of slender things the upper part tells what they are.
    let wide = (high.x - low.x).max(high.y - low.y);
    low.z = low.z.max(high.z - 3.0 * wide.max(0.5));
    let bake = CameraBake::bake(&still, &settings, &site(low, high, tile, azimuth));
    bake.render(&still, &FrameScene::new(FrameDescription::default())).rgb.data
}
