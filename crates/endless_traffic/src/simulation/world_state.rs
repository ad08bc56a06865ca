//! What a simulation tells of an instant.

use super::Simulation;
use crate::behaviour;
use crate::playback::Playback;
use crate::settings::DrivingCondition;
use endless_world::math::f64::wrap_angle;
use endless_world::{Actor, InstanceId, Motion, ObjectClass, PersonRef, Pose, VehicleMotion, WalkerMotion, WorldState};
use std::collections::BTreeSet;

impl Simulation {
    /// Everybody who is there in some of this frame and the `frames` that follow, by ascending id, with the looks that they
    /// have in all; of those who play tracks it is left open where they are. `condition` tells the weather of a frame.
    ///
    /// Where vehicles come and leave, a copy of the simulation finds out who comes.
    pub fn everybody(&self, frames: u32, condition: impl Fn(u32) -> DrivingCondition) -> Vec<Actor> {
        let mut actors = self.simulated(true);
        if self.roads.borders.are_open() {
            let mut known: BTreeSet<InstanceId> = actors.iter().map(|actor| actor.id).collect();
            let mut later = self.clone();
            for _ in 0..frames {
                later.set_condition(condition(later.frame + 1));
                later.tick();
                actors.extend(later.simulated(true).into_iter().filter(|actor| known.insert(actor.id)));
            }
        }
        actors.extend(self.playback.iter().flat_map(Playback::everybody));
        actors.sort_by_key(|actor| actor.id);
        actors
    }

    /// The names of the tracks that are played, by the ids of those who play them.
    pub fn track_names(&self) -> impl Iterator<Item = (InstanceId, &str)> {
        self.playback.iter().flat_map(Playback::names)
    }

    /// The current frame, by ascending id. Ids go on after the parked vehicles': vehicles, then riders, then pedestrians; so
    /// again of those who play tracks; then those who have come onto the map since the warm-up began.
    pub fn state(&self) -> WorldState {
        let time_s = f64::from(self.frame) / self.fps;
        let mut actors = self.simulated(false);
        let playback = self.playback.iter();
        actors.extend(playback.flat_map(|playback| playback.state(&self.roads.network, time_s)));
        actors.sort_by_key(|actor| actor.id);
        WorldState { frame: self.frame, time_s, actors, signals: self.signals.clone() }
    }

    /// Those whose ways are simulated, with those inside of buses or without.
    fn simulated(&self, inside: bool) -> Vec<Actor> {
        let time_s = f64::from(self.frame) / self.fps;
        let mut actors = Vec::with_capacity(self.vehicles.len() + self.walkers.len());
        for (vehicle, &(id, rider_id)) in self.vehicles.iter().zip(&self.ids.vehicles) {
            let motion = VehicleMotion {
                speed_mps: vehicle.speed as f32,
                rolled_m: vehicle.rolled as f32,
                steer_rad: vehicle.steer as f32,
                hitch_rad: vehicle.trailer.map_or(0.0, |t| wrap_angle(t.yaw - vehicle.yaw) as f32),
                lights: vehicle.lights,
            };
            actors.push(Actor {
                id,
                rider_id,
                class: vehicle.class,
                asset: vehicle.asset.into(),
                pose: vehicle.pose,
                velocity_mps: vehicle.velocity,
                motion: Motion::Vehicle(motion),
                behaviour: behaviour::of_vehicle(vehicle, &self.roads),
                parked: false,
            });
        }
        let outfit = self.outfit;
        for (walker, &id) in self.walkers.iter().zip(&self.ids.walkers) {
            if walker.bus.is_inside() && !inside {
                continue;
            }
            let motion = WalkerMotion {
                speed_mps: walker.velocity.length() as f32,
                gait: walker.gait,
                walked_m: walker.walked as f32,
                time_s: time_s as f32,
                footing: Some(walker.steps.footing()),
                risen: walker.risen().unwrap_or_default() as f32,
            };
            actors.push(Actor {
                id,
                rider_id: None,
                class: ObjectClass::Pedestrian,
                asset: PersonRef { outfit, seed: walker.variant }.into(),
                pose: Pose::level(walker.position.extend(walker.height).as_vec3(), walker.yaw as f32),
                velocity_mps: walker.velocity.extend(0.0).as_vec3(),
                motion: Motion::Walker(motion),
                behaviour: behaviour::of_walker(walker, &self.roads),
                parked: false,
            });
        }
        actors
    }
}
