//! Roads and the links between them.

use super::lane::LaneSection;
use super::object::RoadObject;
use super::plan_view::{Crossfall, CubicPolynomial, LateralShape, PlanViewGeometry};
use super::signal::{Signal, SignalReference};

/// One end of a road or lane (OpenDRIVE's `contactPoint`).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ContactPoint {
    /// `s` is 0.
    Start,
    /// `s` is the length.
    End,
}

/// The link of a road's end.
#[derive(Debug, Clone, PartialEq)]
pub enum RoadLink {
    /// An end of another road.
    Road {
        /// Its id.
        id: String,
        /// Its contact point; by default the start of a successor and the end of a predecessor.
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
    /// Link of its start.
    pub predecessor: Option<RoadLink>,
    /// Link of its end.
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
