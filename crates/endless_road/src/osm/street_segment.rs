//! Segments of streets: their geometry and their attributes.

use super::class::RoadClass;
use super::section::CrossSection;
use glam::DVec2;

/// A vertex of a way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct WayVertex {
    /// The node's id; below `i64::MIN / 2` where a way was cut at the extract's edge.
    pub(super) node: i64,
    pub(super) at: DVec2,
}

/// On a bridge or in a tunnel, and the layer that its tags name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct StructureLevel {
    pub(super) bridge: bool,
    pub(super) tunnel: bool,
    pub(super) layer: i8,
}

/// A segment of a street between two intersections.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct StreetSegment {
    pub(super) vertices: Vec<WayVertex>,
    /// One a segment.
    pub(super) levels: Vec<StructureLevel>,
    pub(super) section: CrossSection,
    pub(super) class: RoadClass,
    pub(super) link: bool,
    pub(super) roundabout: bool,
    pub(super) speed_mps: f64,
    /// The way at its beginning and at its end.
    pub(super) ways: [i64; 2],
    /// A driveway or parking aisle: paved, but no through road.
    pub(super) yard: bool,
}

impl StreetSegment {
    pub(super) fn length(&self) -> f64 {
        self.vertices.windows(2).map(|v| v[0].at.distance(v[1].at)).sum()
    }

    pub(super) fn reversed(mut self) -> Self {
        self.vertices.reverse();
        self.levels.reverse();
        self.section = self.section.reversed();
        self.ways.reverse();
        self
    }

    pub(super) fn end_node(&self, end: usize) -> i64 {
        if end == 0 { self.vertices[0].node } else { self.vertices[self.vertices.len() - 1].node }
    }

    /// The part between two vertices, both included.
    pub(super) fn part(&self, from: usize, to: usize) -> Self {
        Self {
            vertices: self.vertices[from..=to].to_vec(),
            levels: self.levels[from..to].to_vec(),
            section: self.section.clone(),
            ..*self
        }
    }
}
