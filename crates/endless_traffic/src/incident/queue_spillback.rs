//! Queue spillback: somebody who has broken down not far beyond a junction is queued behind, until the queue reaches back to
//! the junction.

use super::moment::{Candidate, Moment};
use super::order::{Braking, Order};
use super::standing::{place, stop_m};
use crate::occupancy::Occupant;
use endless_road::LaneId;

/// Braking of who rolls out, m/s².
const BRAKING_MPS2: f64 = 1.8;
/// Speeds at which a breakdown is noticed, m/s.
const SPEED_MPS: [f64; 2] = [3.0, 16.0];
/// Below this speed hazard lights are on, m/s.
const HAZARDS_MPS: f64 = 3.0;
/// How far beyond the junction the first of the queue stands, metres.
const BEYOND_M: [f64; 2] = [9.0, 45.0];
/// Slower than this one stands in the queue, and at its head, m/s.
const STANDS_MPS: f64 = 0.5;
const HEAD_MPS: f64 = 0.05;
/// Gap between bumpers in a queue, at most, metres.
const GAP_M: f64 = 7.0;
/// The queue has come to the junction when nobody else has room before its last, metres.
const FULL_M: f64 = 8.0;

/// Those who would stand not far beyond a junction.
pub(super) fn candidates(moment: &Moment<'_>) -> Vec<Candidate> {
    let who = |(i, vehicle): (usize, &crate::vehicle::Vehicle)| {
        if !(SPEED_MPS[0]..SPEED_MPS[1]).contains(&vehicle.speed) || vehicle.class.two_wheeled() {
            return None;
        }
        let ahead_m = stop_m(vehicle, BRAKING_MPS2);
        let (lane, s) = place(moment, i, ahead_m)?;
        let (_, before_m) = way_back(moment, lane).last().copied()?;
        let beyond_m = s + before_m - vehicle.half_length;
        let braking = Some(Braking { mps2: BRAKING_MPS2, until_s: f64::INFINITY });
        let order = Order { braking, hazards_below_mps: HAZARDS_MPS, ..Order::default() };
        let fits = (BEYOND_M[0]..BEYOND_M[1]).contains(&beyond_m);
        fits.then(|| Candidate { roles: vec![(i, order)], walk: None, junction: None, ahead_m })
    };
    moment.watched().filter_map(who).collect()
}

/// The lanes from this one back to the junction, each with the distance from its beginning to that of the first; empty if
/// none is near.
fn way_back(moment: &Moment<'_>, lane: LaneId) -> Vec<(LaneId, f64)> {
    let mut way = vec![(lane, 0.0)];
    loop {
        let (last, back_m) = way[way.len() - 1];
        let before = &moment.roads.network.lane(last).predecessors;
        if !before.is_empty() && before.iter().all(|&lane| moment.roads.table(lane).junction.is_some()) {
            return way;
        }
        let [only] = before[..] else { return Vec::new() };
        let back_m = back_m + moment.roads.table(only).length;
        if back_m > BEYOND_M[1] {
            return Vec::new();
        }
        way.push((only, back_m));
    }
}

/// While the first stands and those behind it stand back to the junction.
pub(super) fn happens(moment: &Moment<'_>, actors: &[usize]) -> bool {
    let head = &moment.vehicles[actors[0]];
    let way = way_back(moment, head.lane());
    let Some(&(_, length_m)) = way.last() else { return false };
    let stands =
        |occupant: &Occupant| moment.vehicles.get(occupant.vehicle).is_some_and(|vehicle| vehicle.speed < STANDS_MPS);
    // Metres behind the head's origin.
    let mut rear_m = head.half_length;
    let mut queued = 0;
    loop {
        let behind = way.iter().flat_map(|(lane, back_m)| {
            moment.occupancy.on(*lane).iter().map(move |occupant| (occupant, head.s + back_m))
        });
        let next = behind
            .filter(|(occupant, s)| stands(occupant) && s - occupant.middle() > rear_m)
            .map(|(occupant, s)| [s - occupant.front, s - occupant.rear])
            .min_by(|a, b| a[0].total_cmp(&b[0]));
        let Some([front_m, next_rear_m]) = next.filter(|[front_m, _]| front_m - rear_m < GAP_M) else { break };
        debug_assert!(front_m <= next_rear_m);
        rear_m = next_rear_m;
        queued += 1;
    }
    head.speed < HEAD_MPS && queued > 0 && head.s + length_m - rear_m < FULL_M
}
