//! Room along a kerb: for who halts there, bus or delivery.

use crate::roads::RoadTables;
use endless_road::swept::OrientedRectangle;
use endless_road::{Lane, WalkKind};
use endless_world::Side;
use endless_world::math::f64::wrap_angle;
use endless_world::math::segment::share_along;

/// A bus stop's sign, and what stands in the way there, is no further than this beside the edge of its lane, metres.
pub(crate) const BESIDE_M: f64 = 4.5;
/// The longest vehicle that halts at a kerb, metres.
const LONGEST_M: f64 = 20.0;
/// A halt is on a road that bends by no more than this along the longest bus, radians.
const STRAIGHT_RAD: f64 = 0.15;
/// Room to bodies that stand beside the lane, metres.
const CLEAR_M: f64 = 0.25;
/// Nobody leaves the lane, metres to its edge.
const EDGE_M: f64 = 0.1;
/// The kerb is within this beside the lane's middle, metres.
const KERB_M: f64 = 9.0;

/// The sign of what is to the left of a driver.
pub(crate) fn sign(side: Side) -> f64 {
    if side == Side::Left { 1.0 } else { -1.0 }
}

/// How far to the left of a lane's middle a vehicle of a width can stand that halts on a side: negative to the right, metres.
/// `kerb_m`: from the middle to where nothing of it may be.
pub(crate) fn left_m(side: Side, kerb_m: f64, width_m: f64) -> f64 {
    sign(side) * (kerb_m - 0.5 * width_m).max(0.0)
}

/// From a lane's middle to where nothing of a vehicle may be that halts there, on its left (1) or right (−1), metres: it keeps to the
/// lane, and clear of what stands beside it.
pub(crate) fn kerb_m(lane: &Lane, along: [f64; 2], left: f64, standing: &[OrientedRectangle]) -> f64 {
    clear_m(lane, along, left, standing).min(0.5 * lane.width_m - EDGE_M)
}

/// Whether a lane is straight along the longest vehicle whose front is at a place.
pub(crate) fn is_straight(lane: &Lane, front: f64) -> bool {
    let heading = |s: f64| lane.centerline.at(s).heading_rad;
    let [rear, front] = [(front - LONGEST_M).max(0.0), front.min(lane.centerline.length())];
    wrap_angle(heading(front) - heading(rear)).abs() < STRAIGHT_RAD
}

/// Metres from a place on a lane to the next junction or crossing.
pub(crate) fn room_ahead(roads: &RoadTables, lane: &Lane, s: f64) -> f64 {
    let (mut lane, mut from, mut gone) = (lane, s, 0.0);
    loop {
        let table = roads.table(lane.id);
        let cut = table.cuts.iter().filter(|cut| cut.range.1 > from).map(|cut| cut.range.0 - from).reduce(f64::min);
        if let Some(cut) = cut {
            return gone + cut;
        }
        gone += table.length - table.setback - from;
        let [next] = lane.successors[..] else { return gone };
        if roads.table(next).junction.is_some() || gone > 2.0 * LONGEST_M {
            return gone;
        }
        (lane, from) = (roads.network.lane(next), 0.0);
    }
}

/// Metres from a place on a lane back to the last junction or crossing.
pub(crate) fn room_behind(roads: &RoadTables, lane: &Lane, s: f64) -> f64 {
    let (mut lane, mut to, mut gone) = (lane, s, 0.0);
    loop {
        let cuts = roads.table(lane.id).cuts.iter().filter(|cut| cut.range.0 < to);
        if let Some(cut) = cuts.map(|cut| to - cut.range.1).reduce(f64::min) {
            return gone + cut;
        }
        gone += to;
        let [before] = lane.predecessors[..] else { return gone };
        if roads.table(before).junction.is_some() || gone > 2.0 * LONGEST_M {
            return gone;
        }
        (lane, to) = (roads.network.lane(before), roads.table(before).length);
    }
}

/// How far beside the middle of a lane, on its left (1) or right (−1), nothing stands along a part of it, metres.
pub(crate) fn clear_m(lane: &Lane, [from, to]: [f64; 2], left: f64, standing: &[OrientedRectangle]) -> f64 {
    let near = |body: &&OrientedRectangle| {
        let (s, t) = lane.centerline.project(body.center);
        let reach = body.half.length();
        s + reach > from && s - reach < to && t.abs() < 0.5 * lane.width_m + reach + BESIDE_M
    };
    let corners = |body: &OrientedRectangle| {
        [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|[x, y]| body.place(x * body.half.x, y * body.half.y))
    };
    let beside = standing.iter().filter(near).flat_map(corners).map(|corner| left * lane.centerline.project(corner).1);
    beside.filter(|beside| *beside > 0.0).fold(f64::INFINITY, f64::min) - CLEAR_M
}

/// The side on which a sidewalk runs along a lane with no other lane between: 1 left, −1 right.
pub(crate) fn kerb_side(roads: &RoadTables, lane: &Lane, s: f64) -> Option<f64> {
    let here = lane.centerline.at(s);
    let at = here.position.truncate();
    let ahead = lane.centerline.direction(s);
    let walk = &roads.network.walk;
    let mut best: Option<(f64, f64)> = None;
    for edge in walk.edges.iter().filter(|edge| edge.kind == WalkKind::Sidewalk) {
        let [a, b] = edge.nodes.map(|node| walk.nodes[node.index()].truncate());
        let along = b - a;
        let u = share_along(at, a, b);
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
