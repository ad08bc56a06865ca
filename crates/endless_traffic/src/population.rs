//! What a simulation is asked for, and what it could give.

use endless_world::{Condition, TimeOfDay, Weather};

/// What drivers see of weather and time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Conditions {
    /// Dipped headlights are on.
    pub headlights_on: bool,
    /// The road is wet: everybody drives a little slower and keeps more distance.
    pub wet: bool,
    /// Rain falls: people on foot are dressed for it.
    pub raining: bool,
}

impl Conditions {
    /// Of a weather at a time of day.
    pub fn new(weather: Weather, time: TimeOfDay) -> Self {
        let Condition { headlights_on, wet_road, rain, .. } = *Condition::of(weather, time);
        Self { headlights_on, wet: wet_road, raining: rain > 0.0 }
    }
}

/// How many of those asked for there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Population {
    /// Moving vehicles asked for.
    pub vehicles_asked: u32,
    /// Moving vehicles there are.
    pub vehicles_spawned: u32,
    /// Spawn points for vehicles in this town; long vehicles take the room of several.
    pub vehicle_capacity: u32,
    /// Pedestrians asked for.
    pub pedestrians_asked: u32,
    /// Pedestrians there are.
    pub pedestrians_spawned: u32,
}
