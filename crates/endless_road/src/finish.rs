//! Finishes a generated network: derives predecessors, conflicts and spawn points, and checks it.

use crate::{JunctionId, LaneId, NetworkError, RoadNetwork, TrafficControl, WalkEdgeId, WalkKind};
use crate::{conflict, cut, spawn};
use endless_world::SignalId;
use endless_world::math::f64::wrap_angle;

/// Ends that should meet may be this far apart, metres.
const MOST_GAP_M: f64 = 0.05;
/// Lanes that follow one another may differ in direction by this, degrees (chords of a tight curve do).
const MOST_KINK_DEG: f64 = 8.0;

impl RoadNetwork {
    /// Checks the network and derives predecessors, the crossings' cuts, the junctions' conflicts and spawn points.
    ///
    /// # Errors
    /// The first inconsistency found, with the lane, crossing or edge that has it.
    pub fn finish(mut self) -> Result<Self, NetworkError> {
        self.check_lanes()?;
        self.check_junctions()?;
        self.check_walk()?;
        self.derive_predecessors();
        self.check_joints()?;
        cut::derive(&mut self)?;
        conflict::derive(&mut self);
        spawn::derive(&mut self);
        Ok(self)
    }

    fn check_lanes(&self) -> Result<(), NetworkError> {
        for (place, lane) in self.lanes.iter().enumerate() {
            if lane.id.index() != place {
                return Err(NetworkError::LaneId { place, id: lane.id });
            }
            for &named in lane.successors.iter().chain(&lane.left).chain(&lane.right) {
                if named.index() >= self.lanes.len() {
                    return Err(NetworkError::UnknownLane { lane: lane.id, named });
                }
            }
            for (what, value) in [("width", lane.width_m), ("speed limit", lane.speed_limit_mps)] {
                if !(value.is_finite() && value > 0.0) {
                    return Err(NetworkError::NotPositive { lane: lane.id, what, value });
                }
            }
            if let Some(junction) = lane.junction
                && !self.junctions.get(junction.index()).is_some_and(|j| j.lanes.contains(&lane.id))
            {
                return Err(NetworkError::Membership { lane: lane.id, junction });
            }
            if let TrafficControl::Signal(signal) = lane.end_control {
                self.check_signal(signal, || format!("lane {:?}", lane.id))?;
            }
        }
        Ok(())
    }

    fn check_junctions(&self) -> Result<(), NetworkError> {
        for (place, junction) in self.junctions.iter().enumerate() {
            let id = JunctionId(place as u16);
            for &lane in &junction.lanes {
                if self.lanes.get(lane.index()).is_none_or(|l| l.junction != Some(id)) {
                    return Err(NetworkError::Membership { lane, junction: id });
                }
            }
            let Some(program) = &junction.program else { continue };
            if program.phases.is_empty() || program.phases.iter().any(|p| p.duration_s.is_nan() || p.duration_s <= 0.0)
            {
                return Err(NetworkError::Program { junction: id });
            }
            for &(signal, _) in program.phases.iter().flat_map(|p| &p.aspects) {
                self.check_signal(signal, || format!("junction {id:?}"))?;
            }
        }
        for (place, crossing) in self.crossings.iter().enumerate() {
            if let Some(signal) = crossing.signal {
                self.check_signal(signal, || format!("crossing {place}"))?;
            }
        }
        Ok(())
    }

    fn check_signal(&self, signal: SignalId, user: impl FnOnce() -> String) -> Result<(), NetworkError> {
        if signal.0 < self.signal_groups {
            return Ok(());
        }
        Err(NetworkError::UnknownSignal { user: user(), signal, groups: self.signal_groups })
    }

    fn check_walk(&self) -> Result<(), NetworkError> {
        for (place, edge) in self.walk.edges.iter().enumerate() {
            let [a, b] = edge.nodes;
            let nodes = self.walk.nodes.len();
            let crossing_exists = match edge.kind {
                WalkKind::Sidewalk => true,
                WalkKind::Crossing(crossing) => crossing.index() < self.crossings.len(),
            };
            if a == b || a.index() >= nodes || b.index() >= nodes || !crossing_exists {
                return Err(NetworkError::WalkEdge { edge: WalkEdgeId(place as u32) });
            }
        }
        Ok(())
    }

    fn derive_predecessors(&mut self) {
        let mut predecessors: Vec<Vec<LaneId>> = vec![Vec::new(); self.lanes.len()];
        for lane in &self.lanes {
            for successor in &lane.successors {
                predecessors[successor.index()].push(lane.id);
            }
        }
        for (lane, mut before) in self.lanes.iter_mut().zip(predecessors) {
            before.dedup();
            lane.predecessors = before;
        }
    }

    fn check_joints(&self) -> Result<(), NetworkError> {
        for lane in &self.lanes {
            let end = lane.centerline.at(lane.centerline.length());
            for &successor in &lane.successors {
                let start = self.lane(successor).centerline.at(0.0);
                let gap_m = end.position.distance(start.position);
                if gap_m > MOST_GAP_M {
                    return Err(NetworkError::Gap { lane: lane.id, successor, gap_m, most_m: MOST_GAP_M });
                }
                let angle_deg = wrap_angle(start.heading_rad - end.heading_rad).abs().to_degrees();
                if angle_deg > MOST_KINK_DEG {
                    return Err(NetworkError::Kink { lane: lane.id, successor, angle_deg, most_deg: MOST_KINK_DEG });
                }
            }
        }
        Ok(())
    }
}
