//! A bay at a kerb in which drivers park.

use crate::bay_way::BayWay;
use crate::kerb_halt::KerbHalt;
use crate::vehicle::Vehicle;
use endless_road::LaneId;
use endless_road::swept::OrientedRectangle;
use endless_world::{ParkingBay, Side};
use glam::DVec2;

/// Who stands this near may be in the way of who pulls in or out, metres.
pub(crate) const NEAR_M: f64 = 32.0;
/// From a body in a bay to the bay's inner edge, metres; and to the edge of the lane, along which riders pass queues.
const INNER_M: f64 = 0.05;
const OFF_LANE_M: f64 = 0.02;

/// A bay in which drivers park.
#[derive(Debug, Clone)]
pub(crate) struct ParkingPlace {
    pub(crate) lane: LaneId,
    /// Of its middle, on the lane.
    pub(crate) s: f64,
    /// From the middle of the lane, positive to the left, metres.
    pub(crate) left_m: f64,
    /// From the middle of the lane to its edge, metres.
    pub(crate) edge_m: f64,
    pub(crate) side: Side,
    pub(crate) at: DVec2,
    pub(crate) room: DVec2,
    /// What stands near by, and the bays there.
    pub(crate) standing: Vec<OrientedRectangle>,
    pub(crate) bays: Vec<OrientedRectangle>,
}

impl ParkingPlace {
    /// A halt there of a vehicle that is so far before it, metres.
    pub(crate) fn halt(&self, way: BayWay, me: &Vehicle, ahead_m: f64, stands_s: f64) -> KerbHalt {
        let front = (self.lane, self.s + me.half_length, ahead_m);
        let place = (self.side, self.stands_left_m(2.0 * me.half_width));
        KerbHalt::new(me.driver.lateral_m, front, place, stands_s).in_bay(way)
    }

    /// Where the middle of a vehicle of a width stands, from the middle of the lane, positive to the left, metres: rather clear of
    /// the kerb, over which a corner swings on the way in, than of the bay's other edge, but on no lane.
    pub(crate) fn stands_left_m(&self, width_m: f64) -> f64 {
        let spare_m = (0.5 * (self.room.y - width_m) - INNER_M).max(0.0);
        let aside_m = (self.left_m.abs() - spare_m).max(self.edge_m + OFF_LANE_M + 0.5 * width_m);
        self.left_m.signum() * aside_m
    }

    /// What somebody may sweep who pulls in or out.
    pub(crate) fn swept(&self, bay: &OrientedRectangle) -> OrientedRectangle {
        OrientedRectangle { half: DVec2::new(NEAR_M, bay.half.y), ..*bay }
    }
}

/// A bay seen from above.
pub(crate) fn body(bay: &ParkingBay) -> OrientedRectangle {
    let half = 0.5 * DVec2::new(f64::from(bay.length_m), f64::from(bay.width_m));
    OrientedRectangle::of(half, bay.position.as_dvec3().truncate(), f64::from(bay.yaw_rad))
}
