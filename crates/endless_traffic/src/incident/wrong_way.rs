//! Driving the wrong way: somebody goes over to the lane of those who come the other way, drives on it for a while, and
//! comes back.

use super::moment::{Candidate, Moment};
use super::order::{Drift, Order};
use crate::occupancy::Occupancy;
use crate::roads::Roads;
use crate::vehicle::{LaneCover, Vehicle};
use endless_road::{Lane, LaneId};

/// Speeds of those who do, m/s.
const SPEED_MPS: [f64; 2] = [3.0, 15.0];
/// Ways to go over and to come back take so many seconds, and at least so many metres.
const OVER_S: f64 = 2.4;
const OVER_M: f64 = 13.0;
/// How long they stay there, seconds.
const STAYS_S: [f64; 3] = [1.0, 2.0, 3.5];
/// Lanes side by side are no further apart than their widths ask for, but this, metres.
const SPARE_M: f64 = 0.7;
/// Left of their lane when they are back, metres.
const LEFT_M: f64 = 4.0;
/// Whose headings differ by more go opposite ways: the cosine.
const OPPOSITE: f64 = -0.97;
/// It is looked for the opposite lane every so many metres.
const STEP_M: f64 = 10.0;

/// Those who have a lane of the opposite direction beside theirs, for long enough.
pub(super) fn candidates(moment: &Moment<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (i, vehicle) in moment.watched() {
        let table = moment.roads.table(vehicle.lane());
        let free = vehicle.order.is_none() && vehicle.shift.is_none() && !vehicle.long() && vehicle.trailer.is_none();
        if !free || table.junction.is_some() || !(SPEED_MPS[0]..SPEED_MPS[1]).contains(&vehicle.speed) {
            continue;
        }
        for stays_s in STAYS_S {
            let over_m = (OVER_S * vehicle.speed).max(OVER_M);
            let stays_m = stays_s * vehicle.speed;
            let way_m = 2.0 * over_m + stays_m;
            if vehicle.s + way_m + LEFT_M > table.length {
                continue;
            }
            let Some((opposite, left_m)) = opposite_lane(moment.roads, vehicle, way_m) else { continue };
            let left_m = left_m - vehicle.driver.lateral_m;
            let back_m = Some(vehicle.rolled + over_m + stays_m);
            let drift = Some(Drift { begin_m: vehicle.rolled, length_m: over_m, left_m, back_m });
            let order = Order { drift, opposite: Some(opposite), ..Order::default() };
            found.push(Candidate { roles: vec![(i, order)], walk: None, junction: None, ahead_m: 0.5 * over_m });
        }
    }
    found
}

/// The lane beside a vehicle's on which others come, all along the way, and how far to the left its middle is, metres.
fn opposite_lane(roads: &Roads, vehicle: &Vehicle, way_m: f64) -> Option<(LaneId, f64)> {
    let own = roads.network.lane(vehicle.lane());
    let beside = |lane: &Lane, s: f64| {
        let here = own.centerline.at(s);
        let (there, _) = lane.centerline.project(here.position.truncate());
        let on = lane.centerline.position(there);
        let apart = on - here.position;
        let inside = there > 1.0 && there < lane.centerline.length() - 1.0;
        let opposite = lane.centerline.direction(there).dot(own.centerline.direction(s)) < OPPOSITE;
        let near = apart.truncate().length() < 0.5 * (own.width_m + lane.width_m) + SPARE_M && apart.z.abs() < 1.0;
        let left_m = own.centerline.direction(s).perp_dot(apart.truncate());
        (inside && opposite && near && lane.junction.is_none()).then_some(left_m)
    };
    let first = roads.network.lanes.iter().find_map(|lane| Some((lane, beside(lane, vehicle.s)?)));
    let (lane, left_m) = first?;
    let steps = (way_m / STEP_M).ceil() as u32;
    let all = (0..=steps).all(|k| beside(lane, vehicle.s + way_m * f64::from(k) / f64::from(steps)).is_some());
    all.then_some((lane.id, left_m))
}

/// Whether they are nearer to the middle of the other lane than to that of their own.
pub(super) fn happens(moment: &Moment<'_>, actors: &[usize]) -> bool {
    let vehicle = &moment.vehicles[actors[0]];
    let middle = vehicle.pose.position.as_dvec3().truncate();
    let beside_m = |lane: LaneId| moment.roads.network.lane(lane).centerline.project(middle).1.abs();
    let opposite = vehicle.order.and_then(|order| order.opposite);
    opposite.is_some_and(|opposite| beside_m(opposite) < beside_m(vehicle.lane()))
}

/// Those who come the other way see who is on their lane, or soon will be: as something that stands there.
pub(crate) fn occupy(roads: &Roads, vehicles: &[Vehicle], occupancy: &mut Occupancy) {
    for (i, vehicle) in vehicles.iter().enumerate() {
        let Some((order, drift)) = vehicle.order.and_then(|order| Some((order, order.drift?))) else { continue };
        let Some(opposite) = order.opposite.filter(|_| !drift.is_over(vehicle.rolled)) else { continue };
        let (s, _) = roads.network.lane(opposite).centerline.project(vehicle.pose.position.as_dvec3().truncate());
        // Its front is towards them.
        let soon_m = drift.left_to_go_m(vehicle.rolled).min(SEEN_AHEAD_S * vehicle.speed);
        let cover =
            LaneCover { lane: opposite, rear: s - vehicle.half_length - soon_m, front: s + vehicle.half_length };
        occupancy.put(i, cover, 0.0);
    }
}

/// Others see this far ahead where somebody comes on their lane, seconds.
const SEEN_AHEAD_S: f64 = 2.0;
