//! How riders get beside a queue.

use super::lane_beside::{beside, neighbour};
use super::precedence::{BEHIND_M, QUEUES_MPS, ROOM_M, waits};
use super::view::RiderView;
use super::way::{Filtering, drift_length_m};
use crate::across::Across;
use crate::incident::Drift;
use crate::lane_change::{SAFE_BRAKING, STRAIGHT_RADIUS_M};
use crate::occupancy::Leader;
use crate::vehicle::Vehicle;
use endless_road::swept::OrientedRectangle;
use endless_road::{LaneId, TrafficControl};
use endless_world::math::f64::sin_cos;
use endless_world::{Side, SignalAspect};
use glam::DVec2;

/// Queues are looked at this far ahead, metres.
const SEEN_M: f64 = 90.0;
/// Room kept to the edge of the road, metres.
const EDGE_M: f64 = 0.1;
/// Beside the lanes inside a junction there is as much room, metres.
const BESIDE_WAY_M: f64 = 0.5;
/// Nobody begins faster, m/s.
const FASTEST_MPS: f64 = 12.0;
/// Who comes to the queue no faster than this will soon be in it, m/s.
const COMES_MPS: f64 = 8.0;
/// Who is faster gets beside somebody while both still move, m/s.
const ROLLS_MPS: f64 = 3.0;
/// Distance between places that are asked for parked vehicles, metres, and how far one of those reaches.
const PLACE_M: f64 = 1.5;
const PARKED_REACH_M: f64 = 15.0;

/// The lanes from here to the line, each with the distance to its beginning, if the light there is not green.
fn way_to_line(view: &RiderView<'_>, me: &Vehicle) -> Option<Vec<(LaneId, f64)>> {
    let roads = view.roads;
    let way: Vec<(LaneId, f64)> =
        me.ahead(roads).take_while(|(lane, base)| *base < SEEN_M && roads.table(*lane).junction.is_none()).collect();
    let straight = way.iter().all(|(lane, _)| {
        let table = roads.table(*lane);
        table.radius >= STRAIGHT_RADIUS_M && table.alongside.is_empty()
    });
    let (last, _) = *way.last()?;
    (straight && waits_at(view, last)).then_some(way)
}

/// Whether the light at the end of a lane is not green.
fn waits_at(view: &RiderView<'_>, lane: LaneId) -> bool {
    match view.roads.network.lane(lane).end_control {
        TrafficControl::Signal(signal) => view.signals[usize::from(signal.0)].aspect != SignalAspect::Green,
        _ => false,
    }
}

/// A way past the queue ahead, if there is one.
pub(super) fn look(view: &RiderView<'_>, vehicles: &[Vehicle], i: usize) -> Option<Filtering> {
    let me = &vehicles[i];
    let busy = me.shift.is_some() || me.intent.is_some() || me.order.is_some() || !me.rights_of_way.is_empty();
    if busy || me.speed > FASTEST_MPS || view.roads.table(me.lane()).junction.is_some() {
        return None;
    }
    let leader = view.occupancy.leaders(view.roads, me, i, SEEN_M).ahead?;
    if leader.speed > COMES_MPS {
        return None;
    }
    let way = way_to_line(view, me)?;
    let sides = [Side::Left, Side::Right].map(|side| Passage::on(view, vehicles, i, &way, side, leader));
    sides
        .into_iter()
        .flatten()
        .max_by_key(|passage| (passage.passed, passage.straddles))
        .map(|passage| Filtering { drift: passage.drift, straddles: passage.straddles.then_some(passage.side) })
}

/// A way past a queue on one side.
struct Passage {
    side: Side,
    straddles: bool,
    drift: Drift,
    /// How many can be passed.
    passed: usize,
}

impl Passage {
    fn on(
        view: &RiderView<'_>,
        vehicles: &[Vehicle],
        i: usize,
        way: &[(LaneId, f64)],
        side: Side,
        leader: Leader,
    ) -> Option<Self> {
        let (roads, me) = (view.roads, &vehicles[i]);
        let lanes_beside: Option<Vec<LaneId>> = way.iter().map(|(lane, _)| neighbour(roads, *lane, side)).collect();
        let straddles = lanes_beside.is_some();
        // Where those beside may go, nobody rides among them.
        if lanes_beside.is_some_and(|lanes| lanes.last().is_some_and(|lane| !waits_at(view, *lane))) {
            return None;
        }
        let half_m = |lane: LaneId| 0.5 * roads.network.lane(lane).width_m;
        // Beyond the line the way may be narrower than before it.
        let beyond_m = me.ahead(roads).nth(way.len()).map_or(f64::INFINITY, |(lane, _)| half_m(lane) + BESIDE_WAY_M);
        let half_m = way.iter().map(|(lane, _)| half_m(*lane)).fold(beyond_m, f64::min);
        let edge_m = if straddles { half_m } else { half_m - me.half_width - EDGE_M };
        let place_m = if side == Side::Left { edge_m } else { -edge_m };
        let left_m = place_m - me.driver.lateral_m;
        let length_m = drift_length_m(left_m, me.speed);
        let both_move = leader.speed > QUEUES_MPS && me.speed > ROLLS_MPS;
        if leader.gap < length_m + BEHIND_M && !both_move {
            return None;
        }
        let goal = Across::between(place_m, place_m, me.half_width);
        let (passed, reach_m) = passable(view, vehicles, i, way, &goal);
        if passed == 0 {
            return None;
        }
        let room = if straddles {
            is_free_beside(view, vehicles, i, way, side, reach_m, &goal)
        } else {
            // When the queue gets on, the rider keeps to the edge until there is a gap, at the line perhaps.
            let to_line_m = way.last().map_or(reach_m, |(lane, base)| base + roads.table(*lane).length);
            is_free_of_parked(view, vehicles, i, way, place_m, to_line_m.max(reach_m))
        };
        let drift = Drift { begin_m: me.rolled, length_m, left_m, back_m: None };
        room.then_some(Self { side, straddles, drift, passed })
    }
}

/// How many of those ahead can be passed one after the other, and how far ahead the front of the last of them is, metres.
fn passable(
    view: &RiderView<'_>,
    vehicles: &[Vehicle],
    i: usize,
    way: &[(LaneId, f64)],
    goal: &Across,
) -> (usize, f64) {
    let comes = |other: usize| vehicles.get(other).is_some_and(|them| waits(them) && them.speed < COMES_MPS);
    let mut ahead: Vec<(f64, f64, bool)> = way
        .iter()
        .flat_map(|&(lane, base)| view.occupancy.on(lane).iter().map(move |o| (base, o)))
        .filter(|(base, o)| o.vehicle != i && base + o.middle() > 0.0)
        .map(|(base, o)| (base + o.rear, base + o.front, comes(o.vehicle) && goal.is_clear_of(&o.across, ROOM_M)))
        .collect();
    ahead.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut passed: Vec<f64> = ahead.iter().take_while(|o| o.2).map(|o| o.1).collect();
    // Who is on two lanes one after the other is there twice.
    passed.dedup();
    (passed.len(), passed.last().map_or(0.0, |front| front + vehicles[i].half_length))
}

/// Whether all on the lane beside leave room, up to so far ahead, and those who come from behind see the rider in time.
fn is_free_beside(
    view: &RiderView<'_>,
    vehicles: &[Vehicle],
    i: usize,
    way: &[(LaneId, f64)],
    side: Side,
    reach_m: f64,
    goal: &Across,
) -> bool {
    let me = &vehicles[i];
    way.iter().all(|&(lane, base)| {
        let Some(beside) = beside(view.roads, me, lane, side) else { return false };
        let base = if lane == me.lane() { -beside.s } else { base };
        let goal = beside.seen(*goal);
        view.occupancy.on(beside.lane).iter().filter(|o| o.vehicle != i && base + o.rear < reach_m).all(|o| {
            let behind_m = -me.half_length - (base + o.front);
            if behind_m < 0.0 {
                return o.speed < COMES_MPS && goal.is_clear_of(&o.across, ROOM_M);
            }
            let sees = |them: &Vehicle| them.driver.follow(them.speed, behind_m, me.speed) > -SAFE_BRAKING;
            vehicles.get(o.vehicle).is_some_and(|them| sees(them) || o.speed < QUEUES_MPS)
        })
    })
}

/// Whether no parked vehicle reaches into the way at the edge of the road, up to so far ahead.
fn is_free_of_parked(
    view: &RiderView<'_>,
    vehicles: &[Vehicle],
    i: usize,
    way: &[(LaneId, f64)],
    place_m: f64,
    reach_m: f64,
) -> bool {
    let me = &vehicles[i];
    let here = me.pose.position.as_dvec3().truncate();
    let near = |body: &OrientedRectangle| body.center.distance(here) < reach_m + PARKED_REACH_M;
    // Those of the town, and those who have parked since.
    let since = vehicles.iter().filter(|other| other.is_parked());
    let since = since.map(|other| other.footprint(&view.roads.specs, 0.5 * EDGE_M));
    let parked: Vec<OrientedRectangle> = view.parked.iter().copied().chain(since).filter(near).collect();
    if parked.is_empty() {
        return true;
    }
    let spec = &view.roads.specs[me.asset.model.index()];
    let places = (0..).map(|k| f64::from(k) * PLACE_M).take_while(|ahead_m| *ahead_m < reach_m);
    places.into_iter().all(|ahead_m| {
        let on = way.iter().rev().find(|(_, base)| *base <= ahead_m).copied().unwrap_or(way[0]);
        let at = view.roads.network.lane(on.0).centerline.at(ahead_m - on.1);
        let (sin, cos) = sin_cos(at.heading_rad);
        let place = at.position.truncate() + DVec2::new(-sin, cos) * place_m;
        let body = OrientedRectangle::new(spec, place, at.heading_rad, 0.0);
        parked.iter().all(|other| !other.overlaps(&body))
    })
}
