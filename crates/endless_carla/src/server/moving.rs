//! Actors that move, and are moved.

use super::actor::{Body, ServerActor};
use super::call_error::CallError;
use super::episode::Episode;
use super::obstacles::upright;
use super::vehicle_actor::VehicleActor;
use super::walker_actor::WalkerActor;
use crate::frames;
use crate::physics::{self, Mover, Obstacle, OrientedBox, step_bodies};
use crate::wire::{Transform, Vector3D};
use glam::{DVec2, DVec3};
use std::sync::Arc;

/// What a push is, in SI units.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Push {
    Impulse,
    Force,
    AngularImpulse,
    Torque,
}

impl Episode {
    pub(super) fn actor(&self, id: u32) -> Result<&ServerActor, CallError> {
        self.actors.get(&id).ok_or_else(|| CallError::no_actor(id))
    }

    /// Whether an actor was there and has gone: the client's TrafficManager asks after such from a thread of its own, and what
    /// it is refused ends the program.
    pub(super) fn has_gone(&self, id: u32) -> bool {
        self.has_given(id) && !self.actors.contains_key(&id)
    }

    fn actor_mut(&mut self, id: u32) -> Result<&mut ServerActor, CallError> {
        self.actors.get_mut(&id).ok_or_else(|| CallError::no_actor(id))
    }

    pub(super) fn vehicle(&mut self, id: u32) -> Result<&mut VehicleActor, CallError> {
        match &mut self.actor_mut(id)?.body {
            Body::Vehicle(vehicle) => Ok(vehicle),
            _ => Err(CallError::refused(format!("actor {id} is not a vehicle"))),
        }
    }

    pub(super) fn walker(&mut self, id: u32) -> Result<&mut WalkerActor, CallError> {
        match &mut self.actor_mut(id)?.body {
            Body::Walker(walker) => Ok(walker),
            _ => Err(CallError::refused(format!("actor {id} is not a walker"))),
        }
    }

    /// Puts an actor somewhere; what is attached, on its parent.
    pub(super) fn put(&mut self, id: u32, transform: Transform) -> Result<(), CallError> {
        if !frames::is_finite(&transform) {
            return Err(CallError::refused("that is no place"));
        }
        let actor = self.actor_mut(id)?;
        match &mut actor.body {
            Body::Vehicle(vehicle) => vehicle.body.put(frames::place(&transform)),
            Body::Walker(walker) => walker.put(&transform),
            _ => {}
        }
        match &mut actor.on_parent {
            Some(on_parent) => *on_parent = transform,
            None => actor.transform = transform,
        }
        self.carry_attached();
        Ok(())
    }

    /// Puts a person somewhere, walking.
    pub(super) fn put_walker(&mut self, id: u32, transform: Transform, speed_mps: f32) -> Result<(), CallError> {
        if !frames::is_finite(&transform) {
            return Err(CallError::refused("that is no place"));
        }
        self.walker(id)?.put_walking(&transform, speed_mps);
        self.actor_mut(id)?.transform = transform;
        Ok(())
    }

    pub(super) fn simulate_physics(&mut self, id: u32, on: bool) -> Result<(), CallError> {
        match &mut self.actor_mut(id)?.body {
            Body::Vehicle(vehicle) => vehicle.body.set_simulated(on),
            Body::Walker(walker) => walker.body.set_simulated(on),
            _ => {}
        }
        Ok(())
    }

    pub(super) fn enable_gravity(&mut self, id: u32, on: bool) -> Result<(), CallError> {
        match &mut self.actor_mut(id)?.body {
            Body::Vehicle(vehicle) => vehicle.body.set_gravity(on),
            Body::Walker(walker) => walker.body.set_gravity(on),
            _ => {}
        }
        Ok(())
    }

    pub(super) fn enable_collisions(&mut self, id: u32, on: bool) -> Result<(), CallError> {
        match &mut self.actor_mut(id)?.body {
            Body::Vehicle(vehicle) => vehicle.body.set_collides(on),
            Body::Walker(walker) => walker.body.set_collides(on),
            Body::Prop(prop) => prop.collides = on,
            _ => {}
        }
        Ok(())
    }

    pub(super) fn set_target_velocity(&mut self, id: u32, velocity: &Vector3D) -> Result<(), CallError> {
        let velocity = frames::from_carla(velocity).as_dvec3();
        match &mut self.actor_mut(id)?.body {
            Body::Vehicle(vehicle) => vehicle.body.set_target_velocity(velocity),
            Body::Walker(walker) => walker.body.set_target_velocity(velocity),
            _ => {}
        }
        Ok(())
    }

    /// Degrees a second.
    pub(super) fn set_target_angular_velocity(&mut self, id: u32, velocity: &Vector3D) -> Result<(), CallError> {
        let turn = frames::turn_from_carla(velocity);
        if let Body::Vehicle(vehicle) = &mut self.actor_mut(id)?.body {
            vehicle.body.set_target_angular_velocity(turn);
        }
        Ok(())
    }

    /// Knocks or pushes an actor.
    pub(super) fn push(&mut self, id: u32, vector: &Vector3D, push: Push) -> Result<(), CallError> {
        let straight = frames::from_carla(vector).as_dvec3();
        let turning = frames::axis_from_carla(vector);
        match (&mut self.actor_mut(id)?.body, push) {
            (Body::Vehicle(vehicle), Push::Impulse) => vehicle.body.add_impulse(straight),
            (Body::Vehicle(vehicle), Push::Force) => vehicle.body.add_force(straight),
            (Body::Vehicle(vehicle), Push::AngularImpulse) => vehicle.body.add_angular_impulse(turning),
            (Body::Vehicle(vehicle), Push::Torque) => vehicle.body.add_torque(turning),
            (Body::Walker(walker), Push::Impulse) => walker.body.add_impulse(straight),
            _ => {}
        }
        Ok(())
    }

    /// Knocks or pushes a vehicle at a place in the world.
    pub(super) fn push_at(&mut self, id: u32, vector: &Vector3D, at: &Vector3D, push: Push) -> Result<(), CallError> {
        let (straight, at) = (frames::from_carla(vector).as_dvec3(), frames::from_carla(at).as_dvec3());
        match (&mut self.actor_mut(id)?.body, push) {
            (Body::Vehicle(vehicle), Push::Impulse) => vehicle.body.add_impulse_at(straight, at),
            (Body::Vehicle(vehicle), Push::Force) => vehicle.body.add_force_at(straight, at),
            _ => self.push(id, vector, push)?,
        }
        Ok(())
    }

    /// The lights of all vehicles, as flags.
    pub(super) fn light_states(&self) -> Vec<(u32, u32)> {
        let lights = |actor: &ServerActor| match &actor.body {
            Body::Vehicle(vehicle) => Some((actor.told.id, vehicle.lights())),
            _ => None,
        };
        self.actors.values().filter_map(lights).collect()
    }

    /// Whether a vehicle, somebody or a prop that is seen stands there.
    pub(super) fn is_taken(&self, outline: &OrientedBox) -> bool {
        self.actors.values().any(|actor| match &actor.body {
            Body::Vehicle(other) => outline.touches(&other.body.outline()),
            Body::Walker(other) => outline.touches(&other.body.outline()),
            Body::Prop(prop) => {
                prop.collides
                    && prop.body.is_some()
                    && outline.touches(&upright(&actor.transform, &actor.told.bounding_box))
            }
            _ => false,
        })
    }

    /// Props that stop others, by their actors.
    fn props(&self) -> Vec<Obstacle> {
        let obstacle = |actor: &ServerActor| match &actor.body {
            Body::Prop(prop) if prop.collides => {
                let outline = upright(&actor.transform, &actor.told.bounding_box);
                Some(Obstacle { id: actor.told.id.into(), outline })
            }
            _ => None,
        };
        self.actors.values().filter_map(obstacle).collect()
    }

    /// Vehicles and people go on, and meet each other.
    pub(super) fn move_bodies(&mut self, step_s: f64) {
        let map = Arc::clone(&self.map);
        let ground = |x: f64, y: f64, z: f64| map.ground(DVec3::new(x, y, z));
        let props = self.props();
        let around = |low: DVec2, high: DVec2, found: &mut Vec<Obstacle>| {
            map.obstacles.near(low, high, found);
            found.extend(props.iter().filter(|prop| prop.outline.comes_into(low, high)));
        };
        let mut bodies = Vec::new();
        for actor in self.actors.values_mut() {
            let mover = match &mut actor.body {
                Body::Vehicle(vehicle) => {
                    vehicle.drive(step_s);
                    Mover::Vehicle(&mut vehicle.body, &vehicle.control)
                }
                Body::Walker(walker) => Mover::Walker(&mut walker.body, &walker.control),
                _ => continue,
            };
            bodies.push(physics::Body { id: actor.told.id, mover });
        }
        self.contacts = step_bodies(&mut bodies, step_s, &ground, &around);
        self.actors.values_mut().for_each(follow_body);
    }
}

/// An actor is where its body is.
fn follow_body(actor: &mut ServerActor) {
    let (velocity, acceleration, turn) = match &actor.body {
        Body::Vehicle(vehicle) => {
            let body = &vehicle.body;
            if body.simulated() {
                actor.transform = frames::transform_of(&body.place());
            }
            (body.velocity(), body.acceleration(), body.angular_velocity())
        }
        Body::Walker(walker) => {
            let body = &walker.body;
            if body.simulated() {
                actor.transform = walker.transform();
            }
            (body.velocity(), body.acceleration(), body.angular_velocity())
        }
        _ => return,
    };
    actor.velocity = frames::to_carla(velocity.as_vec3());
    actor.acceleration = frames::to_carla(acceleration.as_vec3());
    actor.angular_velocity = frames::turn_to_carla(turn);
}
