//! Driving conditions, and numbers of actors.

use endless_world::{Condition, TimeOfDay, Weather};

/// Effects of weather and time on drivers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Conditions {
    /// Dipped headlights are on.
    pub headlights_on: bool,
    /// The road is wet: drivers are a little slower and keep more distance.
    pub wet: bool,
    /// It rains: pedestrians are dressed for it.
    pub raining: bool,
}

impl Conditions {
    /// From a weather at a time of day.
    pub fn new(weather: Weather, time: TimeOfDay) -> Self {
        let Condition { headlights_on, wet_road, rain, .. } = *Condition::of(weather, time);
        Self { headlights_on, wet: wet_road, raining: rain > 0.0 }
    }
}

/// Numbers of actors, requested and spawned.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Population {
    /// Moving vehicles requested.
    pub vehicles_asked: u32,
    /// Moving vehicles spawned.
    pub vehicles_spawned: u32,
    /// Spawn points for vehicles in this town; long vehicles take the room of several.
    pub vehicle_capacity: u32,
    /// Pedestrians requested.
    pub pedestrians_asked: u32,
    /// Pedestrians spawned.
    pub pedestrians_spawned: u32,
}
