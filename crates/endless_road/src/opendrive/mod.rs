//! ASAM OpenDRIVE 1.4 to 1.8: reading files into a [`RoadMap`](crate::RoadMap), and writing one.
//!
//! [`OpenDriveDocument::parse`] reads the file as it is written; `geometry` evaluates its curves and profiles; `to_map` makes
//! lanes, junctions, signals, crossings and sidewalks of it. What is not understood becomes a note with its line.
//! Which elements are read is listed in `docs/opendrive.md`.

mod document;
mod error;
mod geometry;
mod parse;
mod schema;
mod to_map;
mod write;
mod xml;

pub use document::{
    ContactPoint, Crossfall, CubicPolynomial, GeometryType, JunctionConnection, JunctionRecord, JunctionType,
    LaneRecord, LaneSection, LateralShape, MarkLine, ObjectRepeat, OpenDriveDocument, OutlineCorner, PlanViewGeometry,
    Road, RoadLink, RoadMark, RoadObject, RoadType, Signal, SignalController, SignalOrientation, SignalPosition,
    SignalReference,
};
pub use error::OpenDriveError;
pub use to_map::read;
pub use write::{LaneName, lane_names, write};
