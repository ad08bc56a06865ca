//! The moving scene at one instant: instances to trace, volumes that shade the ground, vehicle lights.

use super::Instance;
use super::moving_object::{MovingObject, MovingVolume};
use crate::accel::Tlas;
use crate::light::VehicleBeam;
use endless_world::SignalAspect;
use rayon::prelude::*;

/// The moving objects, vehicle lights and signals of one instant; empty by default.
#[derive(Debug, Clone, Default)]
pub struct FrameDescription {
    /// Number of the frame: rain and noise differ by it.
    pub frame: u32,
    /// Moving objects.
    pub objects: Vec<MovingObject>,
    /// Lights of vehicles that shine on their surroundings at night.
    pub beams: Vec<VehicleBeam>,
    /// Aspects of signals, by [`SignalId`](endless_world::SignalId).
    pub signals: Vec<SignalAspect>,
}

/// The moving part of the scene at one instant, ready to be traced. Cheap to make: a millisecond or two.
#[derive(Debug)]
pub struct FrameScene {
    pub(crate) frame: u32,
    pub(crate) instances: Vec<Instance>,
    pub(crate) accel: Tlas,
    pub(crate) objects: Vec<MovingVolume>,
    pub(crate) beams: Vec<VehicleBeam>,
    pub(crate) signals: Vec<SignalAspect>,
}

impl FrameScene {
    /// Builds the hierarchy over what moves.
    pub fn new(description: FrameDescription) -> Self {
        let FrameDescription { frame, objects, beams, signals } = description;
        let mut instances = Vec::new();
        let mut spans = Vec::new();
        for MovingObject { instances: own, footprint } in objects {
            let own = own.into_iter().filter(|instance| !instance.geometry.is_empty());
            let (first, object) = (instances.len(), spans.len() as u16);
            instances.extend(own.map(|instance| Instance { object, ..instance }));
            if first < instances.len() {
                spans.push((first..instances.len(), footprint));
            }
        }
        let accel = Tlas::build(instances.iter().map(Instance::placed).collect());
        let objects = spans
            .into_par_iter()
            .map(|(own, footprint)| MovingVolume::new(&accel, &instances, own, &footprint, &beams))
            .collect();
        Self { frame, instances, accel, objects, beams, signals }
    }

    /// Vehicle lights that may reach an instance of what moves.
    pub(crate) fn beams_on(&self, instance: &Instance) -> &[u16] {
        self.objects.get(usize::from(instance.object)).map_or(&[], |object| &object.beams)
    }
}
