//! Who moves the actors of a session: our own traffic on the server's map, or a TrafficManager for the vehicles.

use super::body::ActorBody;
use super::cast::Cast;
use super::error::ClientError;
use super::traffic_manager::TrafficManager;
use super::world::{Snapshot, World};
use crate::frames;
use crate::instance::instance_id;
use crate::physics::WalkerBody;
use crate::stream::{ActorRecord, ActorRecordState};
use crate::wire::Command;
use endless_traffic::Simulation;
use endless_world::{Actor, Behaviour, Gait, Motion, VehicleLights, VehicleMotion, WalkerMotion, WorldState};
use std::collections::BTreeMap;

/// Moves the actors of a session.
pub(super) struct Driver {
    /// All people; all vehicles, too, where no TrafficManager drives them; the signals.
    pub(super) simulation: Simulation,
    pub(super) manager: Option<TrafficManager>,
    /// As the server was told last.
    lights: BTreeMap<u32, VehicleLights>,
    /// To where its front wheels point, as the server was told last, half degrees to the right.
    wheels: BTreeMap<u32, i32>,
    /// People as a server of ours moves them: the wire tells where they are, and not which foot is in front.
    walkers: BTreeMap<u32, WalkerBody>,
}

impl Driver {
    pub(super) fn new(simulation: Simulation) -> Self {
        Self { simulation, manager: None, lights: BTreeMap::new(), wheels: BTreeMap::new(), walkers: BTreeMap::new() }
    }

    /// Whether a frame can be made again: nobody moves between frames by themselves.
    pub(super) fn is_still_between_frames(&self) -> bool {
        self.manager.is_none()
    }

    /// Puts all that our traffic moves where it is now.
    pub(super) fn place(&mut self, cast: &Cast, world: &mut World) -> Result<(), ClientError> {
        let mut commands = Vec::new();
        for actor in &self.simulation.state().actors {
            let Some(&id) = cast.of_traffic.get(&actor.id) else { continue };
            let Some(body) = cast.bodies.get(&id) else { continue };
            let transform = body.transform(&actor.pose);
            match actor.motion {
                Motion::Vehicle(motion) => {
                    commands.push(Command::ApplyTransform { actor: id, transform });
                    if self.lights.insert(id, motion.lights) != Some(motion.lights) {
                        commands.push(Command::SetVehicleLightState { actor: id, lights: motion.lights.bits() });
                    }
                    let half_degrees = (-2.0 * motion.steer_rad.to_degrees()).round() as i32;
                    if self.wheels.insert(id, half_degrees).unwrap_or(0) != half_degrees {
                        world.steer_wheels(id, body.class, 0.5 * half_degrees as f32)?;
                    }
                }
                Motion::Walker(motion) => {
                    let place = frames::place(&transform);
                    let [width, height] = [body.size.y, body.size.z].map(f64::from);
                    let walker = self.walkers.entry(id);
                    let walker = walker.or_insert_with(|| WalkerBody::new(height, 0.5 * width, place));
                    walker.put_walking(place, motion.speed_mps.into());
                    commands.push(Command::ApplyWalkerState { actor: id, transform, speed: motion.speed_mps });
                }
            }
        }
        let results = world.batch(&commands)?;
        match results.into_iter().find_map(Result::err) {
            Some(text) => Err(ClientError::Unfit(format!("an actor is gone: {text}"))),
            None => Ok(()),
        }
    }

    /// The world as a snapshot has it, as frame `frame` of the video.
    pub(super) fn state(
        &self,
        cast: &Cast,
        world: &mut World,
        snapshot: &Snapshot,
        frame: u32,
        fps: f64,
    ) -> Result<WorldState, ClientError> {
        let lights = if self.manager.is_some() { world.vehicle_lights()? } else { BTreeMap::new() };
        let own = self.simulation.state();
        let moved: BTreeMap<u32, &Actor> =
            own.actors.iter().filter_map(|actor| Some((*cast.of_traffic.get(&actor.id)?, actor))).collect();
        let mut actors = Vec::with_capacity(cast.bodies.len());
        for (id, body) in &cast.bodies {
            let gone = || ClientError::Unfit(format!("actor {id} is gone"));
            let record = snapshot.actors.get(id).ok_or_else(gone)?;
            let lights = lights.get(id).map(|bits| VehicleLights::from_bits_truncate(*bits));
            let mut actor = actor(*id, body, record, moved.get(id).copied(), lights.unwrap_or_default());
            if let Some(walker) = self.walkers.get(id) {
                actor.motion = Motion::Walker(walker.motion(snapshot.header.timestamp));
            }
            actors.push(actor);
        }
        actors.sort_by_key(|actor| actor.id);
        Ok(WorldState { frame, time_s: f64::from(frame) / fps, actors, signals: own.signals })
    }
}

/// An actor where the server has it, moving as our traffic has it where that moves it.
fn actor(id: u32, body: &ActorBody, record: &ActorRecord, moved: Option<&Actor>, lights: VehicleLights) -> Actor {
    let velocity = moved.map_or_else(|| frames::from_carla(&record.velocity), |actor| actor.velocity_mps);
    let motion = match (moved, &record.state) {
        (Some(actor), _) => actor.motion,
        (None, ActorRecordState::Walker(_)) => {
            Motion::Walker(WalkerMotion { speed_mps: velocity.length(), gait: Gait::Walk, ..WalkerMotion::default() })
        }
        (None, state) => {
            let steer = if let ActorRecordState::Vehicle(vehicle) = state { vehicle.steer } else { 0.0 };
            /// Of wheels that are turned as far as they go, radians.
            const MOST_STEER_RAD: f32 = 1.2;
            let speed_mps = forward_speed(record);
            Motion::Vehicle(VehicleMotion {
                speed_mps,
                steer_rad: -steer * MOST_STEER_RAD,
                lights,
                ..VehicleMotion::default()
            })
        }
    };
    Actor {
        id: instance_id(id),
        // Put in by the table of instances.
        rider_id: None,
        class: body.class,
        asset: body.asset,
        pose: body.pose(&record.transform),
        velocity_mps: velocity,
        motion,
        behaviour: moved.map_or_else(Behaviour::default, |actor| actor.behaviour),
        parked: false,
    }
}

fn forward_speed(record: &ActorRecord) -> f32 {
    let forward = frames::pose(&record.transform).world_from_object().x_axis;
    frames::from_carla(&record.velocity).dot(forward.into())
}
