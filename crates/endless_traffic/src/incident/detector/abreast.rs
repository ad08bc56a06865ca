//! Lines across lanes, and who comes over them.

use endless_road::Lane;
use endless_world::SignalId;
use glam::{DVec2, DVec3};

/// Who is further above or below is on another level, metres.
const STOREY_M: f64 = 3.0;
/// Beyond the lane's edge a line reaches so far, metres.
const BEYOND_M: f64 = 0.5;

/// The end of a lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct EndLine {
    at: DVec3,
    along: DVec2,
    half_width_m: f64,
    /// The traffic light there.
    pub(super) signal: Option<SignalId>,
}

impl EndLine {
    pub(super) fn of(lane: &Lane, signal: Option<SignalId>) -> Self {
        let end = lane.centerline.length();
        Self {
            at: lane.centerline.position(end),
            along: lane.centerline.direction(end),
            half_width_m: 0.5 * lane.width_m + BEYOND_M,
            signal,
        }
    }

    /// How far a point is beyond it, metres; `None` beside it.
    pub(super) fn beyond_m(&self, point: DVec3) -> Option<f64> {
        let apart = (point - self.at).truncate();
        let beside = self.along.perp_dot(apart).abs() < self.half_width_m;
        (beside && (point.z - self.at.z).abs() < STOREY_M).then(|| apart.dot(self.along))
    }

    /// Whether a point came over it from one place to the next, by somebody who heads that way.
    pub(super) fn passed(&self, before: DVec3, now: DVec3, heading: DVec2) -> bool {
        let over = || Some(self.beyond_m(before)? < 0.0 && self.beyond_m(now)? >= 0.0);
        heading.dot(self.along) > 0.5 && over().unwrap_or(false)
    }
}
