//! What is painted on a town's streets, and where people walk: what labels tell of, as it lies in the town's meshes.

use endless_road::{CrossingId, LaneId, MarkingColor};
use glam::DVec3;

/// Paint and sidewalks of a town.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StreetFeatures {
    /// Painted lines along roads.
    pub marks: Vec<PaintedMark>,
    /// Lines to stop or to give way at.
    pub stop_lines: Vec<PaintedStopLine>,
    /// Crossings.
    pub crosswalks: Vec<PaintedCrosswalk>,
    /// Sidewalks.
    pub sidewalks: Vec<SidewalkStrip>,
    /// Traffic keeps to the left.
    pub left_hand: bool,
}

/// A painted line along a road.
#[derive(Debug, Clone, PartialEq)]
pub struct PaintedMark {
    /// The middle of each unbroken piece of paint.
    pub pieces: Vec<Vec<DVec3>>,
    /// Whether it has gaps.
    pub broken: bool,
    /// Metres.
    pub width_m: f64,
    /// Colour.
    pub color: MarkingColor,
}

/// A line across lanes.
#[derive(Debug, Clone, PartialEq)]
pub struct PaintedStopLine {
    /// The middle of each unbroken piece of paint.
    pub pieces: Vec<Vec<DVec3>>,
    /// Whether it has gaps: the line of a give-way sign.
    pub broken: bool,
    /// Metres along the road.
    pub width_m: f64,
    /// The lanes that end there.
    pub lanes: Vec<LaneId>,
}

/// The bars of a crossing.
#[derive(Debug, Clone, PartialEq)]
pub struct PaintedCrosswalk {
    /// The crossing.
    pub crossing: CrossingId,
    /// Around its bars.
    pub outline: Vec<DVec3>,
}

/// A sidewalk between its borders.
#[derive(Debug, Clone, PartialEq)]
pub struct SidewalkStrip {
    /// Its left border, seen in the direction of its points.
    pub left: Vec<DVec3>,
    /// Its right border; as many points.
    pub right: Vec<DVec3>,
}
