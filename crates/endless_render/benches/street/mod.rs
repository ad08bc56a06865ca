//! A street of houses, bushes and cars, made from nothing but the renderer's public types.

#![allow(dead_code, reason = "each bench uses some of it")]

use endless_render::{Footprint, Geometry, Instance, MovingObject, StaticScene};
use endless_scene::{Material, Mesh, MeshBuilder, Surface};
use endless_world::{CameraSite, ClassTag, ImageSize, InstanceId, LensModel, Mount, PinholeCamera, Stream};
use glam::{Affine3A, Quat, Vec2, Vec3};

/// Leaves of a bush.
const LEAVES: usize = 3000;
/// Bushes along the street: together about a million triangles.
const BUSHES: usize = 300;
/// Half the length of the street, metres.
const HALF_LENGTH_M: f32 = 120.0;

/// The meshes of the street, each with the transforms of its instances.
pub(crate) fn meshes() -> Vec<(Mesh, Vec<Affine3A>)> {
    let mut random = Stream::named(1, "street", &[]);
    let still = |mesh| (mesh, vec![Affine3A::IDENTITY]);
    let asphalt = Material::new(Surface::Asphalt, [0.12; 3], ClassTag::Roads);
    let mut all =
        vec![still(cuboid(Vec3::new(-HALF_LENGTH_M, -40.0, -0.1), Vec3::new(HALF_LENGTH_M, 40.0, 0.0), asphalt))];
    for house in 0..24 {
        let plaster = Material::new(Surface::Plaster, [0.5, 0.45, 0.35], ClassTag::Buildings);
        let (x, side) = (-110.0 + 20.0 * (house / 2) as f32, if house % 2 == 0 { 1.0 } else { -1.0 });
        let middle = Vec3::new(x, 20.0 * side, 0.0);
        let high = Vec3::new(8.0, 7.0, random.range_f32(8.0, 20.0));
        all.push(still(cuboid(middle - high.with_z(0.0), middle + high, plaster)));
    }
    let places = (0..BUSHES).map(|_| {
        let side = if random.chance(0.5) { 1.0 } else { -1.0 };
        let place = Vec3::new(random.range_f32(-HALF_LENGTH_M, HALF_LENGTH_M), side * random.range_f32(6.0, 12.0), 0.0);
        Affine3A::from_rotation_translation(Quat::from_rotation_z(random.range_f32(0.0, 6.2)), place)
    });
    let places = places.collect();
    all.push((bush(), places));
    all
}

/// What stands still, ready to be traced.
pub(crate) fn still() -> StaticScene {
    let instances = meshes().into_iter().flat_map(|(mesh, places)| {
        let geometry = Geometry::new(mesh);
        places.into_iter().map(move |place| Instance::new(&geometry, place))
    });
    StaticScene::new(instances.collect(), &[])
}

/// Boxes that drive along the street, so far on.
pub(crate) fn cars(geometry: &Geometry, count: u16, driven_m: f32) -> Vec<MovingObject> {
    let car = |i: u16| {
        let lane = if i.is_multiple_of(2) { 1.8 } else { -1.8 };
        let world_from_object = Affine3A::from_translation(Vec3::new(-60.0 + 6.0 * f32::from(i) + driven_m, lane, 0.0));
        let instance = Instance::new(geometry, world_from_object).with_id(InstanceId(i + 1), ClassTag::Car);
        let footprint = Footprint { world_from_object, ahead_m: 0.0, half_m: Vec2::new(2.2, 0.9), height_m: 1.4 };
        MovingObject { instances: vec![instance], footprint }
    };
    (0..count).map(car).collect()
}

/// The body of a car.
pub(crate) fn car() -> Geometry {
    let paint = Material::new(Surface::CarPaint, [0.4, 0.05, 0.05], ClassTag::Car);
    Geometry::rigid(cuboid(Vec3::new(-2.2, -0.9, 0.3), Vec3::new(2.2, 0.9, 1.4), paint))
}

/// A camera on a pole beside the street.
pub(crate) fn site() -> CameraSite {
    CameraSite {
        name: "pole".to_owned(),
        position: [-70.0, -6.0, 7.0],
        yaw_rad: 0.1,
        down_tilt_rad: 0.25,
        horizontal_fov_rad: 1.2,
        lens: LensModel::Pinhole,
        mount: Mount::Pole,
        roll_rad: 0.0,
    }
}

/// That camera.
pub(crate) fn camera() -> PinholeCamera {
    PinholeCamera::new(&site(), ImageSize { width: 1280, height: 720 })
}

fn cuboid(low: Vec3, high: Vec3, material: Material) -> Mesh {
    let mut builder = MeshBuilder::new();
    builder.cuboid(low, high, material);
    builder.finish()
}

/// Small triangles at random in a ball.
fn bush() -> Mesh {
    let leaf = Material::new(Surface::Foliage, [0.06, 0.12, 0.03], ClassTag::Vegetation);
    let mut random = Stream::named(2, "bush", &[]);
    let mut builder = MeshBuilder::new();
    for _ in 0..LEAVES {
        let mut corner = |size: f32| Vec3::from_array([0; 3].map(|_| random.range_f32(-size, size)));
        let middle = corner(1.0).clamp_length_max(1.0) + Vec3::Z;
        let corners = [0; 3].map(|_| middle + corner(0.08));
        builder.triangle(corners, [Vec2::ZERO; 3], leaf);
    }
    builder.finish()
}
