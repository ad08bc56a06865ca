//! Illegal parking: a vehicle pulls over to the kerb and stands on the driving lane, hazard lights on.

use super::moment::{Candidate, Moment};
use super::order::{Braking, Drift, Order};
use super::standing::{place, stop_m};
use crate::kerb_room::kerb_side;
use crate::vehicle::Vehicle;

/// Braking of who pulls over, m/s².
const BRAKING_MPS2: f64 = 1.6;
/// Speeds at which somebody makes up their mind, m/s.
const SPEED_MPS: [f64; 2] = [4.0, 15.0];
/// Pulling over is done after this share of the way to the place.
const PULLS_OVER: f64 = 0.7;
/// Room left to the lane's edge, metres.
const EDGE_M: f64 = 0.1;
/// Who cannot come so far from the lane's middle drives on, metres.
const LEAST_ASIDE_M: f64 = 0.45;
/// Who stands so far beside the lane's middle is at its edge, metres.
const ASIDE_M: f64 = 0.38;

/// Those who drive along a kerb and have room to stand there.
pub(super) fn candidates(moment: &Moment<'_>) -> Vec<Candidate> {
    let who = |(i, vehicle): (usize, &Vehicle)| {
        if !(SPEED_MPS[0]..SPEED_MPS[1]).contains(&vehicle.speed) || vehicle.class.two_wheeled() {
            return None;
        }
        let stop_m = stop_m(vehicle, BRAKING_MPS2);
        let (lane, s) = place(moment, i, stop_m)?;
        let lane = moment.roads.network.lane(lane);
        let side = kerb_side(moment.roads, lane, s)?;
        let width_m = f64::from(moment.roads.specs[vehicle.asset.model.index()].width_m);
        let room_m = 0.5 * (lane.width_m - width_m) - EDGE_M;
        let left_m = side * room_m - vehicle.driver.lateral_m;
        if room_m < LEAST_ASIDE_M {
            return None;
        }
        let drift = Some(Drift { begin_m: vehicle.rolled, length_m: PULLS_OVER * stop_m, left_m, back_m: None });
        let braking = Some(Braking { mps2: BRAKING_MPS2, until_s: f64::INFINITY });
        let order = Order { braking, drift, hazards_below_mps: f64::INFINITY, ..Order::default() };
        Some(Candidate { roles: vec![(i, order)], walk: None, junction: None, ahead_m: stop_m })
    };
    moment.watched().filter_map(who).collect()
}

/// Whether somebody has come to the edge: who stops short does not park.
pub(super) fn is_aside(moment: &Moment<'_>, actors: &[usize]) -> bool {
    let vehicle = &moment.vehicles[actors[0]];
    let middle = vehicle.pose.position.as_dvec3().truncate();
    moment.roads.network.lane(vehicle.lane()).centerline.project(middle).1.abs() > ASIDE_M
}
