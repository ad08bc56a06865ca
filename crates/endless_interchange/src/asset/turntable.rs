//! Pictures of single assets, made by the renderer on an empty square in daylight.

use super::item::{AssetError, CatalogueItem, find};
use endless_asset::Catalogue;
use endless_render::{CameraBake, FrameDescription, FrameScene, Geometry, Instance, RenderSettings, StaticScene};
use endless_scene::{Material, Mesh, MeshBuilder, Surface};
use endless_world::{CameraSite, ClassTag, Image, ImageSize, LensModel, Mount, TimeOfDay, Weather, math};
use glam::{Affine3A, Vec2, Vec3};
use std::f32::consts::{PI, TAU};

/// Size of one view.
const VIEW: ImageSize = ImageSize { width: 480, height: 360 };
/// Views of a turntable: columns and rows.
const SHEET: [u32; 2] = [4, 2];
const FIELD_OF_VIEW_RAD: f32 = 0.5;
/// From which height it is seen: as from a camera on a pole 15 m away.
const DOWN_TILT_RAD: f32 = 0.38;

/// Eight views of one asset from all sides, the first from ahead and left; `variant` counts its draws and colours.
///
/// # Errors
/// When there is no such asset.
pub fn asset_preview(catalogue: &Catalogue, name: &str, variant: u64) -> Result<Image<[u8; 3]>, AssetError> {
    let mesh = whole(catalogue, &find(catalogue, name, variant)?, variant);
    let (low, high) = mesh.bounds();
    let still = stage(mesh);
    let [columns, rows] = SHEET;
    let size = ImageSize { width: columns * VIEW.width, height: rows * VIEW.height };
    let mut pixels = vec![[0u8; 3]; size.pixels()];
    for i in 0..columns * rows {
        let azimuth = PI / 5.0 + TAU * i as f32 / (columns * rows) as f32;
        let view = render_view(&still, &site(low, high, azimuth));
        let corner = (i / columns * VIEW.height * size.width + i % columns * VIEW.width) as usize;
        for (y, row) in view.data.chunks(VIEW.width as usize).enumerate() {
            let at = corner + y * size.width as usize;
            pixels[at..at + row.len()].copy_from_slice(row);
        }
    }
    Ok(Image { size, data: pixels })
}

/// With wheels, in its paint, and with who rides it.
fn whole(catalogue: &Catalogue, item: &CatalogueItem, variant: u64) -> Mesh {
    match item {
        CatalogueItem::Vehicle(vehicle) => {
            let mut mesh = vehicle.whole();
            let tint = vehicle.tint(variant);
            for material in mesh.materials.iter_mut().filter(|m| m.surface == Surface::CarPaint) {
                material.base_color = [0, 1, 2].map(|k| material.base_color[k] * tint[k]);
            }
            if let Some(rider) = vehicle.rider(variant) {
                mesh.append(&rider, Affine3A::IDENTITY);
            }
            mesh
        }
        CatalogueItem::Person(person) => {
            let motion = endless_world::WalkerMotion {
                speed_mps: person.walk_mps,
                gait: endless_world::Gait::Walk,
                walked_m: 0.15,
                ..endless_world::WalkerMotion::default()
            };
            let pose = person.pose(&motion);
            Mesh { positions: pose.positions, normals: pose.normals, ..(*person.rest).clone() }
        }
        CatalogueItem::Building(mesh) => mesh.clone(),
        CatalogueItem::Imported(thing) => (*thing.mesh).clone(),
        CatalogueItem::Prop(prop, variant) => catalogue.prop(*prop, *variant),
    }
}

/// A paved square with an object in its middle.
fn stage(thing: Mesh) -> StaticScene {
    let ground = Material::new(Surface::Asphalt, [0.14, 0.14, 0.14], ClassTag::Roads);
    let mut square = MeshBuilder::new();
    let corner = |x: f32, y: f32| Vec3::new(x, y, 0.0) * 300.0;
    let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    square.quad(corners, corners.map(|c| Vec2::new(c.x, c.y + 50.0)), ground);
    let instances = [square.finish(), thing].map(|mesh| Instance::new(&Geometry::new(mesh), Affine3A::IDENTITY));
    StaticScene::new(instances.into(), &[])
}

/// A camera from which a box of these corners fills the picture.
fn site(low: Vec3, high: Vec3, azimuth: f32) -> CameraSite {
    let middle = 0.5 * (low + high);
    let (sin, cos) = math::sin_cos(azimuth);
    // What the box measures across the view and upwards in it, seen from here.
    let half = 0.5 * (high - low);
    let across = half.x * sin.abs() + half.y * cos.abs();
    let deep = half.x * cos.abs() + half.y * sin.abs();
    let (down_sin, down_cos) = math::sin_cos(DOWN_TILT_RAD);
    let upward = half.z * down_cos + deep * down_sin;
    let tangent = math::tan(0.5 * FIELD_OF_VIEW_RAD);
    let aspect = VIEW.width as f32 / VIEW.height as f32;
    let distance = 1.12 * (across / tangent).max(upward * aspect / tangent) + deep;
    let position = middle + distance * Vec3::new(cos * down_cos, sin * down_cos, down_sin);
    CameraSite {
        name: "view".to_owned(),
        position: position.to_array(),
        yaw_rad: azimuth + PI,
        down_tilt_rad: DOWN_TILT_RAD,
        horizontal_fov_rad: FIELD_OF_VIEW_RAD,
        lens: LensModel::Pinhole,
        mount: Mount::Pole,
        roll_rad: 0.0,
    }
}

fn render_view(still: &StaticScene, site: &CameraSite) -> Image<[u8; 3]> {
    let settings = RenderSettings::new(Weather::ClearSky, TimeOfDay::Afternoon, 0, VIEW);
    let frame = FrameScene::new(FrameDescription::default());
    CameraBake::bake(still, &settings, site).render(still, &frame).rgb
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_preview_shows_the_thing_from_all_sides() {
        let picture = asset_preview(&Catalogue::builtin(), "motorcycle.scooter", 1).expect("an asset");
        let width = picture.size.width as usize;
        // In the middle of each of the eight views there is something else than the ground of its corner.
        for (row, column) in (0..2).flat_map(|r| (0..4).map(move |c| (r, c))) {
            let at = |x: usize, y: usize| picture.data[(row * 360 + y) * width + column * 480 + x];
            let ground = at(20, 340);
            let differs = |p: [u8; 3]| p.iter().zip(ground).any(|(a, b)| a.abs_diff(b) > 40);
            let differing = (160..320).flat_map(|x| (90..270).map(move |y| (x, y))).filter(|&(x, y)| differs(at(x, y)));
            assert!(differing.count() > 2000, "view {row} {column}");
        }
    }
}
