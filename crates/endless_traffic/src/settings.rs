//! The fleet and the settings of a simulation.

use crate::Focus;
use endless_world::walking::PedestrianSpec;
use endless_world::{Condition, ObjectClass, TrafficProfile, VehicleSpec};
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

/// What road users take notice of in weather and light. By default, a dry day.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DrivingCondition {
    /// Share of vehicles that drive with dipped headlights, 0 to 1.
    pub headlights_on: f32,
    /// Of the road, 0 dry to 1 soaked: drivers go slower and keep more distance.
    pub wetness: f32,
    /// Rain in the air, 0 to 1: people wear other clothes.
    pub rain: f32,
}

impl<Q> From<&Condition<Q>> for DrivingCondition {
    fn from(&Condition { headlights_on, wetness, rain, .. }: &Condition<Q>) -> Self {
        Self { headlights_on, wetness, rain }
    }
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
    /// Weather and light at the beginning.
    pub condition: DrivingCondition,
    /// What is looked at: traffic is denser there, and more ways lead there. By default nothing is, and vehicles and people
    /// are spread over the whole map.
    pub focus: Focus,
    /// Places in the world where people have something to do, metres: stops and shops.
    pub errands: Vec<Vec3>,
    /// Classes of the vehicles that are spawned first; all others are drawn by their frequency.
    pub first: Vec<ObjectClass>,
    /// Which vehicles there are, and how they are driven.
    pub profile: TrafficProfile,
}

impl Default for TrafficSettings {
    fn default() -> Self {
        let condition = DrivingCondition::default();
        Self {
            vehicles: 30,
            pedestrians: 20,
            seed: 0,
            fps: 10.0,
            condition,
            focus: Focus::default(),
            errands: Vec::new(),
            first: Vec::new(),
            profile: TrafficProfile::default(),
        }
    }
}
