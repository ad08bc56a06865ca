//! A walk straight over a road.

use endless_road::{LaneId, WalkEdgeId};
use glam::DVec2;

/// Who crosses a road hurries: factor on their pace, and the most, m/s.
const HURRIES: f64 = 1.25;
const MOST_MPS: f64 = 2.2;

/// A lane that the way crosses.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CrossedLane {
    pub(crate) lane: LaneId,
    pub(crate) s: f64,
    /// Where its middle is on the way, metres.
    pub(crate) along_m: f64,
    pub(crate) half_width_m: f64,
    /// Of the road, metres.
    pub(crate) height_m: f64,
}

/// A way straight over a road.
#[derive(Debug, Clone)]
pub(crate) struct RoadWalk {
    pub(super) across: DVec2,
    pub(super) way_m: f64,
    /// The sidewalk to which it leads.
    pub(super) edge: WalkEdgeId,
    pub(super) lanes: Vec<CrossedLane>,
    /// Where the road begins and ends on the way, metres.
    pub(super) road_m: [f64; 2],
    pub(super) gone_m: f64,
    pub(super) pace_mps: f64,
    pub(super) speed_mps: f64,
}

impl RoadWalk {
    pub(crate) fn new(
        pace_mps: f64,
        across: DVec2,
        way_m: f64,
        edge: usize,
        lanes: Vec<CrossedLane>,
        road_m: [f64; 2],
    ) -> Self {
        let pace_mps = (HURRIES * pace_mps).min(MOST_MPS);
        let edge = WalkEdgeId(edge as u32);
        Self { across, way_m, edge, lanes, road_m, gone_m: 0.0, pace_mps, speed_mps: 0.0 }
    }

    pub(crate) fn is_on_road(&self) -> bool {
        (self.road_m[0]..=self.road_m[1]).contains(&self.gone_m)
    }
}
