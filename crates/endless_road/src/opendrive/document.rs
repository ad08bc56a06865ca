//! An OpenDRIVE file as it is written: plain data, nothing evaluated. Units: metres, radians, metres a second.
//!
//! ASAM OpenDRIVE 1.4 to 1.8; names follow the standard. Ids of roads, junctions, signals and controllers are text.

use crate::ImportNote;

/// A whole file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OpenDriveDocument {
    /// Major and minor revision.
    pub revision: (u32, u32),
    /// The header's name.
    pub name: String,
    /// PROJ string.
    pub georeference: Option<String>,
    /// Lanes end where traffic waits, before crossings: files that we write say so in the header's `userData`.
    pub lanes_end_at_stops: bool,
    /// All roads, in the order of the file.
    pub roads: Vec<Road>,
    /// All junctions.
    pub junctions: Vec<JunctionRecord>,
    /// All controllers.
    pub controllers: Vec<SignalController>,
    /// What was not understood, mended or left out.
    pub notes: Vec<ImportNote>,
    /// Whole roads that were left out because nobody could drive on them, and why.
    pub roads_left_out: Vec<ImportNote>,
}

/// A cubic polynomial `a + b ds + c ds² + d ds³` of the distance `ds` from `s`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CubicPolynomial {
    /// Where it begins.
    pub s: f64,
    /// Coefficients.
    pub abcd: [f64; 4],
}

/// One end of a road or lane (OpenDRIVE's `contactPoint`).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ContactPoint {
    /// Where `s` is 0.
    Start,
    /// Where `s` is the length.
    End,
}

/// What a road's end is joined to.
#[derive(Debug, Clone, PartialEq)]
pub enum RoadLink {
    /// An end of another road.
    Road {
        /// Its id.
        id: String,
        /// Which end; where the file does not say, the start of a successor and the end of a predecessor.
        contact: ContactPoint,
    },
    /// A junction.
    Junction {
        /// Its id.
        id: String,
    },
}

/// One road.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Road {
    /// Id.
    pub id: String,
    /// Line in the file.
    pub line: usize,
    /// Name, may be empty.
    pub name: String,
    /// Length of the reference line.
    pub length: f64,
    /// The junction it lies in, if it is a connecting road.
    pub junction: Option<String>,
    /// Traffic keeps to the left.
    pub left_hand: bool,
    /// What its start is joined to.
    pub predecessor: Option<RoadLink>,
    /// What its end is joined to.
    pub successor: Option<RoadLink>,
    /// Type of road (`town`, `motorway`...) and speed limit from each `s` on.
    pub types: Vec<RoadType>,
    /// The reference line, in order of `s`.
    pub plan_view: Vec<PlanViewGeometry>,
    /// Height of the reference line.
    pub elevation: Vec<CubicPolynomial>,
    /// Roll about the reference line, radians.
    pub superelevation: Vec<CubicPolynomial>,
    /// Height of the surface above that plane, by `s` and `t`.
    pub shapes: Vec<LateralShape>,
    /// Fall of the surface away from the reference line, radians, in order of `s`.
    pub crossfalls: Vec<Crossfall>,
    /// Shift of the lanes' centre.
    pub lane_offset: Vec<CubicPolynomial>,
    /// In order of `s`; at least one.
    pub sections: Vec<LaneSection>,
    /// Signals that stand here.
    pub signals: Vec<Signal>,
    /// Signals that stand elsewhere and are valid here.
    pub signal_references: Vec<SignalReference>,
    /// Objects.
    pub objects: Vec<RoadObject>,
    /// Ranges of `s` on bridges.
    pub bridges: Vec<(f64, f64)>,
}

/// Fall of one side or both from a place on (1.4 and 1.5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossfall {
    /// For the left side, and for the right side.
    pub sides: [bool; 2],
    /// Angle, positive downwards to the outside.
    pub angle: CubicPolynomial,
}

/// The type of a road from a place on.
#[derive(Debug, Clone, PartialEq)]
pub struct RoadType {
    /// From here on.
    pub s: f64,
    /// `town`, `rural`, `motorway`...
    pub kind: String,
    /// Speed limit, if it states one.
    pub speed: Option<f64>,
}

/// A segment of the reference line (OpenDRIVE's `geometry`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanViewGeometry {
    /// Where it begins on the road.
    pub s: f64,
    /// Where it begins in the world.
    pub x: f64,
    /// Where it begins in the world.
    pub y: f64,
    /// Direction at its beginning.
    pub heading: f64,
    /// Length.
    pub length: f64,
    /// Its curve.
    pub shape: GeometryType,
}

/// The curve of one segment of the reference line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GeometryType {
    /// Straight.
    Line,
    /// Constant curvature, 1/m, positive to the left.
    Arc(f64),
    /// Curvature that changes linearly from the first to the second value.
    Spiral(f64, f64),
    /// `v(u) = a + b u + c u² + d u³`.
    Poly3([f64; 4]),
    /// `u(p)` and `v(p)`; `p` runs to 1 if normalised, to the length otherwise.
    ParamPoly3 {
        /// Coefficients of `u`.
        u: [f64; 4],
        /// Coefficients of `v`.
        v: [f64; 4],
        /// `pRange="normalized"`.
        normalized: bool,
    },
}

/// Height across the road at one `s`, cubic in `t` (OpenDRIVE's `lateralProfile/shape`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LateralShape {
    /// Where on the road.
    pub s: f64,
    /// Where it begins across the road.
    pub t: f64,
    /// Coefficients in `t − self.t`.
    pub abcd: [f64; 4],
}

/// A stretch of road with the same lanes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LaneSection {
    /// Where it begins.
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
    /// What the surface is made of: `s` from the section's start, name.
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
    /// Which lane changes it allows: `none`, `both`, `increase`, `decrease`.
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
    /// Where it begins, from the mark's `s`.
    pub s_offset: f64,
    /// Width, where the file says so.
    pub width: Option<f64>,
}

/// The direction of traffic that a signal is for (OpenDRIVE's `orientation`).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SignalOrientation {
    /// Traffic in the direction of `s`.
    Along,
    /// Traffic against it.
    Against,
    /// Both.
    Both,
}

/// A signal or sign.
#[derive(Debug, Clone, PartialEq)]
pub struct Signal {
    /// Id.
    pub id: String,
    /// Line in the file.
    pub line: usize,
    /// Name, may be empty.
    pub name: String,
    /// Place along the road.
    pub s: f64,
    /// Place across it.
    pub t: f64,
    /// Height above the road.
    pub z_offset: f64,
    /// Turn from the direction of the road.
    pub h_offset: f64,
    /// For whom.
    pub orientation: SignalOrientation,
    /// Whether it changes.
    pub dynamic: bool,
    /// Country, may be empty.
    pub country: String,
    /// Code of its type.
    pub kind: String,
    /// Code of its subtype.
    pub subtype: String,
    /// Value, such as a speed.
    pub value: Option<f64>,
    /// Unit of the value.
    pub unit: String,
    /// Text on it.
    pub text: String,
    /// Ranges of lanes it is valid for; none given is all.
    pub validity: Vec<(i32, i32)>,
    /// Where it really stands, if not where it counts.
    pub position: Option<SignalPosition>,
}

/// Where a signal really stands.
#[derive(Debug, Clone, PartialEq)]
pub enum SignalPosition {
    /// In the world: x, y, z.
    Inertial([f64; 3]),
    /// On another road: its id, `s`, `t`.
    Road(String, [f64; 2]),
}

/// A signal that stands elsewhere.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalReference {
    /// The signal's id.
    pub id: String,
    /// Place along the road.
    pub s: f64,
    /// For whom.
    pub orientation: SignalOrientation,
    /// Ranges of lanes it is valid for; none given is all.
    pub validity: Vec<(i32, i32)>,
}

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
    /// How far they go.
    pub length: f64,
    /// From one to the next; 0 is without a gap.
    pub distance: f64,
    /// `t` of the first and the last.
    pub t: [f64; 2],
    /// Height above the road of the first and the last.
    pub z_offset: [f64; 2],
}

/// How a junction joins roads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum JunctionType {
    /// By connecting roads.
    #[default]
    Default,
    /// Road to road, such as motorway exits.
    Direct,
    /// A place beside a road that goes on.
    Virtual,
    /// Where roads or rails cross without turning.
    Crossing,
}

/// A junction.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct JunctionRecord {
    /// Id.
    pub id: String,
    /// Line in the file.
    pub line: usize,
    /// Name, may be empty.
    pub name: String,
    /// How it joins.
    pub kind: JunctionType,
    /// Paths through it.
    pub connections: Vec<JunctionConnection>,
    /// Road of higher and road of lower priority.
    pub priorities: Vec<(String, String)>,
    /// Controllers used here, with their place in the sequence.
    pub controllers: Vec<(String, u32)>,
}

/// A path through a junction (OpenDRIVE's `connection`).
#[derive(Debug, Clone, PartialEq)]
pub struct JunctionConnection {
    /// Line in the file.
    pub line: usize,
    /// The road that leads in.
    pub incoming: String,
    /// The road that leads on: the connecting road, or in a direct junction the linked road.
    pub connecting: String,
    /// The end of that road where it is entered.
    pub contact: ContactPoint,
    /// Lanes of the incoming and the connecting road.
    pub lane_links: Vec<(i32, i32)>,
}

/// Signals that are switched together (OpenDRIVE's `controller`).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SignalController {
    /// Id.
    pub id: String,
    /// Name, may be empty.
    pub name: String,
    /// Place in the sequence.
    pub sequence: Option<u32>,
    /// Ids of the signals.
    pub signals: Vec<String>,
}
