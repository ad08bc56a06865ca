//! An OpenDRIVE file as it is written: plain data, nothing evaluated. Units: metres, radians, metres a second.
//!
//! ASAM OpenDRIVE 1.4 to 1.8; names follow the standard. Ids of roads, junctions, signals and controllers are text.

mod junction;
mod lane;
mod object;
mod plan_view;
mod road;
mod signal;

pub use junction::{JunctionConnection, JunctionRecord, JunctionType};
pub use lane::{LaneRecord, LaneSection, MarkLine, RoadMark};
pub use object::{ObjectRepeat, OutlineCorner, RoadObject};
pub use plan_view::{Crossfall, CubicPolynomial, GeometryType, LateralShape, PlanViewGeometry};
pub use road::{ContactPoint, Road, RoadLink, RoadType};
pub use signal::{Signal, SignalController, SignalOrientation, SignalPosition, SignalReference};

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
    /// Notes on what was not understood, repaired or left out.
    pub notes: Vec<ImportNote>,
    /// Whole roads that were left out because nobody could drive on them, and why.
    pub roads_left_out: Vec<ImportNote>,
}
