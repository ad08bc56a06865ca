//! The fleet and the settings of a simulation.

use crate::population::Conditions;
use endless_world::VehicleSpec;
use endless_world::walking::PedestrianSpec;
use glam::Vec3;

/// The vehicles and people there are to draw from.
#[derive(Clone, Copy)]
pub struct Fleet<'a> {
    /// Vehicle models, drawn by their frequency; a [`VehicleModelId`](endless_world::VehicleModelId) is a place in
    /// this list.
    pub vehicles: &'a [VehicleSpec],
    /// The person of a seed.
    pub pedestrian: &'a dyn Fn(u64) -> PedestrianSpec,
}

/// Settings of a simulation.
#[derive(Debug, Clone, PartialEq)]
pub struct TrafficSettings {
    /// Moving vehicles; as many are spawned as find room.
    pub vehicles: u32,
    /// People on foot; as many are spawned as find room on the sidewalks.
    pub pedestrians: u32,
    /// Everything random follows from it.
    pub seed: u64,
    /// Frames a second, positive.
    pub fps: f64,
    /// Effects of weather and time on drivers.
    pub conditions: Conditions,
    /// Places around which traffic is denser and to which ways rather lead (world frame, metres; say, the recorded
    /// cameras); without any, vehicles and people are spread evenly over the whole map.
    pub focus: Vec<Vec3>,
}

impl Default for TrafficSettings {
    fn default() -> Self {
        Self { vehicles: 30, pedestrians: 20, seed: 0, fps: 10.0, conditions: Conditions::default(), focus: Vec::new() }
    }
}
