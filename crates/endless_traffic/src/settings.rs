//! The fleet and the settings of a simulation.

use crate::Focus;
use endless_world::walking::PedestrianSpec;
use endless_world::{BenchSeat, BusStop, Condition, ObjectClass, ParkingBay, TrafficProfile, VehicleSpec};
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
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrivingCondition {
    /// Share of vehicles that drive with dipped headlights, 0 to 1.
    pub headlights_on: f32,
    /// Of the road, 0 dry to 1 soaked: drivers go slower and keep more distance.
    pub wetness: f32,
    /// Rain in the air, 0 to 1: people wear other clothes.
    pub rain: f32,
    /// How far one sees, metres: in fog drivers go slower and keep more distance.
    pub visibility_m: f32,
}

impl Default for DrivingCondition {
    fn default() -> Self {
        Self { headlights_on: 0.0, wetness: 0.0, rain: 0.0, visibility_m: f32::INFINITY }
    }
}

/// By day at most this share of vehicles has its headlights on.
const DAYLIGHT: f32 = 0.5;

impl DrivingCondition {
    /// Whether people do outdoors what they do by day while it does not rain.
    pub(crate) fn is_day_without_rain(&self) -> bool {
        self.headlights_on < DAYLIGHT && self.rain <= 0.0
    }

    /// Whether drivers keep the speeds and distances that they keep in another one.
    pub(crate) fn drives_like(&self, other: &Self) -> bool {
        self.wetness == other.wetness && self.visibility_m == other.visibility_m
    }
}

impl From<&Condition<f32>> for DrivingCondition {
    fn from(&Condition { headlights_on, wetness, rain, visibility_m, .. }: &Condition<f32>) -> Self {
        Self { headlights_on, wetness, rain, visibility_m }
    }
}

/// Of a kind of weather: in its middle.
impl From<&Condition> for DrivingCondition {
    fn from(&Condition { headlights_on, wetness, rain, visibility_m, .. }: &Condition) -> Self {
        Self { headlights_on, wetness, rain, visibility_m: 0.5 * (visibility_m.low + visibility_m.high) }
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
    /// Where buses stop; nowhere by default.
    pub bus_stops: Vec<BusStop>,
    /// Seats of benches; nowhere by default.
    pub bench_seats: Vec<BenchSeat>,
    /// Bays at kerbs, in which drivers park; nowhere by default.
    pub parking_bays: Vec<ParkingBay>,
    /// Share of people who cross roads away from crossings when a gap in traffic lets them, 0 to 1.
    pub jaywalking: f64,
    /// Share of people who walk in groups of two to four, 0 to 1.
    pub groups: f64,
    /// Share of vans and lorries that deliver, 0 to 1: now and then they stand in the lane at the kerb, hazard lights on.
    pub deliveries: f64,
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
            bus_stops: Vec::new(),
            bench_seats: Vec::new(),
            parking_bays: Vec::new(),
            jaywalking: 0.0,
            groups: 0.0,
            deliveries: 0.0,
            first: Vec::new(),
            profile: TrafficProfile::default(),
        }
    }
}
