//! What an actor is doing on the road network, beyond its motion.

use serde::{Deserialize, Serialize};

/// A side, seen from the driver.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// To the left.
    Left,
    /// To the right.
    Right,
}

/// How far a vehicle is that parks at the kerb.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Parking {
    /// On the way from the lane to its place at the kerb.
    PullingIn,
    /// Standing there, off the lane.
    Parked,
    /// On the way back to the lane.
    PullingOut,
}

/// A place on a lane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LanePlace {
    /// Index of the lane in its map's road network.
    pub lane: u32,
    /// Metres from the lane's beginning, along its centre line.
    pub s_m: f32,
}

/// What an actor is doing on the road network; all unknown by default.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Behaviour {
    /// Of a vehicle: where its origin is.
    pub lane: Option<LanePlace>,
    /// Of a vehicle: the lane that it is leaving for the one it is on, by index.
    pub lane_left: Option<u32>,
    /// Of a vehicle that parks at the kerb, or comes from there: how far it is. While it is parked it is on no lane.
    pub parking: Option<Parking>,
    /// Of a vehicle: change of its speed, m/s².
    pub acceleration_mps2: f32,
    /// Of a vehicle: where its indicators show, whether they are lit at this instant or not.
    pub indicating: Option<Side>,
    /// Of a vehicle: which way its lane turns in a junction.
    pub turning: Option<Side>,
    /// Of a person on foot: the crossing underfoot, by its index in the road network.
    pub crossing: Option<u16>,
    /// Of a person on foot: whether they stand at a kerb until they may cross.
    pub waiting: bool,
    /// Of a person on foot: whether they cross a road away from its crossings.
    pub jaywalking: bool,
}
