//! Sensors that notice what happens to their carriers, shown every world state in its order.

use super::streams::{Stream, StreamModel};
use crate::SceneBodies;
use endless_annotate::{CollisionEvent, CollisionSensor, LaneInvasionEvent, LaneInvasionSensor, MarkFeature};
use endless_world::{InstanceId, WorldState};

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
pub(crate) enum Noticed {
    Collisions(Vec<CollisionEvent>),
    LaneInvasion(Option<LaneInvasionEvent>),
}

impl VehicleSensors {
    /// Of streams whose carriers are known by their places in the rig.
    pub(super) fn new(
        streams: &[Stream<'_>],
        carrier: impl Fn(usize) -> Option<InstanceId>,
        bodies: impl Fn() -> SceneBodies,
        marks: &[MarkFeature],
    ) -> Self {
        let sensor = |(place, stream): (usize, &Stream<'_>)| {
            let id = carrier(stream.sensor?.0)?;
            let sensor = match &stream.model {
                StreamModel::Collision => {
                    let SceneBodies { sizes, still } = bodies();
                    VehicleSensor::Collision(CollisionSensor::new(id, sizes, still))
                }
                StreamModel::LaneInvasion => {
                    let size = *bodies().sizes.get(&id)?;
                    VehicleSensor::LaneInvasion(LaneInvasionSensor::new(id, size, marks))
                }
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
