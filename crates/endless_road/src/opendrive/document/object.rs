//! Objects on and beside roads.

/// Corners of an object.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OutlineCorner {
    /// On the road: `s`, `t`, height above the reference plane.
    Road([f64; 3]),
    /// From the object's place: along it, to its left, up.
    Local([f64; 3]),
}

/// An object on or beside the road.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RoadObject {
    /// Id.
    pub id: String,
    /// Line in the file.
    pub line: usize,
    /// Name, may be empty.
    pub name: String,
    /// `crosswalk`, `parkingSpace`, `tree`, `pole`...
    pub kind: String,
    /// Subtype, may be empty.
    pub subtype: String,
    /// Place along the road.
    pub s: f64,
    /// Place across it.
    pub t: f64,
    /// Height above the road.
    pub z_offset: f64,
    /// Turn from the direction of the road.
    pub heading: f64,
    /// Size along, across, upwards; 0 where not given.
    pub size: [f64; 3],
    /// Radius, 0 where not given.
    pub radius: f64,
    /// Outlines.
    pub outlines: Vec<Vec<OutlineCorner>>,
    /// Repetitions of it along the road.
    pub repeats: Vec<ObjectRepeat>,
}

/// An object repeated along the road.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ObjectRepeat {
    /// The first one.
    pub s: f64,
    /// Length of the range along the road.
    pub length: f64,
    /// From one to the next; 0 is without a gap.
    pub distance: f64,
    /// `t` of the first and the last.
    pub t: [f64; 2],
    /// Height above the road of the first and the last.
    pub z_offset: [f64; 2],
}
