//! Where buses stop: places of stops' signs, and the halts on the lanes beside them.

use crate::roads::RoadTables;
use endless_road::swept::OrientedRectangle;
use endless_road::{Lane, LaneId};
use endless_world::math::f64::wrap_angle;
use endless_world::{BusStop, Side};

/// From a bus's foremost point back to the middle of its front door, metres.
pub(crate) const DOOR_M: f64 = 1.15;
/// A sign is no further than this beside the edge of the lane on which its buses halt, metres.
const BESIDE_M: f64 = 4.5;
/// Who is further above or below is on another level, metres.
const STOREY_M: f64 = 2.5;
/// A bus at a stop is so far before a junction's line or a crossing at least, metres, and so far beyond the last one.
const BEFORE_LINE_M: f64 = 4.0;
const BEYOND_M: f64 = 2.0;
/// The longest bus, metres; shorter room than for the shortest is none.
const LONGEST_M: f64 = 20.0;
const SHORTEST_M: f64 = 7.0;
/// A halt is on a road that bends by no more than this along the longest bus, radians.
const STRAIGHT_RAD: f64 = 0.15;
/// Along these metres before and beyond a halt a bus may be beside its usual way.
pub(crate) const BESIDE_ALONG_M: [f64; 2] = [45.0, 40.0];
/// Half the room that people need at a door, metres.
const DOOR_ROOM_M: f64 = 1.0;
/// Room to bodies that stand beside the lane, metres.
const CLEAR_M: f64 = 0.25;
/// A bus does not leave its lane, metres to its edge.
const EDGE_M: f64 = 0.1;

/// A place on a lane where buses halt.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BusHalt {
    /// Of the stop, in the list of all.
    pub(crate) stop: usize,
    pub(crate) lane: LaneId,
    /// Of the sign, on the lane.
    pub(crate) s: f64,
    /// Room for a bus behind its front bumper, metres.
    room_m: f64,
    pub(crate) side: Side,
    /// From the lane's middle to where nothing of a bus may be, on the side of the kerb, metres.
    pub(crate) kerb_m: f64,
    /// Whether nothing stands between the door of a bus and the sidewalk.
    pub(crate) is_open: bool,
}

/// All halts, by lane.
#[derive(Debug, Clone, Default)]
pub(crate) struct BusHalts(Vec<BusHalt>);

impl BusHalts {
    /// At those of some stops where a bus can stand without being in the way of a junction, a crossing, or what stands there.
    pub(crate) fn new(roads: &RoadTables, stops: &[BusStop], standing: &[OrientedRectangle]) -> Self {
        let halt = |(number, stop): (usize, &BusStop)| halt(roads, number, stop, standing);
        let mut halts: Vec<BusHalt> = stops.iter().enumerate().filter_map(halt).collect();
        halts.sort_by(|a, b| a.lane.cmp(&b.lane).then(a.s.total_cmp(&b.s)));
        Self(halts)
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(crate) fn on(&self, lane: LaneId) -> &[BusHalt] {
        let from = self.0.partition_point(|halt| halt.lane < lane);
        let number = self.0[from..].partition_point(|halt| halt.lane == lane);
        &self.0[from..from + number]
    }
}

impl BusHalt {
    /// Where the front bumper of a bus is whose door is at the sign, on the lane.
    pub(crate) fn front(&self) -> f64 {
        self.s + DOOR_M
    }

    /// Whether there is room for a bus of this length.
    pub(crate) fn takes(&self, length_m: f64) -> bool {
        length_m <= self.room_m
    }

    /// How far to the left of the lane's middle a bus of this width can stand: negative to the right, metres.
    pub(crate) fn left_m(&self, width_m: f64) -> f64 {
        let aside = (self.kerb_m - 0.5 * width_m).max(0.0);
        if self.side == Side::Left { aside } else { -aside }
    }
}

/// The sign of what is to the left of a driver.
pub(crate) fn sign(side: Side) -> f64 {
    if side == Side::Left { 1.0 } else { -1.0 }
}

fn halt(roads: &RoadTables, stop: usize, place: &BusStop, standing: &[OrientedRectangle]) -> Option<BusHalt> {
    let at = place.position.as_dvec3();
    let left = sign(place.side);
    let beside = |lane: &'_ Lane| -> Option<(f64, f64, LaneId)> {
        let kerb_side = if place.side == Side::Left { lane.left } else { lane.right };
        if lane.junction.is_some() || kerb_side.is_some() {
            return None;
        }
        let (s, t) = lane.centerline.project(at.truncate());
        let beyond = left * t - 0.5 * lane.width_m;
        let level = (lane.centerline.position(s).z - at.z).abs() < STOREY_M;
        let inside = s > 0.0 && s < lane.centerline.length();
        (level && inside && beyond > 0.0 && beyond < BESIDE_M).then_some((beyond, s, lane.id))
    };
    let (_, s, lane) = roads.network.lanes.iter().filter_map(beside).min_by(|a, b| a.0.total_cmp(&b.0))?;
    let (lane, front) = (roads.network.lane(lane), s + DOOR_M);
    if room_ahead(roads, lane, front) < BEFORE_LINE_M {
        return None;
    }
    let room_m = room_behind(roads, lane, front) - BEYOND_M;
    let usable = room_m > SHORTEST_M && is_straight(lane, front);
    let kerb_m =
        clear_m(lane, [s - BESIDE_ALONG_M[0], s + BESIDE_ALONG_M[1]], left, standing).min(0.5 * lane.width_m - EDGE_M);
    let is_open = clear_m(lane, [s - DOOR_ROOM_M, s + DOOR_ROOM_M], left, standing) > 0.5 * lane.width_m + BESIDE_M;
    usable.then_some(BusHalt { stop, lane: lane.id, s, room_m, side: place.side, kerb_m, is_open })
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
