//! The lane over whose line a rider reaches who passes a queue.

use crate::across::Across;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::LaneId;
use endless_world::Side;

/// A lane beside, over whose line a body reaches.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LaneBeside {
    pub(crate) lane: LaneId,
    /// Of the origin of the body.
    pub(crate) s: f64,
    side: Side,
    away_m: f64,
}

impl LaneBeside {
    /// What takes this of the width of the body's own lane, as seen from this one.
    pub(crate) fn seen(&self, across: Across) -> Across {
        across.seen_beside(self.side, self.away_m)
    }
}

/// The lane beside on one side.
pub(super) fn neighbour(roads: &Roads, lane: LaneId, side: Side) -> Option<LaneId> {
    let lane = roads.network.lane(lane);
    match side {
        Side::Left => lane.left,
        Side::Right => lane.right,
    }
}

/// The lane beside one of those that a vehicle is on, if its body reaches over there.
pub(crate) fn lane_beside(roads: &Roads, vehicle: &Vehicle, lane: LaneId) -> Option<LaneBeside> {
    beside(roads, vehicle, lane, vehicle.filtering?.straddles?)
}

pub(super) fn beside(roads: &Roads, vehicle: &Vehicle, lane: LaneId, side: Side) -> Option<LaneBeside> {
    let other = neighbour(roads, lane, side)?;
    let s = if lane == vehicle.lane() {
        let at = roads.network.lane(lane).centerline.position(vehicle.s).truncate();
        roads.network.lane(other).centerline.project(at).0
    } else {
        0.0
    };
    let away_m = 0.5 * (roads.network.lane(lane).width_m + roads.network.lane(other).width_m);
    Some(LaneBeside { lane: other, s, side, away_m })
}
