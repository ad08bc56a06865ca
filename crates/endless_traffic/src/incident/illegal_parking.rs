//! Illegal parking: a vehicle pulls over to the kerb and stands on the driving lane, hazard lights on.

use super::moment::{Candidate, Moment};
use super::order::{Braking, Drift, Order};
use super::standing::{place, stop_m};
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::{Lane, WalkKind};

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
/// The kerb is within this beside the lane's middle, metres.
const KERB_M: f64 = 9.0;

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

/// The side on which a sidewalk runs along a lane with no other lane between: 1 left, −1 right.
pub(crate) fn kerb_side(roads: &Roads, lane: &Lane, s: f64) -> Option<f64> {
    let here = lane.centerline.at(s);
    let at = here.position.truncate();
    let ahead = lane.centerline.direction(s);
    let walk = &roads.network.walk;
    let mut best: Option<(f64, f64)> = None;
    for edge in walk.edges.iter().filter(|edge| edge.kind == WalkKind::Sidewalk) {
        let [a, b] = edge.nodes.map(|node| walk.nodes[node.index()].truncate());
        let along = b - a;
        let u = ((at - a).dot(along) / along.length_squared().max(1e-9)).clamp(0.0, 1.0);
        let beside = a + along * u - at;
        let distance = beside.length();
        if distance < KERB_M && best.is_none_or(|(nearest, _)| distance < nearest) {
            best = Some((distance, ahead.perp_dot(beside).signum()));
        }
    }
    let (_, side) = best?;
    let beside = if side > 0.0 { lane.left } else { lane.right };
    beside.is_none().then_some(side)
}
