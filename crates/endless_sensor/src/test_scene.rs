//! A street of boxes, whose distances are known without a ray tracer.

use endless_render::{
    Footprint, FrameDescription, FrameScene, Geometry, Instance, MovingObject, RigidVelocity, StaticScene,
};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::{ClassTag, InstanceId};
use glam::{Affine3A, DVec3, Vec2, Vec3};

/// Boxes on the ground, `[low, high]`, repeated every 25 m along the street.
const HOUSES: [[[f64; 3]; 2]; 2] = [[[2.0, 9.0, 0.0], [14.0, 15.0, 9.0]], [[5.0, -16.0, 0.0], [15.0, -8.0, 7.0]]];
const PERIOD_M: f64 = 25.0;
const FIRST: i32 = -8;
const LAST: i32 = 48;
/// What moves.
const CAR: [[f64; 3]; 2] = [[12.0, -2.0, 0.0], [16.0, 0.0, 1.5]];

fn cuboid([low, high]: [Vec3; 2], material: Material) -> Geometry {
    let mut builder = MeshBuilder::new();
    builder.cuboid(low, high, material);
    Geometry::new(builder.finish())
}

fn single(corners: [[f64; 3]; 2]) -> [Vec3; 2] {
    corners.map(|corner| DVec3::from_array(corner).as_vec3())
}

/// All houses.
fn houses() -> impl Iterator<Item = [[f64; 3]; 2]> {
    let shifted = |step: i32| HOUSES.map(|house| house.map(|[x, y, z]| [x + PERIOD_M * f64::from(step), y, z]));
    (FIRST..LAST).flat_map(shifted)
}

/// Level ground with boxes of brick, and a moving box of metal each with its number and velocity.
pub(crate) fn scene_of(
    brick: &[[[f64; 3]; 2]],
    metal: &[([[f64; 3]; 2], InstanceId, RigidVelocity)],
) -> (StaticScene, FrameScene) {
    let asphalt = Material::new(Surface::Asphalt, [0.14; 3], ClassTag::Roads);
    let ground = cuboid([Vec3::new(-2000.0, -2000.0, -1.0), Vec3::new(2000.0, 2000.0, 0.0)], asphalt);
    let bricks = Material::new(Surface::Brick, [0.4, 0.2, 0.1], ClassTag::Buildings);
    let mut instances = vec![Instance::new(&ground, Affine3A::IDENTITY)];
    instances.extend(brick.iter().map(|&house| Instance::new(&cuboid(single(house), bricks), Affine3A::IDENTITY)));
    let paint = Material::new(Surface::CarPaint, [0.5; 3], ClassTag::Static);
    let objects = metal.iter().map(|&(body, id, velocity)| {
        let body = cuboid(single(body), paint);
        let instance = Instance::new(&body, Affine3A::IDENTITY).with_id(id, ClassTag::Car).with_velocity(velocity);
        let footprint =
            Footprint { world_from_object: Affine3A::IDENTITY, ahead_m: 0.0, half_m: Vec2::ONE, height_m: 1.5 };
        MovingObject { instances: vec![instance], footprint }
    });
    let description = FrameDescription { objects: objects.collect(), ..FrameDescription::default() };
    (StaticScene::new(instances, &[]), FrameScene::new(description))
}

/// The street, with one car driving along it at 10 m/s.
pub(crate) fn box_street() -> (StaticScene, FrameScene) {
    let velocity = RigidVelocity { linear_mps: Vec3::X.into(), ..RigidVelocity::ZERO };
    let driving = RigidVelocity { linear_mps: velocity.linear_mps * 10.0, ..velocity };
    scene_of(&houses().collect::<Vec<_>>(), &[(CAR, InstanceId(7), driving)])
}

/// Distance along a ray of unit length to the nearest of the street's surfaces, by its planes.
pub(crate) fn distance(origin: DVec3, direction: DVec3) -> Option<f64> {
    distance_past(origin, direction, 0.0)
}

/// The same, where boxes are this much smaller on every side.
pub(crate) fn distance_past(origin: DVec3, direction: DVec3, margin_m: f64) -> Option<f64> {
    let ground = (direction.z < 0.0).then(|| -origin.z / direction.z);
    let boxes = houses().chain([CAR]).filter_map(|corners| {
        let [low, high] = corners.map(DVec3::from_array);
        let [low, high] = [low + margin_m, high - margin_m];
        let (a, b) = ((low - origin) / direction, (high - origin) / direction);
        let (near, far) = (a.min(b).max_element(), a.max(b).min_element());
        (near > 0.0 && near <= far).then_some(near)
    });
    boxes.chain(ground).min_by(f64::total_cmp)
}
