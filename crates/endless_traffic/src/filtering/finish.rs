//! How riders get back into the queue, or ahead of it.

use super::precedence::{CLEAR_M, STAYS_MPS};
use super::view::RiderView;
use super::way::{Filtering, drift_length_m};
use crate::occupancy::{Leader, Leaders, Occupant};
use crate::vehicle::Vehicle;
use endless_road::LaneId;

/// Those who can still be passed are looked for so far ahead, metres.
const AHEAD_M: f64 = 14.0;
/// Gaps to those ahead and behind, metres.
const GAP_M: f64 = 1.2;
/// Time for which those behind may come nearer meanwhile, seconds: they see the rider ahead all along.
const CLOSES_S: f64 = 0.5;

/// Whether somebody who passes a queue finds a gap to get back into, and has nobody to pass any more: those beyond whoever stands in
/// the way do not count.
pub(super) fn may(view: &RiderView<'_>, vehicles: &[Vehicle], i: usize, way: Filtering) -> bool {
    let me = &vehicles[i];
    let leaders = view.occupancy.leaders(view.roads, me, i, AHEAD_M + me.half_length);
    if leaders.passed_m.is_some_and(|passed_m| !is_barred(me, &leaders, passed_m)) || leaders.beside.is_some() {
        return false;
    }
    if let Some(ahead) = leaders.ahead {
        let share = ((me.speed - ahead.speed) / me.speed.max(0.1)).clamp(0.0, 1.0);
        let closes_m = share * drift_length_m(way.drift.left_m, me.speed.max(2.0));
        if ahead.gap < GAP_M + closes_m {
            return false;
        }
    }
    behind(view, me).filter(|(o, _)| o.vehicle != i).all(|(o, base)| {
        let gap_m = -me.half_length - (base + o.front);
        gap_m > GAP_M + CLOSES_S * (o.speed - me.speed).max(0.0)
    })
}

/// Whether a rider stands behind somebody who stands, too, before all whom it could pass, the nearest so far ahead, metres.
fn is_barred(me: &Vehicle, leaders: &Leaders, passed_m: f64) -> bool {
    let stands = |ahead: Leader| ahead.speed < STAYS_MPS && ahead.gap < passed_m;
    me.speed < STAYS_MPS && leaders.ahead.is_some_and(stands)
}

/// Metres to the next road beyond a junction, where there may be no room but in the lane.
pub(super) fn room_m(view: &RiderView<'_>, me: &Vehicle) -> f64 {
    let inside = |lane: LaneId| view.roads.table(lane).junction.is_some();
    let beyond = me.ahead(view.roads).skip_while(|(lane, _)| !inside(*lane)).find(|(lane, _)| !inside(*lane));
    beyond.map_or(f64::INFINITY, |(_, base)| base)
}

/// Those on the lanes that the body is on, and on the lanes before, whose middle is behind, with the distance from the origin to
/// the beginning of each one's lane.
fn behind<'a>(view: &'a RiderView<'_>, me: &'a Vehicle) -> impl Iterator<Item = (&'a Occupant, f64)> {
    let here = me.lane();
    let lane = view.roads.network.lane(here);
    let before = lane.predecessors.iter().map(|&before| (before, -me.s - view.roads.table(before).length));
    let lanes: Vec<(LaneId, f64)> = std::iter::once((here, -me.s)).chain(before).collect();
    let all = lanes.into_iter().flat_map(|(lane, base)| view.occupancy.on(lane).iter().map(move |o| (o, base)));
    let usual = move |o: &Occupant| o.filters && me.across().is_clear_of(&o.across, CLEAR_M);
    all.filter(move |(o, base)| base + o.middle() <= 0.0 && !usual(o))
}
