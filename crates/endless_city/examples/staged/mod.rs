//! Actors standing at spawn points and on sidewalks, without traffic.

#![allow(dead_code, reason = "each example uses some of it")]

pub(crate) mod draw;
pub(crate) mod sheet;

use endless_asset::Catalogue;
use endless_town::Town;
use endless_world::{
    Actor, Behaviour, Gait, InstanceId, Motion, ObjectClass, Outfit, PersonRef, Pose, SignalAspect, SignalState,
    VehicleLights, VehicleModelId, VehicleMotion, VehicleRef, WalkerMotion, WorldState,
};
use glam::Vec3;

/// A vehicle at every fourth spawn point, a person at every few sidewalk nodes near the camera.
pub(crate) fn crowd(town: &Town, eye: [f32; 3], catalogue: &Catalogue, lights: bool) -> WorldState {
    let first = town.parked.len() as u16 + 1;
    let mut actors = Vec::new();
    let mut next = first;
    for (i, spawn) in town.network.spawn_points.iter().enumerate().step_by(5) {
        let model = (i * 7 / 3 % catalogue.vehicles().len().max(1)) as u32;
        let model = VehicleModelId(model);
        let Some(entry) = catalogue.vehicle(model) else { break };
        let place = town.network.lane(spawn.lane).centerline.at(spawn.s);
        let rider_id = entry.spec.ridden.then(|| InstanceId(next + 1));
        let lit = VehicleLights::LOW_BEAM | VehicleLights::POSITION;
        let lights = if lights { lit } else { VehicleLights::empty() };
        actors.push(Actor {
            id: InstanceId(next),
            rider_id,
            class: entry.spec.class,
            asset: VehicleRef { model, variant: i as u64 * 977 }.into(),
            pose: Pose::level(place.position.as_vec3(), place.heading_rad as f32),
            velocity_mps: Vec3::ZERO,
            motion: Motion::Vehicle(VehicleMotion { lights, ..VehicleMotion::default() }),
            behaviour: Behaviour::default(),
            parked: false,
        });
        next += 2;
    }
    for (i, edge) in town.network.walk.edges.iter().enumerate().step_by(2) {
        let [a, b] = edge.nodes.map(|n| town.network.walk.nodes[n.index()].as_vec3());
        let along = b - a;
        let position = a + along * 0.37;
        let yaw = endless_world::math::atan2(along.y, along.x);
        let [x, y, z] = eye;
        if position.distance(Vec3::new(x, y, z)) > 70.0 {
            continue;
        }
        actors.push(Actor {
            id: InstanceId(next),
            rider_id: None,
            class: ObjectClass::Pedestrian,
            asset: PersonRef { outfit: Outfit::Fair, seed: i as u64 * 31 }.into(),
            pose: Pose::level(position, yaw),
            velocity_mps: Vec3::ZERO,
            motion: Motion::Walker(WalkerMotion {
                speed_mps: 1.3,
                gait: Gait::Walk,
                walked_m: i as f32 * 0.37,
                ..WalkerMotion::default()
            }),
            behaviour: Behaviour::default(),
            parked: false,
        });
        next += 1;
    }
    let aspects = [SignalAspect::Red, SignalAspect::Green];
    let signals =
        (0..town.network.signal_groups).map(|i| SignalState { aspect: aspects[usize::from(i) % 2] }).collect();
    WorldState { frame: 0, time_s: 0.0, actors, signals }
}
