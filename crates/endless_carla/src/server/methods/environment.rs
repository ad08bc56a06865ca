//! Weather, and what stands in the world that is no actor.

use crate::frames;
use crate::rpc::Answer;
use crate::server::call::{Call, CallResult, Method, nothing_to_do};
use crate::server::world::World;
use crate::wire::{BoundingBox, EnvironmentObject, Vector3D, WeatherParameters};
use endless_world::{ParkedVehicle, Pose};
use glam::Vec3;

pub(super) const METHODS: &[(&str, Method)] = &[
    ("get_weather_parameters", get_weather_parameters),
    ("set_weather_parameters", set_weather_parameters),
    ("get_imui_gravity", get_imui_gravity),
    ("get_all_level_BBs", get_all_level_boxes),
    ("get_environment_objects", get_environment_objects),
    ("get_names_of_all_objects", get_names_of_all_objects),
    // Pictures are for machines that learn: nothing is drawn into them.
    ("draw_debug_shape", nothing_to_do),
    ("clear_debug_shape", nothing_to_do),
    ("clear_debug_string", nothing_to_do),
];

/// m/s², as CARLA's IMU assumes.
const GRAVITY: f32 = 9.81;

fn get_weather_parameters(world: &mut World, _: &Call<'_>) -> CallResult {
    Ok(Answer::of(&world.episode.weather))
}

fn set_weather_parameters(world: &mut World, call: &Call<'_>) -> CallResult {
    let weather: WeatherParameters = call.request.argument(0)?;
    world.episode.weather = weather;
    Ok(Answer::Void)
}

fn get_imui_gravity(_: &mut World, _: &Call<'_>) -> CallResult {
    Ok(Answer::of(&GRAVITY))
}

/// The class that stands for all.
const ANY: u8 = 255;

/// In the world.
fn get_all_level_boxes(world: &mut World, call: &Call<'_>) -> CallResult {
    let boxes: Vec<BoundingBox> = things(world, call.request.argument(0)?).map(|thing| thing.bounding_box).collect();
    Ok(Answer::of(&boxes))
}

fn get_environment_objects(world: &mut World, call: &Call<'_>) -> CallResult {
    let things: Vec<EnvironmentObject> = things(world, call.request.argument(0)?).collect();
    Ok(Answer::of(&things))
}

/// What of a class stands in the map and is told apart: parked vehicles, by their numbers in pictures.
fn things(world: &World, label: u8) -> impl Iterator<Item = EnvironmentObject> {
    let specs = world.shelf.catalogue().vehicle_specs();
    let parked = &world.episode.map.town.parked;
    let thing = move |(id, vehicle): (u64, &ParkedVehicle)| {
        let spec = specs.get(vehicle.vehicle.model.index())?;
        let own = spec.class.tag().value();
        let pose = Pose { position: vehicle.pose.position + 0.5 * spec.height_m * Vec3::Z, ..vehicle.pose };
        let middle = frames::transform(&pose);
        let extent = Vector3D { x: 0.5 * spec.length_m, y: 0.5 * spec.width_m, z: 0.5 * spec.height_m };
        let bounding_box =
            BoundingBox { location: middle.location.clone(), extent, rotation: middle.rotation, actor_id: 0 };
        let transform = frames::transform(&vehicle.pose);
        let name = format!("{}_{id}", spec.name);
        (label == ANY || label == own).then_some(EnvironmentObject { transform, bounding_box, id, name, label: own })
    };
    (1..).zip(parked).filter_map(thing)
}

fn get_names_of_all_objects(_: &mut World, _: &Call<'_>) -> CallResult {
    Ok(Answer::of(&Vec::<String>::new()))
}
