//! Weather, and what stands in the world that is no actor.

use crate::rpc::Answer;
use crate::server::call::{Call, CallResult, Method, nothing_to_do};
use crate::server::map_objects::MapObject;
use crate::server::weather::is_night;
use crate::server::world::World;
use crate::wire::{BoundingBox, EnvironmentObject, WeatherParameters};

pub(super) const METHODS: &[(&str, Method)] = &[
    ("get_weather_parameters", get_weather_parameters),
    ("set_weather_parameters", set_weather_parameters),
    ("get_imui_gravity", get_imui_gravity),
    ("get_all_level_BBs", get_all_level_boxes),
    ("get_environment_objects", get_environment_objects),
    ("enable_environment_objects", enable_environment_objects),
    ("get_names_of_all_objects", get_names_of_all_objects),
    ("apply_color_texture_to_objects", nothing_to_do),
    ("apply_float_color_texture_to_objects", nothing_to_do),
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
    world.episode.lamps.set_night(is_night(&weather));
    world.episode.weather = weather;
    Ok(Answer::Void)
}

fn get_imui_gravity(_: &mut World, _: &Call<'_>) -> CallResult {
    Ok(Answer::of(&GRAVITY))
}

/// The class that stands for all.
const ANY: u8 = 255;

/// In the world, of those that are seen.
fn get_all_level_boxes(world: &mut World, call: &Call<'_>) -> CallResult {
    let things = things(world, call.request.argument(0)?).filter(|thing| world.episode.scenery.shows(thing));
    let boxes: Vec<BoundingBox> = things.map(|thing| thing.told.bounding_box.clone()).collect();
    Ok(Answer::of(&boxes))
}

/// Hidden ones, too, so that they can be shown again.
fn get_environment_objects(world: &mut World, call: &Call<'_>) -> CallResult {
    let things: Vec<EnvironmentObject> =
        things(world, call.request.argument(0)?).map(|thing| thing.told.clone()).collect();
    Ok(Answer::of(&things))
}

fn enable_environment_objects(world: &mut World, call: &Call<'_>) -> CallResult {
    let (numbers, enabled): (Vec<u64>, bool) = (call.request.argument(0)?, call.request.argument(1)?);
    world.episode.scenery.enable(&numbers, enabled);
    Ok(Answer::Void)
}

/// What of a class stands in the loaded layers of the map.
fn things(world: &World, label: u8) -> impl Iterator<Item = &MapObject> {
    let things = world.episode.scenery.things(world.shelf.catalogue());
    things.filter(move |thing| label == ANY || label == thing.told.label)
}

/// Their names, by which textures would be given to them.
fn get_names_of_all_objects(world: &mut World, _: &Call<'_>) -> CallResult {
    let names: Vec<String> = things(world, ANY).map(|thing| thing.told.name.clone()).collect();
    Ok(Answer::of(&names))
}
