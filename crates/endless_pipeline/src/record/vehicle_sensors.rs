//! Sensors that notice what happens to their carriers, shown every world state in its order.

use super::streams::{Stream, StreamModel};
use endless_annotate::{
    CollisionEvent, CollisionSensor, LaneInvasionEvent, LaneInvasionSensor, MarkFeature, RoadFacts,
};
use endless_world::{Actor, InstanceId, WorldState};
use glam::Vec2;

/// Those of a video, by the places of their streams.
pub(super) struct VehicleSensors {
    sensors: Vec<(usize, VehicleSensor)>,
}

enum VehicleSensor {
    Collision(CollisionSensor),
    LaneInvasion(LaneInvasionSensor),
}

/// What such a sensor noticed at a frame.
#[derive(Debug, Clone)]
pub(super) enum Noticed {
    Collisions(Vec<CollisionEvent>),
    LaneInvasion(Option<LaneInvasionEvent>),
}

impl VehicleSensors {
    /// Of streams whose carriers are known by their places in the rig.
    pub(super) fn new(
        streams: &[Stream<'_>],
        carrier: impl Fn(usize) -> Option<InstanceId>,
        road: &RoadFacts,
        parked: &[Actor],
        marks: &[MarkFeature],
    ) -> Self {
        let sensor = |(place, stream): (usize, &Stream<'_>)| {
            let id = carrier(stream.sensor?.0)?;
            let half = road.half_sizes.get(&id).copied().unwrap_or(Vec2::ZERO);
            let sensor = match &stream.model {
                StreamModel::Collision => {
                    VehicleSensor::Collision(CollisionSensor::new(id, road.half_sizes.clone(), parked.to_vec()))
                }
                StreamModel::LaneInvasion => VehicleSensor::LaneInvasion(LaneInvasionSensor::new(id, half, marks)),
                _ => return None,
            };
            Some((place, sensor))
        };
        Self { sensors: streams.iter().enumerate().filter_map(sensor).collect() }
    }

    /// What they notice of the next state, by the places of their streams.
    pub(super) fn observe(&mut self, state: &WorldState) -> Vec<(usize, Noticed)> {
        let notice = |(place, sensor): &mut (usize, VehicleSensor)| {
            let noticed = match sensor {
                VehicleSensor::Collision(sensor) => Noticed::Collisions(sensor.observe(state)),
                VehicleSensor::LaneInvasion(sensor) => Noticed::LaneInvasion(sensor.observe(state)),
            };
            (*place, noticed)
        };
        self.sensors.iter_mut().map(notice).collect()
    }
}
