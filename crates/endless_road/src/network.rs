//! The network's data.

use crate::Polyline;
use endless_world::{SignalAspect, SignalId};
use glam::DVec3;

macro_rules! index_ids {
    ($($(#[$doc:meta])* $name:ident($int:ty);)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(pub $int);
        impl $name {
            /// As an index.
            pub const fn index(self) -> usize { self.0 as usize }
        }
    )*};
}

index_ids! {
    /// Index into [`RoadNetwork::lanes`].
    LaneId(u32);
    /// Index into [`RoadNetwork::junctions`].
    JunctionId(u16);
    /// Index into [`RoadNetwork::crossings`].
    CrossingId(u16);
    /// Index into [`WalkNetwork::nodes`].
    WalkNodeId(u32);
    /// Index into [`WalkNetwork::edges`].
    WalkEdgeId(u32);
}

/// The turn that a lane makes inside a junction, seen from the driver.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Turn {
    /// Straight on, and every lane outside junctions.
    Straight,
    /// To the left.
    Left,
    /// To the right.
    Right,
    /// Back.
    UTurn,
}

/// The traffic control at a lane's end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TrafficControl {
    /// None: the lane goes on.
    Free,
    /// A traffic light.
    Signal(SignalId),
    /// A stop sign.
    Stop,
    /// A give-way sign.
    Yield,
}

/// One lane for driving. Lanes inside junctions (connectors) are lanes too.
#[derive(Debug, Clone, PartialEq)]
pub struct Lane {
    /// Its own index.
    pub id: LaneId,
    /// Centre line in the direction of travel, on the road surface.
    pub centerline: Polyline,
    /// Metres.
    pub width_m: f64,
    /// m/s.
    pub speed_limit_mps: f64,
    /// The lanes that begin where this one ends.
    pub successors: Vec<LaneId>,
    /// The lanes that end where this one begins. Derived by `finish`.
    pub predecessors: Vec<LaneId>,
    /// The neighbour to the left with the same direction of travel, if lane changes are allowed.
    pub left: Option<LaneId>,
    /// The neighbour to the right with the same direction of travel.
    pub right: Option<LaneId>,
    /// The junction this lane lies in.
    pub junction: Option<JunctionId>,
    /// Its turn.
    pub turn: Turn,
    /// Traffic control at its end, where the stop line is.
    pub end_control: TrafficControl,
}

impl Lane {
    /// A lane outside junctions with no lanes before, after or beside it, whose end nothing governs.
    pub fn new(id: LaneId, centerline: Polyline, width_m: f64, speed_limit_mps: f64) -> Self {
        Self {
            id,
            centerline,
            width_m,
            speed_limit_mps,
            successors: Vec::new(),
            predecessors: Vec::new(),
            left: None,
            right: None,
            junction: None,
            turn: Turn::Straight,
            end_control: TrafficControl::Free,
        }
    }
}

/// Two junction lanes whose swept areas overlap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LaneConflict {
    /// The lane this is seen from.
    pub lane: LaneId,
    /// The other lane.
    pub other: LaneId,
    /// Range of `s` on `lane` inside the overlap.
    pub range: (f64, f64),
    /// Range of `s` on `other`.
    pub other_range: (f64, f64),
    /// Whether traffic on `lane` must let traffic on `other` go first when both may move.
    pub gives_way: bool,
}

/// A junction: lanes that meet, with their conflicts and signals.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Junction {
    /// Lanes inside.
    pub lanes: Vec<LaneId>,
    /// Traffic-light program, if signalised.
    pub program: Option<SignalProgram>,
    /// Every conflict, once from each side. Derived by `finish`.
    pub conflicts: Vec<LaneConflict>,
}

/// One step of a program.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalPhase {
    /// Seconds.
    pub duration_s: f64,
    /// Aspect of each signal group of this junction.
    pub aspects: Vec<(SignalId, SignalAspect)>,
}

/// Phases shown in turn, for ever.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalProgram {
    /// In order.
    pub phases: Vec<SignalPhase>,
    /// Seconds into the cycle at scene time 0.
    pub offset_s: f64,
}

/// The range of a lane that a crossing cuts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LaneCut {
    /// The lane.
    pub lane: LaneId,
    /// Range of `s` on the lane inside the crossing.
    pub range: (f64, f64),
}

/// A pedestrian crossing.
#[derive(Debug, Clone, PartialEq)]
pub struct Crossing {
    /// Kerb to kerb, on the road surface.
    pub ends: [DVec3; 2],
    /// Metres, along the road.
    pub width_m: f64,
    /// The pedestrians' signal; without one, drivers give way.
    pub signal: Option<SignalId>,
    /// The lanes it cuts. Derived by `finish`.
    pub cuts: Vec<LaneCut>,
}

/// Kind of an edge of the walk network.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum WalkKind {
    /// Sidewalk, path, plaza.
    Sidewalk,
    /// Over a road.
    Crossing(CrossingId),
}

/// A straight walkable strip between two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WalkEdge {
    /// Ends.
    pub nodes: [WalkNodeId; 2],
    /// Usable width, metres: people stay within ± half of it.
    pub width_m: f64,
    /// Its kind.
    pub kind: WalkKind,
}

/// The network of sidewalks and crossings.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct WalkNetwork {
    /// On the walking surface (sidewalk height; crossings end on the sidewalk).
    pub nodes: Vec<DVec3>,
    /// Undirected.
    pub edges: Vec<WalkEdge>,
}

/// A place where a vehicle may appear: middle of the lane, clear of junctions and crossings, and not where it would be
/// trapped: most lanes around can be reached from there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpawnPoint {
    /// Lane.
    pub lane: LaneId,
    /// Arc length, metres.
    pub s: f64,
}

/// The whole network of a map.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RoadNetwork {
    /// All lanes, by id.
    pub lanes: Vec<Lane>,
    /// All junctions, by id.
    pub junctions: Vec<Junction>,
    /// All crossings, by id.
    pub crossings: Vec<Crossing>,
    /// Sidewalks.
    pub walk: WalkNetwork,
    /// Number of signal groups; ids are `0..signal_groups`.
    pub signal_groups: u16,
    /// Derived by `finish`, at least 8 m apart on a lane.
    pub spawn_points: Vec<SpawnPoint>,
}

impl RoadNetwork {
    /// The lane with this id.
    pub fn lane(&self, id: LaneId) -> &Lane {
        &self.lanes[id.index()]
    }
}
