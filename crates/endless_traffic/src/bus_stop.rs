//! Where buses stop: places of stops' signs, and the halts on the lanes beside them.

use crate::kerb_room::{BESIDE_M, clear_m, is_straight, kerb_m, left_m, room_ahead, room_behind, sign};
use crate::roads::RoadTables;
use endless_road::swept::OrientedRectangle;
use endless_road::{Lane, LaneId};
use endless_world::{BusStop, Side};

/// From a bus's foremost point back to the middle of its front door, metres.
pub(crate) const DOOR_M: f64 = 1.15;
/// Who is further above or below is on another level, metres.
const STOREY_M: f64 = 2.5;
/// A bus at a stop is so far before a junction's line or a crossing at least, metres, and so far beyond the last one.
const BEFORE_LINE_M: f64 = 4.0;
const BEYOND_M: f64 = 2.0;
/// Shorter room than for the shortest bus is none, metres.
const SHORTEST_M: f64 = 7.0;
/// Along these metres before and beyond a halt a bus may be beside its usual way.
pub(crate) const BESIDE_ALONG_M: [f64; 2] = [45.0, 40.0];
/// Half the room that people need at a door, metres.
const DOOR_ROOM_M: f64 = 1.0;
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
        left_m(self.side, self.kerb_m, width_m)
    }
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
    let kerb_m = kerb_m(lane, [s - BESIDE_ALONG_M[0], s + BESIDE_ALONG_M[1]], left, standing);
    let is_open = clear_m(lane, [s - DOOR_ROOM_M, s + DOOR_ROOM_M], left, standing) > 0.5 * lane.width_m + BESIDE_M;
    usable.then_some(BusHalt { stop, lane: lane.id, s, room_m, side: place.side, kerb_m, is_open })
}
