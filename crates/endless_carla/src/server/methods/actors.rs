//! Blueprints; actors that come, go and are put elsewhere.

use crate::rpc::Answer;
use crate::server::call::{Call, CallResult, Method, nothing_to_do};
use crate::server::spring_arm::SpringArm;
use crate::server::world::World;
use crate::wire::{Actor, ActorDescription, BoundingBox, Location, Transform};

pub(super) const METHODS: &[(&str, Method)] = &[
    ("get_actor_definitions", get_actor_definitions),
    ("get_spectator", get_spectator),
    ("get_actors_by_id", get_actors_by_id),
    ("get_actor_bounding_box", get_actor_bounding_box),
    ("spawn_actor", spawn_actor),
    ("spawn_actor_with_parent", spawn_actor_with_parent),
    ("destroy_actor", destroy_actor),
    ("set_actor_transform", set_actor_transform),
    ("set_actor_location", set_actor_location),
    ("set_actor_dead", nothing_to_do),
];

fn get_actor_definitions(world: &mut World, _: &Call<'_>) -> CallResult {
    Ok(Answer::of(&world.blueprints.definitions().to_vec()))
}

fn get_spectator(world: &mut World, _: &Call<'_>) -> CallResult {
    let id = world.episode.spectator;
    Ok(Answer::of(&world.episode.actor(id)?.told))
}

/// Those that are not there are left out.
fn get_actors_by_id(world: &mut World, call: &Call<'_>) -> CallResult {
    let ids: Vec<u32> = call.request.argument(0)?;
    let told: Vec<Actor> = ids.iter().filter_map(|id| Some(world.episode.actors.get(id)?.told.clone())).collect();
    Ok(Answer::of(&told))
}

fn get_actor_bounding_box(world: &mut World, call: &Call<'_>) -> CallResult {
    let id = call.request.argument(0)?;
    let own = match world.episode.has_gone(id) {
        true => BoundingBox::default(),
        false => world.episode.actor(id)?.told.bounding_box.clone(),
    };
    Ok(Answer::of(&BoundingBox { actor_id: id, ..own }))
}

fn spawn_actor(world: &mut World, call: &Call<'_>) -> CallResult {
    let description: ActorDescription = call.request.argument(0)?;
    let transform: Transform = call.request.argument(1)?;
    let id = world.spawn(&description, transform, None)?;
    Ok(Answer::of(&world.episode.actor(id)?.told))
}

/// Attached to another one, rigidly or on a spring arm.
fn spawn_actor_with_parent(world: &mut World, call: &Call<'_>) -> CallResult {
    let description: ActorDescription = call.request.argument(0)?;
    let transform: Transform = call.request.argument(1)?;
    let (parent, attachment): (u32, u8) = (call.request.argument(2)?, call.request.optional(3)?);
    let id = world.spawn(&description, transform, Some(parent))?;
    world.episode.hang(id, SpringArm::of_attachment(attachment));
    Ok(Answer::of(&world.episode.actor(id)?.told))
}

fn destroy_actor(world: &mut World, call: &Call<'_>) -> CallResult {
    Ok(Answer::of(&world.destroy(call.request.argument(0)?)))
}

fn set_actor_transform(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, transform): (u32, Transform) = (call.request.argument(0)?, call.request.argument(1)?);
    world.episode.put(id, transform)?;
    Ok(Answer::Void)
}

fn set_actor_location(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, location): (u32, Location) = (call.request.argument(0)?, call.request.argument(1)?);
    let rotation = world.episode.actor(id)?.transform.rotation.clone();
    world.episode.put(id, Transform { location, rotation })?;
    Ok(Answer::Void)
}
