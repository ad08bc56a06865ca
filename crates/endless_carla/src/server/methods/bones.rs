//! Bones and components of actors.

use crate::frames;
use crate::rpc::Answer;
use crate::server::actor::Body;
use crate::server::call::{Call, CallResult, Method};
use crate::server::call_error::CallError;
use crate::server::walker_bones::bone_names;
use crate::server::world::World;
use crate::wire::{BoneTransform, Location, Rotation, Transform, WalkerBones, WalkerBonesControl};

pub(super) const METHODS: &[(&str, Method)] = &[
    ("get_bones_transform", get_bones_transform),
    ("set_bones_transform", set_bones_transform),
    ("blend_pose", blend_pose),
    ("get_pose_from_animation", get_pose_from_animation),
    ("get_actor_component_names", get_actor_component_names),
    ("get_actor_component_world_transform", get_actor_component_world_transform),
    ("get_actor_component_relative_transform", get_actor_component_relative_transform),
    ("get_actor_bone_names", get_actor_bone_names),
    ("get_actor_bone_world_transforms", get_actor_bone_world_transforms),
    ("get_actor_bone_relative_transforms", get_actor_bone_relative_transforms),
    ("get_vehicle_bone_world_transforms", get_actor_bone_world_transforms),
    // Nothing has sockets: what is attached names none.
    ("get_actor_socket_names", no_names),
    ("get_actor_socket_world_transforms", no_transforms),
    ("get_actor_socket_relative_transforms", no_transforms),
];

/// A vehicle's bones: itself, and its wheels in the order of its physics.
const VEHICLE_BONES: [&str; 5] =
    ["Vehicle_Base", "Wheel_Front_Left", "Wheel_Front_Right", "Wheel_Rear_Left", "Wheel_Rear_Right"];
/// Where a vehicle's lamps are in its box, as shares of half its size: ahead, to the right, up.
const LAMPS: [(&str, [f32; 3]); 4] = [
    ("front-blinker-l-1", [0.95, -0.85, -0.15]),
    ("front-blinker-r-1", [0.95, 0.85, -0.15]),
    ("back-blinker-l-1", [-0.98, -0.85, -0.05]),
    ("back-blinker-r-1", [-0.98, 0.85, -0.05]),
];

/// A walker's bones.
fn bones_of_walker(world: &World, id: u32) -> Result<Vec<BoneTransform>, CallError> {
    let actor = world.episode.actor(id)?;
    let Body::Walker(walker) = &actor.body else {
        return Err(CallError::refused(format!("actor {id} is not a walker")));
    };
    let anatomy = world.shelf.catalogue().anatomy(walker.asset);
    let motion = walker.motion(world.episode.elapsed_s);
    Ok(walker.pose.bones(&anatomy, &motion, &walker.on_ground(&actor.transform)))
}

fn get_bones_transform(world: &mut World, call: &Call<'_>) -> CallResult {
    Ok(Answer::of(&WalkerBones { bones: bones_of_walker(world, call.request.argument(0)?)? }))
}

fn set_bones_transform(world: &mut World, call: &Call<'_>) -> CallResult {
    let bones: WalkerBonesControl = call.request.argument(1)?;
    world.episode.walker(call.request.argument(0)?)?.pose.set(&bones.bones);
    Ok(Answer::Void)
}

fn blend_pose(world: &mut World, call: &Call<'_>) -> CallResult {
    world.episode.walker(call.request.argument(0)?)?.pose.blend(call.request.argument(1)?);
    Ok(Answer::Void)
}

fn get_pose_from_animation(world: &mut World, call: &Call<'_>) -> CallResult {
    let now_s = world.episode.elapsed_s;
    let walker = world.episode.walker(call.request.argument(0)?)?;
    let anatomy = world.shelf.catalogue().anatomy(walker.asset);
    let motion = walker.motion(now_s);
    walker.pose.take(&anatomy, &motion);
    Ok(Answer::Void)
}

/// The components of an actor, and where they are on it.
fn components(world: &World, id: u32) -> Result<Vec<(String, Transform)>, CallError> {
    let actor = world.episode.actor(id)?;
    let bounds = &actor.told.bounding_box;
    let own = |name: &str, location: Location| (name.to_owned(), Transform { location, ..Transform::default() });
    Ok(match &actor.body {
        Body::Vehicle(_) => {
            let (m, e) = (&bounds.location, &bounds.extent);
            let lamp = |(name, [x, y, z]): (&str, [f32; 3])| {
                own(name, Location { x: m.x + x * e.x, y: m.y + y * e.y, z: m.z + z * e.z })
            };
            std::iter::once(own("VehicleMesh", Location::default())).chain(LAMPS.map(lamp)).collect()
        }
        Body::Walker(walker) => {
            let ground = walker.on_ground(&actor.transform);
            let below = Location { z: ground.location.z - actor.transform.location.z, ..Location::default() };
            vec![own("CharacterMesh0", below)]
        }
        _ => vec![own("RootComponent", Location::default())],
    })
}

fn get_actor_component_names(world: &mut World, call: &Call<'_>) -> CallResult {
    let components = components(world, call.request.argument(0)?)?;
    Ok(Answer::of(&components.into_iter().map(|(name, _)| name).collect::<Vec<_>>()))
}

fn component(world: &World, call: &Call<'_>) -> Result<Transform, CallError> {
    let (id, wanted): (u32, String) = (call.request.argument(0)?, call.request.argument(1)?);
    let found = components(world, id)?.into_iter().find(|(name, _)| *name == wanted);
    let missing = || CallError::refused(format!("actor {id} has no component '{wanted}'"));
    found.map(|(_, transform)| transform).ok_or_else(missing)
}

fn get_actor_component_relative_transform(world: &mut World, call: &Call<'_>) -> CallResult {
    Ok(Answer::of(&component(world, call)?))
}

fn get_actor_component_world_transform(world: &mut World, call: &Call<'_>) -> CallResult {
    let own = component(world, call)?;
    let actor = world.episode.actor(call.request.argument(0)?)?;
    Ok(Answer::of(&frames::attached(&actor.transform, &own)))
}

/// The bones of an actor: their names, where they are in the world, and on their parents.
fn bones(world: &World, id: u32) -> Result<Vec<BoneTransform>, CallError> {
    let actor = world.episode.actor(id)?;
    let Body::Vehicle(vehicle) = &actor.body else {
        return if matches!(actor.body, Body::Walker(_)) { bones_of_walker(world, id) } else { Ok(Vec::new()) };
    };
    let base = &actor.transform;
    let mut places = vec![base.clone()];
    for (number, wheel) in (0..).zip(vehicle.physics_control().wheels) {
        let Location { x, y, z } = wheel.position;
        let Rotation { pitch, yaw, roll } = base.rotation;
        let location = Location { x: 0.01 * x, y: 0.01 * y, z: 0.01 * z };
        let yaw = yaw + vehicle.wheel_steer_deg(number);
        places.push(Transform { location, rotation: Rotation { pitch, yaw, roll } });
    }
    let bone = |(number, (name, world)): (usize, (&str, Transform))| {
        let component = frames::detached(base, &world);
        let relative = if number == 0 { Transform::default() } else { component.clone() };
        BoneTransform { name: name.to_owned(), world, component, relative }
    };
    Ok(VEHICLE_BONES.into_iter().zip(places).enumerate().map(bone).collect())
}

fn get_actor_bone_names(world: &mut World, call: &Call<'_>) -> CallResult {
    let id = call.request.argument(0)?;
    let names = match world.episode.actor(id)?.body {
        Body::Walker(_) => bone_names(),
        _ => bones(world, id)?.into_iter().map(|bone| bone.name).collect(),
    };
    Ok(Answer::of(&names))
}

fn get_actor_bone_world_transforms(world: &mut World, call: &Call<'_>) -> CallResult {
    let bones = bones(world, call.request.argument(0)?)?;
    Ok(Answer::of(&bones.into_iter().map(|bone| bone.world).collect::<Vec<_>>()))
}

fn get_actor_bone_relative_transforms(world: &mut World, call: &Call<'_>) -> CallResult {
    let bones = bones(world, call.request.argument(0)?)?;
    Ok(Answer::of(&bones.into_iter().map(|bone| bone.relative).collect::<Vec<_>>()))
}

fn no_names(world: &mut World, call: &Call<'_>) -> CallResult {
    world.episode.actor(call.request.argument(0)?)?;
    Ok(Answer::of(&Vec::<String>::new()))
}

fn no_transforms(world: &mut World, call: &Call<'_>) -> CallResult {
    world.episode.actor(call.request.argument(0)?)?;
    Ok(Answer::of(&Vec::<Transform>::new()))
}
