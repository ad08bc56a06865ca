//! Lane sections, lanes and their road marks.

use super::plan_view::CubicPolynomial;

/// A stretch of road with the same lanes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LaneSection {
    /// Start on the road.
    pub s: f64,
    /// Line in the file.
    pub line: usize,
    /// From the leftmost (highest id) to the rightmost, the centre (id 0) included.
    pub lanes: Vec<LaneRecord>,
}

/// One lane of a section.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LaneRecord {
    /// Positive left of the centre, negative right of it.
    pub id: i32,
    /// Line in the file.
    pub line: usize,
    /// `driving`, `sidewalk`...
    pub kind: String,
    /// Kept level by superelevation.
    pub level: bool,
    /// `direction` (1.8): traffic runs the other way than the rule says.
    pub reversed: bool,
    /// Lanes of the section or road before.
    pub predecessors: Vec<i32>,
    /// Lanes of the section or road after.
    pub successors: Vec<i32>,
    /// Widths; `s` counts from the section's start.
    pub widths: Vec<CubicPolynomial>,
    /// Borders' `t`, instead of widths.
    pub borders: Vec<CubicPolynomial>,
    /// Height above the road's surface: `s` from the section's start, inner and outer edge.
    pub heights: Vec<[f64; 3]>,
    /// Marks at its outer edge (of the centre lane: at the centre).
    pub marks: Vec<RoadMark>,
    /// Speed limits: `s` from the section's start, limit.
    pub speeds: Vec<(f64, f64)>,
    /// Surface material: `s` from the section's start, name.
    pub materials: Vec<(f64, String)>,
}

/// A mark along a lane's edge from a place on.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RoadMark {
    /// From here on, counted from the section's start.
    pub s: f64,
    /// `solid`, `broken`, `solid solid`, `curb`...
    pub kind: String,
    /// `standard`, `white`, `yellow`...
    pub color: String,
    /// `standard` or `bold`.
    pub bold: bool,
    /// Width of one line, where the file says so.
    pub width: Option<f64>,
    /// Lane changes that it allows: `none`, `both`, `increase`, `decrease`.
    pub lane_change: Option<String>,
    /// Lines in detail, where the file gives them.
    pub lines: Vec<MarkLine>,
}

/// One line of a mark.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarkLine {
    /// Length of paint.
    pub length: f64,
    /// Gap after it; 0 is unbroken.
    pub space: f64,
    /// Painted once, not again and again.
    pub once: bool,
    /// From the lane's edge, positive to the left.
    pub t_offset: f64,
    /// Its start, from the mark's `s`.
    pub s_offset: f64,
    /// Width, where the file says so.
    pub width: Option<f64>,
}
