//! Running a red light: a driver takes no notice of one signal, and gives way as if it were green, or not even that.

use super::moment::{Candidate, Moment};
use super::order::Order;
use crate::vehicle::Vehicle;
use endless_road::{JunctionId, TrafficControl};
use endless_world::SignalId;

/// Who comes is faster than this, m/s.
const LEAST_MPS: f64 = 4.0;
/// Time to the line of who comes, seconds: the driver has not begun to brake hard yet, and will soon be there.
const ARRIVAL_S: [f64; 2] = [0.7, 8.0];
/// Who stands at the line so near, metres, has lost patience when it has been red for so long, and will be, seconds.
const AT_THE_LINE_M: f64 = 3.0;
const STANDS_MPS: f64 = 0.3;
const PATIENCE_S: f64 = 4.5;
const STAYS_RED_S: f64 = 3.0;

/// Those who come to a light that will be red, or wait at one, with nobody before them.
pub(super) fn candidates(moment: &Moment<'_>) -> Vec<Candidate> {
    let found = moment.watched().filter_map(|(i, vehicle)| first_at_red(moment, i, vehicle));
    let both = found.flat_map(|(i, signal, junction, ahead_m)| {
        [false, true].map(|heedless| {
            let order = Order { runs: Some(signal), heedless, ..Order::default() };
            Candidate { roles: vec![(i, order)], walk: None, junction: Some(junction), ahead_m }
        })
    });
    both.collect()
}

/// The light that somebody comes to or waits at, its junction, and the distance, if nobody is before them and it is red.
fn first_at_red(moment: &Moment<'_>, i: usize, vehicle: &Vehicle) -> Option<(usize, SignalId, JunctionId, f64)> {
    if vehicle.order.is_some() {
        return None;
    }
    let mut ahead = vehicle.ahead(moment.roads).peekable();
    while let Some((lane, _)) = ahead.next() {
        let &(next, line_m) = ahead.peek()?;
        let Some(junction) = moment.roads.table(next).junction else { continue };
        let TrafficControl::Signal(signal) = moment.roads.network.lane(lane).end_control else { return None };
        let distance_m = line_m - vehicle.half_length;
        let leader = moment.occupancy.leader(moment.roads, moment.vehicles, i, line_m);
        let first = leader.is_none_or(|leader| leader.gap > distance_m);
        let arrival_s = distance_m / vehicle.speed.max(0.1);
        let comes = vehicle.speed > LEAST_MPS
            && (ARRIVAL_S[0]..ARRIVAL_S[1]).contains(&arrival_s)
            && moment.is_red(signal, [arrival_s - 1.0, arrival_s]);
        let waits = vehicle.speed < STANDS_MPS
            && distance_m < AT_THE_LINE_M + moment.roads.table(lane).setback
            && moment.is_red(signal, [-PATIENCE_S, 0.0])
            && moment.is_red(signal, [0.0, STAYS_RED_S]);
        return (first && (comes || waits)).then_some((i, signal, junction, line_m));
    }
    None
}

/// From when the front passes the line, after it has been red for a second, to when the rear has left the junction.
pub(super) fn happens(moment: &Moment<'_>, actors: &[usize], junction: Option<JunctionId>, begun: bool) -> bool {
    let Some(junction) = junction else { return false };
    let vehicle = &moment.vehicles[actors[0]];
    let inside = vehicle.right_of_way_at(junction).is_some_and(|right_of_way| {
        let covers = |lane| moment.occupancy.covers_any(actors[0], &[lane]);
        right_of_way.lanes.iter().any(|&lane| covers(lane))
    });
    let runs = vehicle.order.and_then(|order| order.runs);
    inside && (begun || runs.is_some_and(|signal| moment.is_red(signal, [-1.0, 0.0])))
}
