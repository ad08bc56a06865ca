//! What an object is doing.

use crate::rounding::thousandths;
use endless_world::{Actor, Gait, Motion, Parking, Side};
use serde::{Deserialize, Serialize};

/// Slower than this one stands, m/s.
pub(crate) const STANDS_MPS: f32 = 0.1;

/// What somebody on foot or on a two-wheeler is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Action {
    /// Standing.
    Standing,
    /// Standing, on the look-out for a gap or a bus.
    Waiting,
    /// Standing and talking.
    Talking,
    /// Walking.
    Walking,
    /// Walking as fast as one can.
    Hurrying,
    /// Running.
    Running,
    /// Sitting, on the way down to a seat or up from it, or rolling in a wheelchair.
    Sitting,
    /// Walking with both hands on something on wheels.
    Pushing,
    /// Riding a two-wheeler.
    Riding,
}

impl From<Gait> for Action {
    fn from(gait: Gait) -> Self {
        match gait {
            Gait::Stand | Gait::Idle => Self::Standing,
            Gait::Wait => Self::Waiting,
            Gait::Talk => Self::Talking,
            Gait::Walk => Self::Walking,
            Gait::Hurry => Self::Hurrying,
            Gait::Run => Self::Running,
            Gait::Sit => Self::Sitting,
            Gait::Push => Self::Pushing,
        }
    }
}

/// What an object is doing at an instant, as `objects.jsonl` has it: fields that do not apply are left out.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Activity {
    /// People and riders.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub action: Option<Action>,
    /// Vehicles: lamps that are lit at this instant, by CARLA's names.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lights: Option<Vec<String>>,
    /// Vehicles: standing in traffic.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stopped: Option<bool>,
    /// Vehicles that move about: change of speed, m/s².
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub acceleration_mps2: Option<f64>,
    /// Vehicles: angle of the front wheels, positive to the left, radians.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub steer_rad: Option<f64>,
    /// Vehicles: where the indicators show, whether they are lit at this instant or not.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub indicating: Option<Side>,
    /// Vehicles: which way they turn on a junction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turning: Option<Side>,
    /// Vehicles: index of the lane in the map's road network.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lane: Option<u32>,
    /// Vehicles: the OpenDRIVE id of the lane's road.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub road: Option<u32>,
    /// Vehicles: the OpenDRIVE id of the lane on its road.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub road_lane: Option<i32>,
    /// Vehicles: metres along the lane's centre line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lane_s_m: Option<f64>,
    /// Vehicles that change lanes: the lane that they leave.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lane_left: Option<u32>,
    /// Vehicles that park at the kerb during the video, or pull out: how far they are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub parking: Option<Parking>,
    /// People: index of the crossing underfoot.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crossing: Option<u16>,
    /// People: waiting at a kerb until they may cross.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub waiting_to_cross: Option<bool>,
    /// People: crossing a road away from its crossings; left out of all others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub jaywalking: Option<bool>,
}

impl Activity {
    /// Of the actor itself.
    pub(crate) fn of(actor: &Actor) -> Self {
        let behaviour = actor.behaviour;
        let is_parked = actor.parked || behaviour.parking == Some(Parking::Parked);
        match &actor.motion {
            Motion::Walker(motion) => Self {
                action: Some(motion.gait.into()),
                crossing: behaviour.crossing,
                waiting_to_cross: Some(behaviour.waiting),
                jaywalking: behaviour.jaywalking.then_some(true),
                ..Self::default()
            },
            Motion::Vehicle(motion) => Self {
                parking: behaviour.parking,
                lights: Some(motion.lights.iter_names().map(|(name, _)| name.to_lowercase()).collect()),
                stopped: Some(!is_parked && motion.speed_mps.abs() < STANDS_MPS),
                acceleration_mps2: (!actor.parked).then(|| thousandths(behaviour.acceleration_mps2)),
                steer_rad: Some(thousandths(motion.steer_rad)),
                indicating: behaviour.indicating,
                turning: behaviour.turning,
                lane: behaviour.lane.map(|place| place.lane),
                lane_s_m: behaviour.lane.map(|place| thousandths(place.s_m)),
                lane_left: behaviour.lane_left,
                ..Self::default()
            },
        }
    }

    /// Of who rides it.
    pub(crate) fn of_rider(actor: &Actor) -> Self {
        let Self { stopped, lane, lane_s_m, .. } = Self::of(actor);
        Self { action: Some(Action::Riding), stopped, lane, lane_s_m, ..Self::default() }
    }
}
