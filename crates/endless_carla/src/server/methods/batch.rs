//! Many commands in one request.

use crate::rpc::{Answer, failure, success};
use crate::server::call::{Call, CallResult, Method};
use crate::server::call_error::CallError;
use crate::server::moving::Push;
use crate::server::world::World;
use crate::wire::{Command, SpawnActor, Transform, Wire, WireError};
use rmpv::Value;

pub(super) const METHODS: &[(&str, Method)] = &[("apply_batch", apply_batch)];

/// One answer a command: the number of its actor, or why it failed. The answers are not wrapped as one.
fn apply_batch(world: &mut World, call: &Call<'_>) -> CallResult {
    let commands: Vec<Value> = call.request.argument::<Commands>(0)?.0;
    let do_tick: bool = call.request.argument(1)?;
    let answer = |command: &Value| match Command::from_value(command).map_err(CallError::from) {
        Ok(command) => match world.obey(&command, None) {
            Ok(actor) => success(Value::from(actor)),
            Err(error) => failure(&error.to_string()),
        },
        Err(error) => failure(&error.to_string()),
    };
    let answers: Vec<Value> = commands.iter().map(answer).collect();
    if do_tick {
        world.tick(call.caller.id);
    }
    Ok(Answer::Bare(Value::Array(answers)))
}

/// Commands that are read one by one: a wrong one does not spoil the others.
struct Commands(Vec<Value>);

impl Wire for Commands {
    fn to_value(&self) -> Value {
        Value::Array(self.0.clone())
    }

    fn from_value(value: &Value) -> Result<Self, WireError> {
        value.as_array().map(|own| Self(own.clone())).ok_or_else(|| WireError::new("commands", value))
    }
}

impl World {
    /// Does what a command says; gives its actor. In what follows a spawn, actor 0 is the new one.
    fn obey(&mut self, command: &Command, new: Option<u32>) -> Result<u32, CallError> {
        let who = |actor: u32| if actor == 0 { new.unwrap_or(0) } else { actor };
        let (episode, id) = (&mut self.episode, command.actor().map_or(0, who));
        match command {
            Command::SpawnActor(spawn) => return self.spawn_and_do(spawn, new),
            Command::DestroyActor { .. } => {
                if !self.destroy(id) {
                    return Err(CallError::no_actor(id));
                }
            }
            Command::ApplyVehicleControl { control, .. } => episode.vehicle(id)?.apply_control(control),
            Command::ApplyVehicleAckermannControl { control, .. } => episode.vehicle(id)?.apply_ackermann(control),
            Command::ApplyWalkerControl { control, .. } => episode.walker(id)?.apply_control(control),
            Command::ApplyVehiclePhysicsControl { physics, .. } => episode.vehicle(id)?.set_physics_control(physics),
            Command::ApplyTransform { transform, .. } => episode.put(id, transform.clone())?,
            Command::ApplyWalkerState { transform, speed, .. } => episode.put_walker(id, transform.clone(), *speed)?,
            Command::ApplyTargetVelocity { velocity, .. } => episode.set_target_velocity(id, velocity)?,
            Command::ApplyTargetAngularVelocity { angular_velocity, .. } => {
                episode.set_target_angular_velocity(id, angular_velocity)?;
            }
            Command::ApplyImpulse { impulse, .. } => episode.push(id, impulse, Push::Impulse)?,
            Command::ApplyForce { force, .. } => episode.push(id, force, Push::Force)?,
            Command::ApplyAngularImpulse { impulse, .. } => episode.push(id, impulse, Push::AngularImpulse)?,
            Command::ApplyTorque { torque, .. } => episode.push(id, torque, Push::Torque)?,
            Command::SetSimulatePhysics { enabled, .. } => episode.simulate_physics(id, *enabled)?,
            Command::SetEnableGravity { enabled, .. } => episode.enable_gravity(id, *enabled)?,
            // The traffic manager, in the client, has been told by the client.
            Command::SetAutopilot { .. } | Command::ShowDebugTelemetry { .. } => drop(episode.actor(id)?),
            Command::SetVehicleLightState { lights, .. } => episode.vehicle(id)?.set_lights(*lights),
            Command::ApplyLocation { location, .. } => {
                let rotation = episode.actor(id)?.transform.rotation.clone();
                episode.put(id, Transform { location: location.clone(), rotation })?;
            }
            Command::ConsoleCommand { .. } => return Err(CallError::refused("there is no console")),
            Command::SetTrafficLightState { state, .. } => episode.set_light_state(id, *state)?,
        }
        Ok(id)
    }

    fn spawn_and_do(&mut self, spawn: &SpawnActor, new: Option<u32>) -> Result<u32, CallError> {
        let parent = spawn.parent.map(|parent| if parent == 0 { new.unwrap_or(0) } else { parent });
        let id = self.spawn(&spawn.description, spawn.transform.clone(), parent)?;
        for command in &spawn.do_after {
            // As with CARLA, what fails afterwards does not undo the spawn.
            if let Err(error) = self.obey(command, Some(id)) {
                tracing::warn!("a command after a spawn: {error}");
            }
        }
        Ok(id)
    }
}
