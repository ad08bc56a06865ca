//! How vehicles and people are moved.

use crate::rpc::Answer;
use crate::server::call::{Call, CallResult, Method, nothing_to_do};
use crate::server::call_error::CallError;
use crate::server::moving::Push;
use crate::server::world::World;
use crate::wire::{
    AckermannControllerSettings, Vector3D, VehicleAckermannControl, VehicleControl, VehiclePhysicsControl,
    WalkerControl, Wire,
};

pub(super) const METHODS: &[(&str, Method)] = &[
    ("apply_control_to_vehicle", apply_control_to_vehicle),
    ("apply_ackermann_control_to_vehicle", apply_ackermann_control_to_vehicle),
    ("get_ackermann_controller_settings", get_ackermann_controller_settings),
    ("apply_ackermann_controller_settings", apply_ackermann_controller_settings),
    ("apply_control_to_walker", apply_control_to_walker),
    ("get_physics_control", get_physics_control),
    ("apply_physics_control", apply_physics_control),
    ("get_telemetry_data", get_telemetry_data),
    ("show_vehicle_debug_telemetry", nothing_to_do),
    ("set_actor_simulate_physics", set_actor_simulate_physics),
    ("set_actor_enable_gravity", set_actor_enable_gravity),
    ("set_actor_collisions", set_actor_collisions),
    ("set_actor_autopilot", nothing_to_do),
    ("set_actor_target_velocity", set_actor_target_velocity),
    ("set_actor_target_angular_velocity", set_actor_target_angular_velocity),
    ("enable_actor_constant_velocity", enable_actor_constant_velocity),
    ("disable_actor_constant_velocity", disable_actor_constant_velocity),
    ("add_actor_impulse", add_actor_impulse),
    ("add_actor_force", add_actor_force),
    ("add_actor_angular_impulse", add_actor_angular_impulse),
    ("add_actor_torque", add_actor_torque),
    ("add_actor_impulse_at_location", add_actor_impulse_at_location),
    ("add_actor_force_at_location", add_actor_force_at_location),
    ("get_vehicle_light_state", get_vehicle_light_state),
    ("set_vehicle_light_state", set_vehicle_light_state),
    ("get_vehicle_light_states", get_vehicle_light_states),
    ("open_vehicle_door", turn_vehicle_door),
    ("close_vehicle_door", turn_vehicle_door),
    ("get_wheel_steer_angle", get_wheel_steer_angle),
    ("set_wheel_steer_direction", set_wheel_steer_direction),
    ("get_wheel_pitch_angle", get_wheel_pitch_angle),
    ("set_wheel_pitch_angle", set_wheel_pitch_angle),
];

/// Whom it is about, and what.
fn two<A: Wire, B: Wire>(call: &Call<'_>) -> Result<(A, B), CallError> {
    Ok((call.request.argument(0)?, call.request.argument(1)?))
}

/// A door is accepted where CARLA accepts it, and stays shut: nothing that a server tells says whether it is open.
fn turn_vehicle_door(world: &mut World, call: &Call<'_>) -> CallResult {
    /// CARLA's number of all doors together.
    const ALL: u8 = 6;
    let (id, door): (u32, u8) = two(call)?;
    world.episode.vehicle(id)?;
    if door > ALL {
        return Err(CallError::refused(format!("vehicles have doors 0 to {ALL}, not {door}")));
    }
    Ok(Answer::Void)
}

fn apply_control_to_vehicle(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, control): (u32, VehicleControl) = two(call)?;
    world.episode.vehicle(id)?.apply_control(&control);
    Ok(Answer::Void)
}

fn apply_ackermann_control_to_vehicle(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, control): (u32, VehicleAckermannControl) = two(call)?;
    world.episode.vehicle(id)?.apply_ackermann(&control);
    Ok(Answer::Void)
}

fn get_ackermann_controller_settings(world: &mut World, call: &Call<'_>) -> CallResult {
    Ok(Answer::of(&world.episode.vehicle(call.request.argument(0)?)?.ackermann_settings()))
}

fn apply_ackermann_controller_settings(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, settings): (u32, AckermannControllerSettings) = two(call)?;
    world.episode.vehicle(id)?.set_ackermann_settings(&settings);
    Ok(Answer::Void)
}

fn apply_control_to_walker(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, control): (u32, WalkerControl) = two(call)?;
    world.episode.walker(id)?.apply_control(&control);
    Ok(Answer::Void)
}

fn get_physics_control(world: &mut World, call: &Call<'_>) -> CallResult {
    Ok(Answer::of(&world.episode.vehicle(call.request.argument(0)?)?.physics_control()))
}

fn apply_physics_control(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, control): (u32, VehiclePhysicsControl) = two(call)?;
    world.episode.vehicle(id)?.set_physics_control(&control);
    Ok(Answer::Void)
}

fn get_telemetry_data(world: &mut World, call: &Call<'_>) -> CallResult {
    Ok(Answer::of(&world.episode.vehicle(call.request.argument(0)?)?.telemetry()))
}

fn set_actor_simulate_physics(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, on) = two(call)?;
    if !world.episode.has_gone(id) {
        world.episode.simulate_physics(id, on)?;
    }
    Ok(Answer::Void)
}

fn set_actor_enable_gravity(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, on) = two(call)?;
    world.episode.enable_gravity(id, on)?;
    Ok(Answer::Void)
}

fn set_actor_collisions(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, on) = two(call)?;
    world.episode.enable_collisions(id, on)?;
    Ok(Answer::Void)
}

fn set_actor_target_velocity(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, velocity): (u32, Vector3D) = two(call)?;
    world.episode.set_target_velocity(id, &velocity)?;
    Ok(Answer::Void)
}

fn set_actor_target_angular_velocity(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, velocity): (u32, Vector3D) = two(call)?;
    world.episode.set_target_angular_velocity(id, &velocity)?;
    Ok(Answer::Void)
}

fn enable_actor_constant_velocity(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, velocity): (u32, Vector3D) = two(call)?;
    world.episode.vehicle(id)?.hold_velocity(Some(&velocity));
    Ok(Answer::Void)
}

fn disable_actor_constant_velocity(world: &mut World, call: &Call<'_>) -> CallResult {
    world.episode.vehicle(call.request.argument(0)?)?.hold_velocity(None);
    Ok(Answer::Void)
}

/// Knocks or pushes an actor.
fn push(world: &mut World, call: &Call<'_>, push: Push) -> CallResult {
    let (id, vector): (u32, Vector3D) = two(call)?;
    world.episode.push(id, &vector, push)?;
    Ok(Answer::Void)
}

fn add_actor_impulse(world: &mut World, call: &Call<'_>) -> CallResult {
    push(world, call, Push::Impulse)
}

fn add_actor_force(world: &mut World, call: &Call<'_>) -> CallResult {
    push(world, call, Push::Force)
}

fn add_actor_angular_impulse(world: &mut World, call: &Call<'_>) -> CallResult {
    push(world, call, Push::AngularImpulse)
}

fn add_actor_torque(world: &mut World, call: &Call<'_>) -> CallResult {
    push(world, call, Push::Torque)
}

/// Knocks or pushes an actor at a place in the world.
fn push_at(world: &mut World, call: &Call<'_>, push: Push) -> CallResult {
    let (id, vector): (u32, Vector3D) = two(call)?;
    world.episode.push_at(id, &vector, &call.request.argument(2)?, push)?;
    Ok(Answer::Void)
}

fn add_actor_impulse_at_location(world: &mut World, call: &Call<'_>) -> CallResult {
    push_at(world, call, Push::Impulse)
}

fn add_actor_force_at_location(world: &mut World, call: &Call<'_>) -> CallResult {
    push_at(world, call, Push::Force)
}

fn get_vehicle_light_state(world: &mut World, call: &Call<'_>) -> CallResult {
    Ok(Answer::of(&vec![world.episode.vehicle(call.request.argument(0)?)?.lights()]))
}

/// The flags come in an array of one.
fn set_vehicle_light_state(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, flags): (u32, Vec<u32>) = two(call)?;
    world.episode.vehicle(id)?.set_lights(flags.first().copied().unwrap_or(0));
    Ok(Answer::Void)
}

fn get_vehicle_light_states(world: &mut World, _: &Call<'_>) -> CallResult {
    Ok(Answer::of(&world.episode.light_states()))
}

fn get_wheel_steer_angle(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, wheel): (u32, u8) = two(call)?;
    Ok(Answer::of(&world.episode.vehicle(id)?.wheel_steer_deg(wheel)))
}

fn set_wheel_steer_direction(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, wheel): (u32, u8) = two(call)?;
    world.episode.vehicle(id)?.set_wheel_steer(wheel, call.request.argument(2)?);
    Ok(Answer::Void)
}

fn get_wheel_pitch_angle(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, wheel): (u32, u8) = two(call)?;
    Ok(Answer::of(&world.episode.vehicle(id)?.wheel_pitch_deg(wheel)))
}

fn set_wheel_pitch_angle(world: &mut World, call: &Call<'_>) -> CallResult {
    let (id, wheel): (u32, u8) = two(call)?;
    world.episode.vehicle(id)?.set_wheel_pitch(wheel, call.request.argument(2)?);
    Ok(Answer::Void)
}
