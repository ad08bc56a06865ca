//! Maps and the files that come with them.

use crate::rpc::Answer;
use crate::server::call::{Call, CallResult, Method, nothing_to_do};
use crate::server::call_error::CallError;
use crate::server::world::World;
use crate::wire::{Bytes, LightState, MapInfo};

pub(super) const METHODS: &[(&str, Method)] = &[
    ("get_map_info", get_map_info),
    ("get_map_data", get_map_data),
    ("get_available_maps", get_available_maps),
    ("get_required_files", get_required_files),
    ("request_file", request_file),
    ("get_navigation_mesh", get_navigation_mesh),
    ("load_map_layer", load_map_layer),
    ("unload_map_layer", unload_map_layer),
    ("query_lights_state", query_lights_state),
    ("update_lights_state", update_lights_state),
    ("update_day_night_cycle", nothing_to_do),
];

fn get_map_info(world: &mut World, _: &Call<'_>) -> CallResult {
    let map = &world.episode.map;
    let name = format!("Carla/Maps/{}", world.episode.map_name);
    Ok(Answer::of(&MapInfo { name, recommended_spawn_points: map.roads.spawn_points().to_vec() }))
}

fn get_map_data(world: &mut World, _: &Call<'_>) -> CallResult {
    Ok(Answer::Value(world.episode.map.roads.opendrive().into()))
}

fn get_available_maps(world: &mut World, _: &Call<'_>) -> CallResult {
    Ok(Answer::of(&world.shelf.names()))
}

/// Clients cache files by name for ever: the name of a mesh tells its content.
fn get_required_files(world: &mut World, call: &Call<'_>) -> CallResult {
    let folder: String = call.request.argument(0)?;
    let mesh = world.episode.map.roads.navigation().filter(|_| folder == "Nav");
    Ok(Answer::of(&Vec::from_iter(mesh.map(|mesh| mesh.file_name.clone()))))
}

fn request_file(world: &mut World, call: &Call<'_>) -> CallResult {
    let name: String = call.request.argument(0)?;
    match world.episode.map.roads.navigation().filter(|mesh| mesh.file_name == name) {
        Some(mesh) => Ok(Answer::of(&Bytes(mesh.bytes.clone()))),
        None => Err(CallError::refused(format!("there is no file '{name}'"))),
    }
}

fn get_navigation_mesh(world: &mut World, _: &Call<'_>) -> CallResult {
    let mesh = world.episode.map.roads.navigation();
    Ok(Answer::of(&Bytes(mesh.map_or_else(Vec::new, |mesh| mesh.bytes.clone()))))
}

fn load_map_layer(world: &mut World, call: &Call<'_>) -> CallResult {
    world.episode.set_layers(call.request.argument(0)?, true);
    Ok(Answer::Void)
}

fn unload_map_layer(world: &mut World, call: &Call<'_>) -> CallResult {
    world.episode.set_layers(call.request.argument(0)?, false);
    Ok(Answer::Void)
}

fn query_lights_state(world: &mut World, _: &Call<'_>) -> CallResult {
    Ok(Answer::of(&world.episode.lamps.states()))
}

/// All clients ask for the lamps after the next snapshot, the one that has set them, too.
fn update_lights_state(world: &mut World, call: &Call<'_>) -> CallResult {
    let states: Vec<LightState> = call.request.argument(1)?;
    world.episode.lamps.set(&states);
    Ok(Answer::Void)
}
