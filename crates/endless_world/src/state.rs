//! The world at one instant: where traffic and renderer meet.

use crate::Actor;
use serde::{Deserialize, Serialize};

/// The aspect of a signal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SignalAspect {
    /// Stop.
    Red,
    /// About to turn red: stop if you can.
    Yellow,
    /// Go.
    Green,
    /// About to turn green (where the country has it).
    RedYellow,
}

/// The state of one signal group; index = [`crate::SignalId`]. Pedestrian groups use Red, Green, and Yellow for
/// "finish crossing" (shown as blinking green or red hand).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct SignalState {
    /// Its aspect.
    pub aspect: SignalAspect,
}

/// Everything that can differ between two frames of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct WorldState {
    /// Simulation frame; the first recorded frame of a video is 0.
    pub frame: u32,
    /// Seconds since frame 0.
    pub time_s: f64,
    /// Moving actors, by ascending id; those that stand at a red light included, parked vehicles not.
    pub actors: Vec<Actor>,
    /// One a signal group of the map.
    pub signals: Vec<SignalState>,
}
