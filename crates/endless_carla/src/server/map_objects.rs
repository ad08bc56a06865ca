//! What stands in a map and can be told apart: CARLA's environment objects.

use super::map_layer::MapLayer;
use crate::frames;
use crate::wire::{BoundingBox, EnvironmentObject, Vector3D};
use endless_asset::Catalogue;
use endless_city::TownThing;
use endless_scene::Mesh;
use endless_town::{PlacedObject, Placement, Town};
use endless_world::{ClassTag, ParkedVehicle, Pose};
use glam::{Affine3A, DMat3, DQuat, Vec3, Vec3A};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Numbers of things that are no vehicles begin here; vehicles have those that they have in pictures.
const FIRST_THING: u64 = 1_000_000;
/// Numbers that a thing has for its parts of different classes.
const PARTS: u64 = 32;
/// A mesh that is larger, metres, is no thing: the ground, or all wires and garden paths of a town.
const LARGEST_M: f32 = 250.0;

/// Smallest and largest corner of the parts of a mesh, by their classes.
type Parts = Vec<(ClassTag, [Vec3; 2])>;

/// A thing of a map, or those of its parts that are of one class.
#[derive(Debug, Clone)]
pub(super) struct MapObject {
    pub(super) told: EnvironmentObject,
    pub(super) thing: TownThing,
    pub(super) class: ClassTag,
    /// The layer that it is of; none if it is of none.
    pub(super) layer: Option<MapLayer>,
}

/// The things of a town, the same every time: parked vehicles, then buildings, plants and street furniture, each once for every
/// class that it has parts of (a pole, and the lights on it). Boxes are in the world.
pub(super) fn map_objects(town: &Town, catalogue: &Catalogue) -> Vec<MapObject> {
    let kinds: BTreeSet<PlacedObject> = town.placements.iter().map(|placement| placement.object).collect();
    let parts_of = |object: PlacedObject| {
        let parts = match object {
            PlacedObject::TownMesh(mesh) => town.meshes.get(mesh as usize).map_or_else(Parts::new, |mesh| parts(mesh)),
            PlacedObject::Prop(prop, variant) => parts(&catalogue.prop(prop, variant)),
        };
        (object, parts)
    };
    let known: BTreeMap<PlacedObject, Parts> = kinds.into_par_iter().map(parts_of).collect();
    let mut objects = parked_vehicles(town, catalogue);
    for (number, placement) in (0..).zip(&town.placements) {
        let parts = known.get(&placement.object).into_iter().flatten();
        objects.extend(parts.map(|(class, corners)| thing(number, placement, *class, corners)));
    }
    objects
}

/// The boxes of a mesh's parts; none if it is no thing.
fn parts(mesh: &Mesh) -> Parts {
    let mut found: BTreeMap<ClassTag, [Vec3; 2]> = BTreeMap::new();
    for (corners, &material) in mesh.triangles.iter().zip(&mesh.triangle_materials) {
        let Some(material) = mesh.materials.get(usize::from(material)) else { continue };
        for &corner in corners {
            let Some(&place) = mesh.positions.get(corner as usize) else { continue };
            let [low, high] = found.entry(material.tag).or_insert([place; 2]);
            (*low, *high) = (low.min(place), high.max(place));
        }
    }
    let is_thing = |[low, high]: &[Vec3; 2]| (high - low).truncate().length() < LARGEST_M;
    found.into_iter().filter(|(_, corners)| is_thing(corners)).collect()
}

fn thing(number: u32, placement: &Placement, class: ClassTag, [low, high]: &[Vec3; 2]) -> MapObject {
    let world = &placement.world_from_object;
    let scale = Vec3::from_array([world.matrix3.x_axis, world.matrix3.y_axis, world.matrix3.z_axis].map(Vec3A::length));
    let rotation = frames::rotation(turn(world));
    let half = 0.5 * (high - low) * scale;
    let middle = world.transform_point3(0.5 * (low + high));
    let bounding_box = BoundingBox {
        location: frames::to_carla(middle),
        extent: Vector3D { x: half.x, y: half.y, z: half.z },
        rotation: rotation.clone(),
        actor_id: 0,
    };
    let transform = crate::wire::Transform { location: frames::to_carla(world.translation.into()), rotation };
    let what = match placement.object {
        PlacedObject::TownMesh(_) => "building",
        PlacedObject::Prop(prop, _) => prop.name(),
    };
    let name = format!("{what}_{number}_{}", class.name());
    let id = FIRST_THING + u64::from(number) * PARTS + u64::from(class.value());
    let told = EnvironmentObject { transform, bounding_box, id, name, label: class.value() };
    MapObject { told, thing: TownThing::Placed(number), class, layer: MapLayer::of(placement.object, class) }
}

/// How a placed thing is turned; one that is mirrored is as if it were not.
fn turn(world: &Affine3A) -> DQuat {
    let axes = [world.matrix3.x_axis, world.matrix3.y_axis, world.matrix3.z_axis];
    let [x, y, z] = axes.map(|axis| axis.as_dvec3().normalize_or_zero());
    let y = if x.cross(y).dot(z) < 0.0 { -y } else { y };
    DQuat::from_mat3(&DMat3::from_cols(x, y, z))
}

/// By their numbers in pictures.
fn parked_vehicles(town: &Town, catalogue: &Catalogue) -> Vec<MapObject> {
    let specs = catalogue.vehicle_specs();
    let vehicle = |(number, vehicle): (u32, &ParkedVehicle)| {
        let id = u64::from(number) + 1;
        let spec = specs.get(vehicle.vehicle.model.index())?;
        let pose = Pose { position: vehicle.pose.position + 0.5 * spec.height_m * Vec3::Z, ..vehicle.pose };
        let middle = frames::transform(&pose);
        let extent = Vector3D { x: 0.5 * spec.length_m, y: 0.5 * spec.width_m, z: 0.5 * spec.height_m };
        let bounding_box =
            BoundingBox { location: middle.location.clone(), extent, rotation: middle.rotation, actor_id: 0 };
        let transform = frames::transform(&vehicle.pose);
        let name = format!("{}_{id}", spec.name);
        let class = spec.class.tag();
        let told = EnvironmentObject { transform, bounding_box, id, name, label: class.value() };
        Some(MapObject { told, thing: TownThing::Parked(number), class, layer: Some(MapLayer::ParkedVehicles) })
    };
    (0..).zip(&town.parked).filter_map(vehicle).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::Transform;

    #[test]
    fn boxes_hold_what_they_are_of() {
        let catalogue = Catalogue::builtin();
        let town = endless_town::load("Town02", &catalogue).expect("a town");
        let objects = map_objects(&town, &catalogue);
        let of_layer = |layer: MapLayer| objects.iter().filter(|object| object.layer == Some(layer)).count();
        for layer in [MapLayer::Buildings, MapLayer::Foliage, MapLayer::Props, MapLayer::StreetLights, MapLayer::Walls]
        {
            assert!(of_layer(layer) > 5, "{layer:?}: {}", of_layer(layer));
        }
        assert_eq!(of_layer(MapLayer::ParkedVehicles), town.parked.len());
        let objects: Vec<EnvironmentObject> = objects.into_iter().map(|object| object.told).collect();
        let ids: BTreeSet<u64> = objects.iter().map(|object| object.id).collect();
        assert_eq!(ids.len(), objects.len());
        let count = |class: ClassTag| objects.iter().filter(|object| object.label == class.value()).count();
        for class in [ClassTag::Buildings, ClassTag::Vegetation, ClassTag::Poles, ClassTag::TrafficLight, ClassTag::Car]
        {
            assert!(count(class) > 10, "{}: {}", class.name(), count(class));
        }
        // Roads and lawns are no things.
        let extent = |object: &EnvironmentObject| object.bounding_box.extent.x.hypot(object.bounding_box.extent.y);
        assert!(objects.iter().all(|object| extent(object) < LARGEST_M));
        for (number, placement) in (0u64..).zip(&town.placements).step_by(7) {
            let PlacedObject::Prop(prop, variant) = placement.object else { continue };
            let mesh = catalogue.prop(prop, variant);
            let own = |object: &&EnvironmentObject| (object.id.saturating_sub(FIRST_THING)) / PARTS == number;
            let boxes: Vec<&BoundingBox> =
                objects.iter().filter(|o| o.id >= FIRST_THING).filter(own).map(|object| &object.bounding_box).collect();
            assert!(!boxes.is_empty(), "{}", prop.name());
            for &place in mesh.positions.iter().step_by(5) {
                let place = Transform {
                    location: frames::to_carla(placement.world_from_object.transform_point3(place)),
                    ..Transform::default()
                };
                let holds = |bounds: &&BoundingBox| {
                    let middle = Transform { location: bounds.location.clone(), rotation: bounds.rotation.clone() };
                    let local = frames::detached(&middle, &place).location;
                    let (e, more) = (&bounds.extent, 0.01);
                    local.x.abs() < e.x + more && local.y.abs() < e.y + more && local.z.abs() < e.z + more
                };
                assert!(boxes.iter().any(holds), "{} {place:?} {boxes:?}", prop.name());
            }
        }
    }
}
