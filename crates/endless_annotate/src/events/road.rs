//! What relations and events need to know of roads and of who uses them.

use endless_world::{InstanceId, SignalId};
use glam::Vec2;
use std::collections::BTreeMap;

/// The lanes of a map, by index, and how large those who move on them are.
#[derive(Debug, Clone, Default)]
pub struct RoadFacts {
    /// All lanes.
    pub lanes: Vec<LaneFacts>,
    /// Half length and half width of everybody who moves, metres; those without are left out of conflicts.
    pub half_sizes: BTreeMap<InstanceId, Vec2>,
}

/// One lane.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LaneFacts {
    /// Metres.
    pub length_m: f32,
    /// The traffic light at its end.
    pub signal: Option<SignalId>,
    /// The lanes that begin where it ends.
    pub successors: Vec<u32>,
    /// The crossings that it passes.
    pub crossings: Vec<LaneCrossing>,
}

/// A crossing on a lane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LaneCrossing {
    /// Index in the road network.
    pub crossing: u16,
    /// Where it begins and ends, metres along the lane.
    pub range_m: (f32, f32),
}

impl RoadFacts {
    /// A lane; `None` if there is none of this index.
    pub(super) fn lane(&self, index: u32) -> Option<&LaneFacts> {
        self.lanes.get(index as usize)
    }
}
